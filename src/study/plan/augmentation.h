// A Latin hypercube that grows: points that were paid for stay, new ones are added.
#pragma once

#include <string>

#include "study/spec/study_spec.h"

namespace icebow {

// `before` is the document that a study directory was last run with. Where it describes the same hypercube
// with fewer samples, or with an "extends" of its own, the study gets "extends": the earlier numbers of
// samples. A study that says "extends" itself is left as it is.
StudySpec continued_from(StudySpec spec, const Json& before);

// What to tell of it; empty where `spec` extends nothing that was not in the study file.
std::string words_on_extension(const StudySpec& given, const StudySpec& continued);

}  // namespace icebow
