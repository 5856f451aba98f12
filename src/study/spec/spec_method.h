// The part of a study file that says by what method designs are tried.
#pragma once

#include "study/spec/spec_section.h"
#include "study/spec/study_spec.h"

namespace icebow {

// The optimisers a study file can name.
struct Algorithm {
  const char* name;
  bool takes_constraints;  // keeps to the bow's feasibility by itself; others see an infeasible bow as a bad
                           // value
  bool random;             // uses the seed
  int least_variables;
  const char* meaning;
};
const std::vector<Algorithm>& algorithms();
// The one that learns from noisy loads: study/learn/learning_search.h. The others are NLopt's.
constexpr const char* learning_algorithm = "expected_improvement";
const Algorithm* find_algorithm(const std::string& name);  // null where unknown

std::string method_name(MethodType type);  // "latin_hypercube"

// Notes its mistakes; what it returns is to be used only where it added none. `document` is the whole study
// file: a variable must name one of its numbers.
Method parse_method(const Json& document, Mistakes& mistakes);

}  // namespace icebow
