#include "study/run/study_loop.h"

#include <algorithm>
#include <optional>
#include <set>

#include "study/evaluate/calibration.h"
#include "study/plan/ranking.h"
#include "study/plan/repeats.h"
#include "study/plan/variable_ranges.h"
#include "study/run/learning_loop.h"
#include "study/run/race_loop.h"
#include "study/spec/spec_method.h"
#include "study/store/design_files.h"

namespace icebow {
namespace {

std::vector<Case> simulated_cases(const StudyPlan& plan) {
  std::vector<Case> cases;
  for (const PlannedDesign& planned : plan.designs) {
    if (planned.design.given && planned.design.asked.peridynamics) cases.push_back(*planned.design.given);
  }
  return cases;
}

}  // namespace

StudyOutcome StudyLoop::run(std::vector<std::string> notes) {
  const StudyPlan plan = plan_study(spec_);
  outcome_.notes = std::move(notes);
  outcome_.notes.insert(outcome_.notes.end(), plan.notes.begin(), plan.notes.end());
  try {
    run_plan(plan);
    if (spec_.method.type == MethodType::optimise) run_optimiser();
    if (spec_.confirm.given()) confirm();
    if (spec_.decide.given) race(plan.designs);
  } catch (const Interrupted&) {
    loop_.abandon();
    outcome_.interrupted = true;
  } catch (...) {
    loop_.abandon();
    if (loop_.too_many_failed()) store_.set_fact("state", "interrupted");
    throw;
  }
  sum_up();
  store_.set_fact("state", outcome_.interrupted ? "interrupted" : "finished");
  observer_.on_study_finished(outcome_);
  return outcome_;
}

void StudyLoop::run_plan(const StudyPlan& plan) {
  std::vector<std::string> keys;
  for (const PlannedDesign& planned : plan.designs) keys.push_back(planned.key);
  if (settings_.retry_failed) store_.remove_damaged();
  store_.begin_study(keys);
  if (!spec_.decide.given) forget_race(store_);
  observer_.on_planned(plan);
  test_lattices(simulated_cases(plan));
  evaluate(plan.designs);
}

void StudyLoop::run_optimiser() {
  if (spec_.method.algorithm == learning_algorithm) return learn();
  const OptimiserResult result = search_study(
      spec_, [this](const std::vector<double>& x) { return seen_at(x); },
      [this](const std::vector<double>& x) { return margins_at(x); });
  outcome_.notes.push_back(spec_.method.algorithm + " ended after " + std::to_string(result.evaluations) +
                           " points" + (result.best.empty() ? ", none of which has a value: " : ": ") +
                           result.reason);
}

void StudyLoop::learn() {
  LearningHooks hooks;
  hooks.evaluate = [this](const std::vector<std::vector<double>>& points) { return evaluate_points(points); };
  hooks.margins = [this](const std::vector<double>& x) { return margins_at(x); };
  hooks.pause = [this] {
    if (settings_.stop && settings_.stop()) throw Interrupted();
  };
  for (std::string& note : run_learning(spec_, settings_, store_, hooks))
    outcome_.notes.push_back(std::move(note));
}

// Side by side. A point the study has met already keeps the name it has.
std::vector<std::vector<std::string>> StudyLoop::evaluate_points(
    const std::vector<std::vector<double>>& points) {
  std::vector<std::vector<std::string>> keys;
  std::vector<PlannedDesign> fresh;
  std::set<std::string> under_way;
  for (const std::vector<double>& x : points) {
    const std::vector<PlannedDesign> runs = runs_of(spec_, design_at(spec_, numbered_name(numbered_ + 1), x));
    std::vector<std::string> of_runs;
    for (const PlannedDesign& run : runs) of_runs.push_back(run.key);
    keys.push_back(of_runs);
    if (loop_.has_seen(of_runs.front()) || !under_way.insert(of_runs.front()).second) continue;
    ++numbered_;
    for (const PlannedDesign& run : runs) store_.add_to_study(run.key), fresh.push_back(run);
  }
  evaluate(fresh);
  return keys;
}

// The simulation of the best designs by the cycle and of some that are far from them.
void StudyLoop::confirm() {
  std::vector<PlannedDesign> runs;
  const std::vector<Evaluation> evaluations = store_.all();
  for (const std::string& name : designs_to_confirm(evaluations, spec_)) {
    const auto found = std::find_if(evaluations.begin(), evaluations.end(),
                                    [&](const Evaluation& e) { return e.name == name; });
    for (PlannedDesign& run : confirmations(spec_, designs_.at(found->key))) runs.push_back(std::move(run));
  }
  StudyPlan plan;
  for (const PlannedDesign& run : runs) store_.add_to_study(run.key);
  plan.designs = runs;
  test_lattices(simulated_cases(plan));
  evaluate(runs);
}

// What is decided needs no state any more; a rule that is made sharper later sails those voyages anew, to the
// same records.
void StudyLoop::race(const std::vector<PlannedDesign>& designs) {
  RaceHooks hooks;
  hooks.sail = [this](const std::vector<PlannedDesign>& voyages) { evaluate(voyages); };
  hooks.told = [this](const RaceRecord& record) { observer_.on_leg(record); };
  const RaceRecord record = run_race(spec_, store_, designs, hooks);
  if (record.given()) outcome_.notes.push_back(race_in_words(record));
  if (record.state != RaceState::decided) return;
  for (const PlannedDesign& planned : designs)
    remove_checkpoint_in(design_directory(settings_.directory, planned.design.name));
}

// A proposed point's runs. The optimiser asks for the margins and for the value of a point, one after the
// other.
const std::vector<PlannedDesign>& StudyLoop::proposed(const std::vector<double>& x) {
  if (proposed_.empty() || x != proposed_at_) {
    proposed_ = runs_of(spec_, design_at(spec_, numbered_name(numbered_ + 1), x));
    proposed_at_ = x;
  }
  return proposed_;
}

// A point the study has met already, the baseline for one, keeps the name it has.
Seen StudyLoop::seen_at(const std::vector<double>& x) {
  const std::vector<PlannedDesign>& runs = proposed(x);
  if (!loop_.has_seen(runs.front().key)) {
    ++numbered_;
    for (const PlannedDesign& run : runs) store_.add_to_study(run.key);
    evaluate(runs);
  }
  std::vector<Seen> seen;
  for (const PlannedDesign& run : runs) seen.push_back(loop_.seen(run.key));
  return mean_of(seen);
}

std::vector<double> StudyLoop::margins_at(const std::vector<double>& x) {
  const std::optional<Case>& given = proposed(x).front().design.given;
  std::vector<double> values;
  for (const Margin& margin : settings_.margins(given ? *given : spec_.baseline)) {
    if (margin.required) values.push_back(given ? margin.value : -1.0);
  }
  return values;
}

void StudyLoop::evaluate(const std::vector<PlannedDesign>& designs) {
  if (spec_.confirm.given())
    for (const PlannedDesign& planned : designs) designs_[planned.key] = planned.design;
  loop_.evaluate_all(designs);
}

void StudyLoop::sum_up() {
  const std::vector<Evaluation> evaluations = store_.all();
  outcome_.nothing_feasible = !outcome_.interrupted && nothing_feasible(spec_, evaluations);
  for (const Evaluation& e : evaluations) {
    outcome_.ok += e.status == EvaluationStatus::ok;
    outcome_.infeasible += e.status == EvaluationStatus::infeasible && run_name(e.name).number == 1;
    outcome_.failed += e.status == EvaluationStatus::failed || e.status == EvaluationStatus::damaged;
  }
  Ranking ranking = rank_designs(evaluations, spec_.rank_by);
  ranking.race = read_race(store_);
  if (const RankedDesign* best = best_of(ranking)) outcome_.best = best->evaluation.name;
}

}  // namespace icebow
