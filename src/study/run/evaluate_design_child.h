// What an isolated run of a study starts for each design.
#pragma once

#include <string>
#include <vector>

#include "base/communicator.h"
#include "study/run/run_settings.h"

namespace icebow {

// The hidden command `icebow evaluate-design --design-json FILE --out DIR --result FILE`: what an isolated
// run starts for each design, under mpirun or not. `arguments` are those after the command's name. Progress
// goes to stdout as lines of JSON. Collective; returns the exit code. An empty `evaluator` is
// icebow::evaluate.
int evaluate_design_child(const Communicator& comm, const std::vector<std::string>& arguments,
                          const EvaluateFunction& evaluator = nullptr);

}  // namespace icebow
