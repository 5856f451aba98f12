// A study file, from its text to a StudySpec.
#pragma once

#include <string>

#include "base/json.h"
#include "study/spec/study_spec.h"

namespace icebow {

// Throw InputError with every mistake in the file, each by JSON pointer.
StudySpec read_study(const std::string& path);
StudySpec read_study(const Json& document, const std::string& name);
// "/bow/stem_deg=20": the value is JSON (a bare word is taken as a string). Throws InputError.
void apply_set(Json& document, const std::string& assignment);

}  // namespace icebow
