// The loop over designs, on the root rank: it recalls or starts each design and takes back what has ended.
// Sweeps, the optimiser and the race go through evaluate_all() alike. Rules of resuming:
// docs/study_engine.md.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "study/plan/design_space.h"
#include "study/run/failure_rate.h"
#include "study/run/runner.h"
#include "study/run/study_observer.h"
#include "study/run/study_search.h"
#include "study/spec/study_spec.h"
#include "study/store/store.h"

namespace icebow {

struct Interrupted {};  // thrown where the user asked for the end: settings.stop

class DesignLoop {
 public:
  // Notes for the user, and how many designs were recalled, go to `outcome`.
  DesignLoop(const StudySpec& spec, const RunSettings& settings, Store& store, Runner& runner,
             StudyObserver& observer, StudyOutcome& outcome)
      : spec_(spec),
        settings_(settings),
        store_(store),
        runner_(runner),
        observer_(observer),
        outcome_(outcome) {}

  // The longest first where several run side by side. Throws Interrupted, and RuntimeError where the machine
  // is at fault or too many designs fail; abandon() cleans up after either.
  void evaluate_all(const std::vector<PlannedDesign>& designs);
  void abandon();
  bool too_many_failed() const { return !failures_.too_many().empty(); }

  // Of each design that this loop has recalled or evaluated.
  bool has_seen(const std::string& key) const { return seen_.count(key) > 0; }
  const Seen& seen(const std::string& key) const { return seen_.at(key); }

 private:
  bool recall(const PlannedDesign& planned);
  bool fails_again(const PlannedDesign& planned, const Evaluation& stored);
  bool sails_on(const PlannedDesign& planned, Evaluation& stored);
  bool recall_damaged(const PlannedDesign& planned, const Evaluation& stored);
  void start(const PlannedDesign& planned);
  void mark_as_running(const PlannedDesign& planned);
  void finish(std::vector<Evaluation> ended);
  void keep(Evaluation& evaluation);
  void told(const Evaluation& evaluation);
  void report(const Evaluation& evaluation, bool recalled);
  bool stopped() const { return settings_.stop && settings_.stop(); }

  const StudySpec& spec_;
  const RunSettings& settings_;
  Store& store_;
  Runner& runner_;
  StudyObserver& observer_;
  StudyOutcome& outcome_;
  std::map<std::string, PlannedDesign> under_way_;  // by name
  std::map<std::string, Seen> seen_;                // by key
  FailureRate failures_{spec_.execution.stop_at_failure_rate};
};

}  // namespace icebow
