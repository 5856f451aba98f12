// Who evaluates designs for the loop of a study: child processes, or the ranks of this one.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "study/plan/design_space.h"
#include "study/run/run_settings.h"

namespace icebow {

// Called on the root rank only.
class Runner {
 public:
  virtual ~Runner() = default;

  virtual int at_once() const = 0;    // designs that run side by side
  virtual bool has_room() const = 0;  // for one more design at once
  virtual bool busy() const = 0;      // designs are started and not handed back yet
  virtual void start(const PlannedDesign& planned) = 0;
  // Waits a moment, hands back what has ended. Status running: the design was interrupted. Throws
  // RuntimeError where the machine, not the design, is at fault.
  virtual std::vector<Evaluation> wait() = 0;
  // Ends what is running; its designs are not handed back.
  virtual void stop() = 0;
};

struct RunnerContext {
  const StudySpec& spec;
  const RunSettings& settings;  // evaluate, margins and program are filled in
  std::function<void(const std::string& design, const Progress&)> on_progress;
};

std::unique_ptr<Runner> make_isolated_runner(const RunnerContext& context);

// All ranks of `comm` evaluate each design together. Every other rank calls serve_embedded, which returns
// with the outcome that the root gives to end_embedded, or throws what it gives to fail_embedded.
std::unique_ptr<Runner> make_embedded_runner(const Communicator& comm, const RunnerContext& context);
StudyOutcome serve_embedded(const Communicator& comm, const EvaluateFunction& evaluate);
void end_embedded(const Communicator& comm, const StudyOutcome& outcome);
void fail_embedded(const Communicator& comm, const std::exception& error);

}  // namespace icebow
