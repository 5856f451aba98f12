// The part of a study file that says which designs are tried: evaluators, named designs, method, ranking.
#pragma once

#include "study/spec_section.h"
#include "study/study_spec.h"

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
const Algorithm* find_algorithm(const std::string& name);  // null where unknown

// Each notes its mistakes; what they return is to be used only where they added none.
std::vector<NamedDesign> parse_designs(const Json& document, Mistakes& mistakes);
// `document` is the whole study file: a variable must name one of its numbers.
Method parse_method(const Json& document, Mistakes& mistakes);
void parse_evaluators(const Json& document, StudySpec& spec, Mistakes& mistakes);

// Mistakes of the case after a change that the case before did not have.
Mistakes new_case_mistakes(const Json& before, const Json& after);

}  // namespace icebow
