// Points of a method that bows can be built at.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "study/spec/study_spec.h"

namespace icebow {

// From the unit cube to the ranges of the variables, and the listed values where a variable has some: each
// takes an equal part of its axis.
std::vector<std::vector<double>> in_units(std::vector<std::vector<double>> points,
                                          const std::vector<Variable>& variables);

// Of a sequence (Sobol', Halton) `points` become its first feasible ones, so that more points keep the fewer.
// Of a Latin hypercube each infeasible one of `points` (in the file's units) is replaced by the next feasible
// one of Sobol's sequence. `note` says how many were infeasible, and whether some stay that no replacement
// was found for after 100 tries for each point, 10,000 at least.
void replace_infeasible(const Method& method, std::vector<std::vector<double>>& points,
                        const std::function<bool(const std::vector<double>&)>& is_feasible,
                        std::string& note);

}  // namespace icebow
