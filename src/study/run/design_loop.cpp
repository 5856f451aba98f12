#include "study/run/design_loop.h"

#include <algorithm>
#include <optional>

#include "base/errors.h"
#include "study/plan/constraints.h"
#include "study/plan/ranking.h"
#include "study/run/crash_mark.h"
#include "study/run/expected_work.h"
#include "study/run/failure.h"
#include "study/run/sailing.h"
#include "study/run/study_directory.h"
#include "study/store/design_files.h"

namespace icebow {

// For each proposed design: take the stored evaluation of its key, or evaluate and store.
void DesignLoop::evaluate_all(const std::vector<PlannedDesign>& planned) {
  const std::vector<PlannedDesign> designs = runner_.at_once() > 1 ? longest_first(planned) : planned;
  auto next = designs.begin();
  while (next != designs.end() || runner_.busy()) {
    if (stopped()) throw Interrupted();
    while (next != designs.end() && runner_.has_room()) {
      if (!recall(*next)) start(*next);
      ++next;
    }
    finish(runner_.wait());
  }
}

// Whether there is nothing to evaluate.
bool DesignLoop::recall(const PlannedDesign& planned) {
  adopt_first_leg(store_, planned);
  std::optional<Evaluation> stored =
      settle_name(store_, settings_.directory, planned.design.name, planned.key);
  if (!planned.design.given) {
    under_way_[planned.design.name] = planned;
    clear_design_directory(settings_.directory, planned.design.name);
    Evaluation rejected;
    rejected.name = planned.design.name;
    rejected.reason = planned.design.mistake;
    finish({rejected});
    return true;
  }
  if (!stored) return false;
  const Json before = to_json(*stored);
  apply_constraints(spec_.constraints, *stored);
  const bool lacks_part = stored->status == EvaluationStatus::ok && planned.design.asked.hydrostatics &&
                          !stored->result.contains("hydrostatics");
  if ((lacks_part || lacks_a_number(*stored)) && !planned.design.asked.peridynamics) return false;
  if (stored->status == EvaluationStatus::running) {
    const Crashes crashes = crashes_of(*stored, settings_.directory);
    if (crashes.count < 2) return false;
    stored->status = EvaluationStatus::failed;
    stored->reason =
        "crashed twice: the program was lost each time while it evaluated this design, last by " +
        crashes.last + " (--retry-failed tries it again)";
  }
  if (stored->status == EvaluationStatus::failed && !fails_again(planned, *stored)) {
    store_.remove(planned.key);
    return false;
  }
  if (stored->status == EvaluationStatus::damaged) return recall_damaged(planned, *stored);
  if (sails_on(planned, *stored)) return false;
  stored->parameters =
      planned.design.parameters;  // the study may have other variables than when it was stored
  note_choices(spec_, planned.design, *stored);
  complete_result(*stored, settings_.directory, !planned.design.asked.formula_alone());
  if (to_json(*stored) != before) store_.put(*stored);
  report(*stored, true);
  return true;
}

// A voyage whose record is there, but shorter than it is to be.
bool DesignLoop::sails_on(const PlannedDesign& planned, Evaluation& stored) {
  if (is_far_enough(planned, stored) || (has_ended(stored) && !settings_.retry_failed)) return false;
  const std::string crash = crash_mark_in(design_directory(settings_.directory, stored.name));
  if (crash.empty() || settings_.retry_failed) return true;
  outcome_.notes.push_back(end_sailing(stored, "the program was lost by " + crash));
  return false;
}

bool DesignLoop::fails_again(const PlannedDesign& planned, const Evaluation& stored) {
  if (settings_.retry_failed) return false;
  const std::string changed = changed_since(stored, spec_.execution, planned.design.asked);
  if (!changed.empty()) outcome_.notes.push_back(stored.name + " is tried again: " + changed);
  return changed.empty();
}

// An optimiser's next points depend on every value before: it cannot go on without this one.
bool DesignLoop::recall_damaged(const PlannedDesign& planned, const Evaluation& stored) {
  if (spec_.method.type == MethodType::optimise) {
    store_.remove(planned.key);
    return false;
  }
  outcome_.notes.push_back(planned.design.name + ": " + stored.reason);
  report(stored, true);
  return true;
}

// A design of the formula alone is over in a millisecond: it has no mark and no files. A voyage that is
// sailed on keeps its record until the longer one is there.
void DesignLoop::start(const PlannedDesign& planned) {
  if (!planned.design.asked.formula_alone()) mark_as_running(planned);
  under_way_[planned.design.name] = planned;
  observer_.on_started(planned.design);
  runner_.start(planned);
}

void DesignLoop::mark_as_running(const PlannedDesign& planned) {
  const auto stored = store_.find(planned.key);
  if (stored && stored->status == EvaluationStatus::ok) return;
  Evaluation mark;
  mark.key = planned.key;
  mark.name = planned.design.name;
  mark.status = EvaluationStatus::running;
  mark.parameters = planned.design.parameters;
  const bool under_way = stored && stored->status == EvaluationStatus::running;
  mark.result = to_json(under_way ? crashes_of(*stored, settings_.directory) : Crashes());
  store_.put(mark);
  clear_design_directory(settings_.directory, planned.design.name);
}

// What ended together is stored by one commit; a checkpoint goes when its result is safe.
void DesignLoop::finish(std::vector<Evaluation> ended) {
  const auto interrupted = std::stable_partition(
      ended.begin(), ended.end(), [](const Evaluation& e) { return e.status != EvaluationStatus::running; });
  const bool stop = interrupted != ended.end();
  ended.erase(interrupted, ended.end());
  if (ended.size() == 1) keep(ended.front());
  if (ended.size() > 1)
    store_.together([&] {
      for (Evaluation& evaluation : ended) keep(evaluation);
    });
  for (const Evaluation& evaluation : ended) told(evaluation);
  if (stop) throw Interrupted();
  if (too_many_failed()) throw RuntimeError(failures_.too_many());
}

void DesignLoop::keep(Evaluation& evaluation) {
  const PlannedDesign& planned = under_way_.at(evaluation.name);
  std::optional<Evaluation> before;
  if (planned.design.sail_to > 0.0 && evaluation.status != EvaluationStatus::ok)
    before = store_.find(planned.key);
  if (before && before->status == EvaluationStatus::ok) {
    outcome_.notes.push_back(end_sailing(*before, evaluation.reason));
    evaluation = *before;
  }
  evaluation.key = planned.key;
  evaluation.parameters = planned.design.parameters;
  note_choices(spec_, planned.design, evaluation);
  apply_constraints(spec_.constraints, evaluation);
  complete_result(evaluation, settings_.directory, !planned.design.asked.formula_alone());
  store_.put(evaluation);
}

void DesignLoop::told(const Evaluation& evaluation) {
  const Design& design = under_way_.at(evaluation.name).design;
  if (!design.asked.formula_alone() && design.sail_to == 0.0 && !goes_on_later(evaluation))
    remove_checkpoint_in(design_directory(settings_.directory, evaluation.name));
  if (evaluation.result.contains("notes") && evaluation.result.at("notes").is_array())
    for (const Json& note : evaluation.result.at("notes"))
      outcome_.notes.push_back(evaluation.name + ": " + note.get<std::string>());
  under_way_.erase(evaluation.name);
  failures_.count(evaluation);
  report(evaluation, false);
}

void DesignLoop::report(const Evaluation& evaluation, bool recalled) {
  seen_[evaluation.key] = seen_of(spec_, evaluation);
  outcome_.recalled += recalled ? 1 : 0;
  observer_.on_finished(evaluation, recalled);
}

// An end in good order leaves no design marked as running.
void DesignLoop::abandon() {
  runner_.stop();
  try {
    for (const auto& [name, planned] : under_way_) {
      const auto stored = store_.find(planned.key);
      if (stored && stored->status == EvaluationStatus::running) store_.remove(planned.key);
    }
  } catch (
      const RuntimeError&) {  // the disk is full: a row that stays marked is evaluated again all the same
  }
}

}  // namespace icebow
