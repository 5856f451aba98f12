// The study's answer in plain sentences.
#pragma once

#include <string>
#include <vector>

#include "reports/content/study_results.h"

namespace icebow {

struct Verdict {
  std::string headline;              // who has the lowest load, and who cannot be told apart from it
  std::vector<std::string> remarks;  // against the baseline, against Lindqvist, what is still missing
};

// Plain text: escape it before it goes into HTML or Markdown.
Verdict verdict(const StudyResults& study);

}  // namespace icebow
