// One variable of a method: a JSON pointer into the study file and its range.
#pragma once

#include "study/spec/spec_section.h"
#include "study/spec/study_spec.h"

namespace icebow {

// What a method's type allows.
struct MethodInfo {
  const char* name;
  MethodType type;
  std::vector<std::string> keys;           // of "method" besides type
  std::vector<std::string> variable_keys;  // of each variable
};

bool is_one_of(const std::vector<std::string>& words, const std::string& word);

// Notes its mistakes: a pointer that names no number of this file, a range outside what the key allows, an
// end of the range that makes a case which cannot be run.
Variable parse_variable(const Json& document, const MethodInfo& method, const std::string& pointer,
                        const Json& range, Mistakes& mistakes);

}  // namespace icebow
