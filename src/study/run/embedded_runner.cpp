// The root tells the other ranks by JSON text what comes next: {"evaluate": design, "directory": ...},
// {"end": outcome} or {"error": message, "input": bool}.
#include <chrono>

#include "base/errors.h"
#include "study/run/crash_mark.h"
#include "study/run/failure.h"
#include "study/run/runner.h"
#include "study/store/design_files.h"

namespace icebow {
namespace {

using Clock = std::chrono::steady_clock;

void tell(const Communicator& comm, const Json& order) {
  if (comm.size() > 1) comm.broadcast(json_text(order));
}

// The evaluator, with an exception of any rank turned into one of all ranks: nobody is left waiting. (Inside
// the evaluator that is its own duty.)
Evaluation evaluate_together(const Communicator& comm, const EvaluateFunction& evaluate, const Design& design,
                             const EvaluateOptions& options) {
  Evaluation result;
  std::string error;
  const CrashMark mark(options.directory + "/" + crash_mark_name);
  try {
    result = evaluate(comm, design, options);
  } catch (const std::exception& e) {
    error = std::string("evaluating ") + design.name + ": " + e.what();
  }
  if (!comm.any(!error.empty())) return result;
  throw RuntimeError(error.empty() ? "evaluating " + design.name + " failed on another rank" : error);
}

Json outcome_json(const StudyOutcome& o) {
  return {{"ok", o.ok},
          {"infeasible", o.infeasible},
          {"failed", o.failed},
          {"recalled", o.recalled},
          {"interrupted", o.interrupted},
          {"best", o.best},
          {"nothing_feasible", o.nothing_feasible},
          {"notes", o.notes}};
}

StudyOutcome outcome_from(const Json& json) {
  StudyOutcome o;
  o.ok = json.at("ok");
  o.infeasible = json.at("infeasible");
  o.failed = json.at("failed");
  o.recalled = json.at("recalled");
  o.interrupted = json.at("interrupted");
  o.best = json.at("best");
  o.nothing_feasible = json.at("nothing_feasible");
  o.notes = json.at("notes").get<std::vector<std::string>>();
  return o;
}

class EmbeddedRunner : public Runner {
 public:
  EmbeddedRunner(const Communicator& comm, const RunnerContext& context) : comm_(comm), context_(context) {}

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
    if (e.status == EvaluationStatus::running && timed_out) {
      e.status = EvaluationStatus::failed;
      e.reason = time_limit_reason(limit);
      e.result["failure"] = time_limit_failure(limit);
    }
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
    if (order.contains("end")) return outcome_from(order.at("end"));
    if (order.contains("error")) {
      const std::string message = order.at("error");
      if (order.at("input").get<bool>()) throw InputError(message);
      throw RuntimeError(message);
    }
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
  tell(comm, {{"end", outcome_json(outcome)}});
}

void fail_embedded(const Communicator& comm, const std::exception& error) {
  const bool input = dynamic_cast<const InputError*>(&error) != nullptr;
  tell(comm, {{"error", error.what()}, {"input", input}});
}

}  // namespace icebow
