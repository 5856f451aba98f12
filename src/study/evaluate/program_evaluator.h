// A program of the user's own as an evaluator: JSON in, JSON out. docs/study_file.md, "Programs as
// evaluators".
#pragma once

#include <functional>
#include <string>

#include "base/json.h"
#include "study/spec/study_spec.h"

namespace icebow {

// What the program reads on its stdin: ship, ice, water and speed in SI and degrees, full scale.
Json program_input(const Case& c, const std::string& design);

struct ProgramOutcome {
  Json output;              // the object that it printed; null where it failed
  std::string reason;       // then: why, in words
  bool infeasible = false;  // the program says that there is no such ship; `reason` has its words
  bool timed_out = false, interrupted = false;
};

// Runs it in `directory` (empty: where this process is), where its stderr is kept as NAME.log. Throws
// RuntimeError where it cannot be started, or is killed twice from outside (SIGKILL, as where memory is
// short): that is no design's failure.
ProgramOutcome run_program(const ProgramEvaluator& program, const Json& input, const std::string& directory,
                           const std::function<bool()>& stop);

// What a key holds of it: name and command, and of each word that names a file the bytes instead of the path.
std::string program_text(const ProgramEvaluator& program);

}  // namespace icebow
