#include "study/run/run_study.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iterator>
#include <limits>
#include <map>
#include <optional>

#include "base/errors.h"
#include "base/text.h"
#include "study/evaluate/calibration.h"
#include "study/plan/constraints.h"
#include "study/plan/optimiser.h"
#include "study/plan/ranking.h"
#include "study/plan/repeats.h"
#include "study/plan/variable_ranges.h"
#include "study/run/crash_mark.h"
#include "study/run/failure.h"
#include "study/run/race_loop.h"
#include "study/run/runner.h"
#include "study/run/sailing.h"
#include "study/run/study_directory.h"
#include "study/spec/case_hull.h"
#include "study/store/design_files.h"
#include "study/store/store.h"

namespace icebow {
namespace {

struct Interrupted {};

// The loop of a study on the root rank. Sweeps and the optimiser go through evaluate_all() alike.
class StudyLoop {
 public:
  StudyLoop(const StudySpec& spec, const RunSettings& settings, Store& store, Runner& runner,
            StudyObserver& observer)
      : spec_(spec), settings_(settings), store_(store), runner_(runner), observer_(observer) {}

  StudyOutcome run(std::vector<std::string> notes);

 private:
  void run_plan(const StudyPlan& plan);
  void run_optimiser();
  void confirm();
  void race(const std::vector<PlannedDesign>& designs);
  double value_at(const std::vector<double>& x);
  std::vector<double> margins_at(const std::vector<double>& x);
  const std::vector<PlannedDesign>& proposed(const std::vector<double>& x);

  void evaluate_all(const std::vector<PlannedDesign>& designs);
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
  void abandon();
  void sum_up();
  bool stopped() const { return settings_.stop && settings_.stop(); }

  const StudySpec& spec_;
  const RunSettings& settings_;
  Store& store_;
  Runner& runner_;
  StudyObserver& observer_;
  std::map<std::string, PlannedDesign> under_way_;  // by name
  std::map<std::string, Design> designs_;           // by key: as they were planned, where some are confirmed
  std::map<std::string, double> values_;            // by key: what this study has seen
  std::vector<PlannedDesign> proposed_;             // the runs of the point proposed last
  std::vector<double> proposed_at_;
  int numbered_ = 0;  // designs named by the optimiser so far
  StudyOutcome outcome_;
};

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
    abandon();
    outcome_.interrupted = true;
  } catch (...) {
    abandon();
    throw;
  }
  sum_up();
  store_.set_fact("state", outcome_.interrupted ? "interrupted" : "finished");
  observer_.on_study_finished(outcome_);
  return outcome_;
}

std::vector<Case> simulated_cases(const StudyPlan& plan) {
  std::vector<Case> cases;
  for (const PlannedDesign& planned : plan.designs) {
    if (planned.design.given && planned.design.asked.peridynamics) cases.push_back(*planned.design.given);
  }
  return cases;
}

void StudyLoop::run_plan(const StudyPlan& plan) {
  std::vector<std::string> keys;
  for (const PlannedDesign& planned : plan.designs) keys.push_back(planned.key);
  if (settings_.retry_failed) store_.remove_damaged();
  store_.begin_study(keys);
  if (!spec_.decide.given) forget_race(store_);
  observer_.on_planned(plan);
  test_lattices(simulated_cases(plan));
  evaluate_all(plan.designs);
}

void StudyLoop::run_optimiser() {
  OptimiserProblem problem;
  for (const Variable& variable : spec_.method.variables) {
    problem.lower.push_back(variable.lower);
    problem.upper.push_back(variable.upper);
  }
  problem.start = start_point(spec_);
  problem.value = [this](const std::vector<double>& x) { return value_at(x); };
  problem.margins = [this](const std::vector<double>& x) { return margins_at(x); };
  const Method& method = spec_.method;
  const OptimiserResult result =
      optimise(problem, {method.algorithm, method.seed, method.max_evaluations, method.tolerance});
  outcome_.notes.push_back(method.algorithm + " ended after " + std::to_string(result.evaluations) +
                           " points" + (result.best.empty() ? ", none of which has a value: " : ": ") +
                           result.reason);
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
  evaluate_all(runs);
}

// What is decided needs no state any more; a rule that is made sharper later sails those voyages anew, to the
// same records.
void StudyLoop::race(const std::vector<PlannedDesign>& designs) {
  RaceHooks hooks;
  hooks.sail = [this](const std::vector<PlannedDesign>& voyages) { evaluate_all(voyages); };
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
double StudyLoop::value_at(const std::vector<double>& x) {
  const std::vector<PlannedDesign>& runs = proposed(x);
  if (values_.count(runs.front().key) == 0) {
    ++numbered_;
    for (const PlannedDesign& run : runs) store_.add_to_study(run.key);
    evaluate_all(runs);
  }
  std::vector<double> values;
  for (const PlannedDesign& run : runs) values.push_back(values_.at(run.key));
  return repeated_mean(values, values).mean;
}

std::vector<double> StudyLoop::margins_at(const std::vector<double>& x) {
  const std::optional<Case>& given = proposed(x).front().design.given;
  std::vector<double> values;
  for (const Margin& margin : settings_.margins(given ? *given : spec_.baseline)) {
    if (margin.required) values.push_back(given ? margin.value : -1.0);
  }
  return values;
}

// For each proposed design: take the stored evaluation of its key, or evaluate and store.
void StudyLoop::evaluate_all(const std::vector<PlannedDesign>& designs) {
  auto next = designs.begin();
  if (spec_.confirm.given())
    for (const PlannedDesign& planned : designs) designs_[planned.key] = planned.design;
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
bool StudyLoop::recall(const PlannedDesign& planned) {
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
  if (lacks_a_number(*stored) && !planned.design.asked.peridynamics) return false;
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
  complete_result(*stored, settings_.directory, !planned.design.asked.formula_alone());
  if (to_json(*stored) != before) store_.put(*stored);
  report(*stored, true);
  return true;
}

// A voyage whose record is there, but shorter than it is to be.
bool StudyLoop::sails_on(const PlannedDesign& planned, Evaluation& stored) {
  if (is_far_enough(planned, stored) || (has_ended(stored) && !settings_.retry_failed)) return false;
  const std::string crash = crash_mark_in(design_directory(settings_.directory, stored.name));
  if (crash.empty() || settings_.retry_failed) return true;
  outcome_.notes.push_back(end_sailing(stored, "the program was lost by " + crash));
  return false;
}

bool StudyLoop::fails_again(const PlannedDesign& planned, const Evaluation& stored) {
  if (settings_.retry_failed) return false;
  const std::string changed = changed_since(stored, spec_.execution, planned.design.asked);
  if (!changed.empty()) outcome_.notes.push_back(stored.name + " is tried again: " + changed);
  return changed.empty();
}

// An optimiser's next points depend on every value before: it cannot go on without this one.
bool StudyLoop::recall_damaged(const PlannedDesign& planned, const Evaluation& stored) {
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
void StudyLoop::start(const PlannedDesign& planned) {
  if (!planned.design.asked.formula_alone()) mark_as_running(planned);
  under_way_[planned.design.name] = planned;
  observer_.on_started(planned.design);
  runner_.start(planned);
}

void StudyLoop::mark_as_running(const PlannedDesign& planned) {
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
void StudyLoop::finish(std::vector<Evaluation> ended) {
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
}

void StudyLoop::keep(Evaluation& evaluation) {
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
  apply_constraints(spec_.constraints, evaluation);
  complete_result(evaluation, settings_.directory, !planned.design.asked.formula_alone());
  store_.put(evaluation);
}

void StudyLoop::told(const Evaluation& evaluation) {
  const Design& design = under_way_.at(evaluation.name).design;
  if (!design.asked.formula_alone() && design.sail_to == 0.0 && !goes_on_later(evaluation))
    remove_checkpoint_in(design_directory(settings_.directory, evaluation.name));
  if (evaluation.result.contains("notes") && evaluation.result.at("notes").is_array())
    for (const Json& note : evaluation.result.at("notes"))
      outcome_.notes.push_back(evaluation.name + ": " + note.get<std::string>());
  under_way_.erase(evaluation.name);
  report(evaluation, false);
}

void StudyLoop::report(const Evaluation& evaluation, bool recalled) {
  values_[evaluation.key] = ranking_value(evaluation, spec_.rank_by);
  outcome_.recalled += recalled ? 1 : 0;
  observer_.on_finished(evaluation, recalled);
}

// An end in good order leaves no design marked as running.
void StudyLoop::abandon() {
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

// A week's study does not end because somebody looks into its store: it waits, and says so.
Store::Waiting patience(const RunSettings& settings, StudyObserver& observer) {
  constexpr double first = 2.0, then = 60.0;  //!< [s]
  return [&settings, &observer, next = first](double seconds) mutable {
    if (seconds < first) next = first;
    if (seconds >= next) {
      observer.on_waiting(
          text("another program holds results.sqlite locked: waiting for it, %.0f s so far", seconds));
      next += then;
    }
    return !(settings.stop && settings.stop());
  };
}

// Empty settings mean the real thing.
RunSettings completed(RunSettings settings) {
  if (!settings.evaluate) settings.evaluate = evaluate;
  if (!settings.margins) settings.margins = [](const Case& c) { return check_feasibility(c).margins; };
  if (settings.program.empty()) settings.program = std::filesystem::read_symlink("/proc/self/exe").string();
  if (settings.launcher == Launcher::automatic) {
    settings.launcher = MpiSession::started_by_mpirun() ? Launcher::embedded : Launcher::isolated;
  }
  return settings;
}

StudyOutcome run_on_root(const Communicator& comm, const StudySpec& spec, const RunSettings& settings,
                         StudyObserver& observer) {
  StudyDirectory directory = open_study_directory(spec, settings, patience(settings, observer));
  const RunnerContext context{
      directory.spec, settings,
      [&](const std::string& design, const Progress& progress) { observer.on_progress(design, progress); }};
  const auto runner = settings.launcher == Launcher::isolated ? make_isolated_runner(context)
                                                              : make_embedded_runner(comm, context);
  return StudyLoop(directory.spec, settings, directory.store, *runner, observer).run(directory.notes);
}

}  // namespace

StudyOutcome run_study(const Communicator& comm, const StudySpec& spec, const RunSettings& given,
                       StudyObserver& observer) {
  const RunSettings settings = completed(given);
  if (!comm.is_root()) return serve_embedded(comm, settings.evaluate);
  try {
    StudyOutcome outcome = run_on_root(comm, spec, settings, observer);
    end_embedded(comm, outcome);
    return outcome;
  } catch (const std::exception& error) {
    fail_embedded(comm, error);
    throw;
  }
}

}  // namespace icebow
