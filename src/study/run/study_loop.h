// What one study does, on the root rank: its plan, and after it the optimiser, the confirmation or the race.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "study/run/design_loop.h"

namespace icebow {

class StudyLoop {
 public:
  // `settings` have their evaluator and their margins.
  StudyLoop(const StudySpec& spec, const RunSettings& settings, Store& store, Runner& runner,
            StudyObserver& observer)
      : spec_(spec),
        settings_(settings),
        store_(store),
        observer_(observer),
        loop_(spec, settings, store, runner, observer, outcome_) {}
  StudyLoop(const StudyLoop&) = delete;
  StudyLoop& operator=(const StudyLoop&) = delete;

  StudyOutcome run(std::vector<std::string> notes);

 private:
  void run_plan(const StudyPlan& plan);
  void run_optimiser();
  void learn();
  std::vector<std::vector<std::string>> evaluate_points(const std::vector<std::vector<double>>& points);
  void confirm();
  void race(const std::vector<PlannedDesign>& designs);
  Seen seen_at(const std::vector<double>& x);
  std::vector<double> margins_at(const std::vector<double>& x);
  const std::vector<PlannedDesign>& proposed(const std::vector<double>& x);
  void evaluate(const std::vector<PlannedDesign>& designs);
  void sum_up();

  const StudySpec& spec_;
  const RunSettings& settings_;
  Store& store_;
  StudyObserver& observer_;
  StudyOutcome outcome_;
  DesignLoop loop_;                        // writes to outcome_
  std::map<std::string, Design> designs_;  // by key: as they were planned, where some are confirmed
  std::vector<PlannedDesign> proposed_;    // the runs of the point proposed last
  std::vector<double> proposed_at_;
  int numbered_ = 0;  // designs named by the optimiser so far
};

}  // namespace icebow
