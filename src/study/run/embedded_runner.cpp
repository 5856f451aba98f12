// The root tells the other ranks by JSON text what comes next: {"evaluate": design, "directory": ...},
// {"end": outcome} or {"error": message, "input": bool}.
#include <chrono>

#include "base/errors.h"
#include "study/run/runner.h"
#include "study/run/together.h"
#include "study/store/design_files.h"

namespace icebow {
namespace {

using Clock = std::chrono::steady_clock;

void tell(const Communicator& comm, const Json& order) {
  if (comm.size() > 1) comm.broadcast(json_text(order));
}

class EmbeddedRunner : public Runner {
 public:
  EmbeddedRunner(const Communicator& comm, const RunnerContext& context) : comm_(comm), context_(context) {}

  int at_once() const override { return 1; }
  bool has_room() const override { return queue_.empty(); }
  bool busy() const override { return !queue_.empty(); }
  void start(const PlannedDesign& planned) override { queue_.push_back(planned.design); }
  void stop() override { queue_.clear(); }

  std::vector<Evaluation> wait() override {
    if (queue_.empty()) return {};
    const Design design = queue_.back();
    queue_.pop_back();
    const std::string directory = design.asked.formula_alone()
                                      ? std::string()
                                      : design_directory(context_.settings.directory, design.name);
    tell(comm_, {{"evaluate", to_json(design)}, {"directory", directory}});
    return {evaluated(design, directory)};
  }

 private:
  Evaluation evaluated(const Design& design, const std::string& directory) {
    const auto begin = Clock::now();
    const double limit = context_.spec.execution.time_limit_s;
    bool timed_out = false;
    EvaluateOptions options;
    options.directory = directory;
    options.keep_checkpoint = true;  // until the loop has stored the result
    options.on_progress = [&](const Progress& p) { context_.on_progress(design.name, p); };
    options.stop = [&] {
      const double seconds = std::chrono::duration<double>(Clock::now() - begin).count();
      timed_out = timed_out || (limit > 0.0 && seconds > limit);
      return timed_out || (context_.settings.stop && context_.settings.stop());
    };
    options.checkpoint_now = context_.settings.checkpoint_now;
    Evaluation e = evaluate_together(comm_, context_.settings.evaluate, design, options);
    if (timed_out) fail_by_time_limit(e, limit);
    return e;
  }

  const Communicator& comm_;
  RunnerContext context_;
  std::vector<Design> queue_;  // one at most
};

}  // namespace

std::unique_ptr<Runner> make_embedded_runner(const Communicator& comm, const RunnerContext& context) {
  return std::make_unique<EmbeddedRunner>(comm, context);
}

StudyOutcome serve_embedded(const Communicator& comm, const EvaluateFunction& evaluate) {
  for (;;) {
    const Json order = Json::parse(comm.broadcast(std::string()));
    if (is_end(order)) return take_end(order);
    EvaluateOptions options;
    options.directory = order.at("directory").get<std::string>();
    options.keep_checkpoint = true;
    try {
      evaluate_together(comm, evaluate, design_from_json(order.at("evaluate")), options);
    } catch (const RuntimeError&) {  // the root has thrown as well: its message comes next
    }
  }
}

void end_embedded(const Communicator& comm, const StudyOutcome& outcome) {
  tell(comm, end_order(outcome));
}

void fail_embedded(const Communicator& comm, const std::exception& error) {
  tell(comm, error_order(error));
}

}  // namespace icebow
