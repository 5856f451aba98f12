// The study's answer in plain sentences.
#pragma once

#include <string>
#include <vector>

#include "reports/content/study_results.h"

namespace icebow {

struct Verdict {
  bool ranks = false;                // false: the records are too short for an order
  std::string headline;              // one sentence: who has the lowest load, and how much below the baseline
  std::string next;                  // what to do now; empty where nothing follows
  std::vector<std::string> remarks;  // what to know before the numbers are used
};

// Plain text: escape it before it goes into HTML or Markdown.
Verdict verdict(const StudyResults& study);

// "This study does not rank these bows: ..., and what would do; empty where the records carry an order.
std::string order_in_words(const StudyResults& study);

// "0.81 ± 0.06 MN" of the ranked value, with the decimals its interval can bear.
std::string value_in_words(const RankedDesign& row, const Ranking& ranking);
// "17 % below the baseline, p = 0.02"; of `row` against the design called baseline, or against the best one
// where there is none or `row` is the baseline. Empty where there is nothing to compare with.
std::string versus_in_words(const RankedDesign& row, const StudyResults& study);

}  // namespace icebow
