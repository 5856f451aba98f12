// One design on its way through the steps of evaluate().
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "base/communicator.h"
#include "hullgen/bow/bow.h"
#include "study/evaluate/design.h"
#include "study/evaluate/evaluate_options.h"
#include "study/evaluate/evaluation.h"
#include "study/evaluate/history_csv.h"

namespace icebow {

// One design on its way to its result.
struct DesignWork {
  const Communicator& comm;
  const Design& design;
  const EvaluateOptions& options;
  Json result;  // so far
  Hull hull;
  std::vector<std::string> notes;  // what a reader of the result should know

  const Case* condition = nullptr;  // the scenario under way; none: the design's own
  bool draws = true;                // of several scenarios, the first has its files
  int conditions_over = 0;          // scenarios before it

  const Case& given() const { return condition ? *condition : *design.given; }
  bool writes() const { return !options.directory.empty() && draws; }
  std::string path(const std::string& file) const {
    return (std::filesystem::path(options.directory) / file).string();
  }
};

// How a step ends: `ok` goes on to the next, anything else leaves the rest out.
struct StepEnd {
  EvaluationStatus status = EvaluationStatus::ok;
  std::string reason;
};

inline StepEnd failed(const std::string& reason) {
  return {EvaluationStatus::failed, reason};
}

// `running` where somebody has asked for an end; the same on every rank.
inline StepEnd look_for_stop(DesignWork& work) {
  const bool stop = work.comm.is_root() && work.options.stop && work.options.stop();
  return work.comm.any(stop) ? StepEnd{EvaluationStatus::running, "interrupted"} : StepEnd{};
}

// history.csv, and its name in the result. On the root.
inline void write_history(DesignWork& work, const History& history) {
  write_text_file(work.path("history.csv"), history_csv(history));
  work.result["files"]["history"] = "history.csv";
}

}  // namespace icebow
