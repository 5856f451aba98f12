#include "reports/content/study_results.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <set>

#include "base/errors.h"
#include "base/json_fields.h"
#include "study/evaluate/result_keys.h"
#include "study/look/stored_design.h"
#include "study/plan/confirmation.h"
#include "study/plan/design_space.h"
#include "study/plan/model_notes.h"
#include "study/plan/repeats.h"
#include "study/spec/document_keys.h"
#include "study/spec/read_study.h"
#include "study/store/store.h"

namespace icebow {
namespace {

namespace fs = std::filesystem;

// The name a reader knows the study by: its own, else that of its directory.
std::string study_name(const StudyResults& study) {
  const std::string name = text_at(study.document, document_key::name);
  if (!name.empty()) return name;
  const fs::path directory = fs::absolute(study.directory).lexically_normal();
  return (directory.has_filename() ? directory : directory.parent_path()).filename().string();
}

Json study_document(const std::string& directory, const Store& store) {
  const fs::path file = fs::path(directory) / "study.json";
  try {
    if (fs::is_regular_file(fs::symlink_status(file))) return read_json_file(file.string());
    const std::string fact = store.fact("study");
    return fact.empty() ? Json() : parse_json(fact, "study");
  } catch (const InputError&) {
    return Json();  // the results stand on their own
  }
}

// What is planned and has no result yet. An unreadable or older study file is no reason to refuse a report.
void add_plan(StudyResults& study, const std::vector<Evaluation>& evaluations) {
  std::set<std::string> known;
  for (const Evaluation& e : evaluations) known.insert(e.key);
  for (const Evaluation& e : evaluations)
    if (e.status == EvaluationStatus::running) study.running.push_back(e.name);
  if (study.state == "finished") return;  // nothing is missing, and a plan reads every design again
  try {
    const StudyPlan plan = plan_study(read_study(study.document, study.name));
    for (const PlannedDesign& planned : plan.designs)
      if (planned.design.given && known.count(planned.key) == 0) study.waiting.push_back(planned.design.name);
    const int proposed = static_cast<int>(evaluations.size()) - static_cast<int>(plan.designs.size());
    study.proposals = std::max(0, plan.proposals - std::max(0, proposed));
  } catch (const std::exception&) {
    study.waiting.clear();
  }
}

void count_statuses(StudyResults& study, const std::vector<Evaluation>& evaluations) {
  for (const Evaluation& e : evaluations) {
    if (e.status == EvaluationStatus::ok) ++study.ok;
    if (e.status == EvaluationStatus::infeasible && run_name(e.name).number == 1) ++study.infeasible;
    if (e.status == EvaluationStatus::failed || e.status == EvaluationStatus::damaged) ++study.failed;
    study.wall_seconds += e.wall_seconds;
  }
}

void add_runs(StudyResults& study, const std::vector<Evaluation>& evaluations) {
  for (const Evaluation& e : evaluations) {
    const bool ok = e.status == EvaluationStatus::ok;
    if (is_confirmation(e.name)) {
      if (ok) study.confirmations.push_back(e.result);
      continue;
    }
    const std::string design = run_name(e.name).design;
    study.order.emplace(design, static_cast<int>(study.order.size()) + 1);
    if (ok) study.repeats[design].push_back(e);
  }
  for (auto it = study.repeats.begin(); it != study.repeats.end();)
    it = it->second.size() < 2 && it->second.front().name == it->first ? study.repeats.erase(it)
                                                                       : std::next(it);
}

bool has_failed(const Evaluation& e) {
  return e.status == EvaluationStatus::failed || e.status == EvaluationStatus::damaged;
}

// Runs that failed where their design has a rank all the same, and simulations that were to confirm one.
void add_lost_runs(StudyResults& study, const std::vector<Evaluation>& evaluations) {
  std::set<std::string> ranked;
  for (const RankedDesign& row : study.ranking.rows) {
    if (row.rank > 0) ranked.insert(row.evaluation.name);
    study.failed_designs += has_failed(row.evaluation);
  }
  for (const Evaluation& e : evaluations) {
    const RunName run = run_name(e.name);
    if (!has_failed(e)) continue;
    const std::string reason = e.reason.empty() ? "." : ": " + e.reason;
    if (is_confirmation(run.design))
      study.lost_runs.push_back("A simulation of " + confirmed_design(run.design) + " failed" + reason);
    else if (ranked.count(run.design) > 0)
      study.lost_runs.push_back("Run " + std::to_string(run.number) + " of " + run.design +
                                " failed, and its mean is of the other runs" + reason);
  }
}

// Of the simulation, where the study has one.
void add_notes(StudyResults& study) {
  try {
    const StudySpec spec = read_study(study.document, study.name);
    if (!spec.use_peridynamics) return;
    for (const std::string& note : model_notes(spec.baseline, spec.confirm.given()))
      study.notes.push_back("Of the model: " + note);
  } catch (const std::exception&) {
    study.notes.clear();  // a study file this program cannot read: the results stand on their own
  }
}

// Lists and grids draw no random numbers.
std::string seed(const Json& document, const Store& store) {
  const std::string method = text_at(document, document_key::method_type);
  return method == "latin_hypercube" || method == "optimise" ? store.fact("seed") : std::string();
}

}  // namespace

int StudyResults::ranked() const {
  return static_cast<int>(std::count_if(ranking.rows.begin(), ranking.rows.end(),
                                        [](const RankedDesign& row) { return row.rank > 0; }));
}

StudyResults read_study_results(const std::string& directory) {
  const fs::path database = fs::path(directory) / "results.sqlite";
  if (!fs::exists(database))
    throw InputError(directory + " holds no study: " + database.string() +
                     " is missing. Name the output directory of `icebow run`.");
  const Store store = Store::open_read_only(database.string());
  const std::vector<Evaluation> evaluations = store.all();

  StudyResults study;
  study.directory = directory;
  study.document = study_document(directory, store);
  study.name = study_name(study);
  study.purpose = text_at(study.document, document_key::purpose);
  study.command = store.fact("command");
  study.version = store.fact("version");
  study.host = store.fact("host");
  study.started = store.fact("started");
  study.state = store.fact("state");
  study.file = store.fact("study_file");
  study.seed = seed(study.document, store);
  study.ranking = stored_ranking(store);
  count_statuses(study, evaluations);
  add_runs(study, evaluations);
  add_lost_runs(study, evaluations);
  add_notes(study);
  add_plan(study, evaluations);
  return study;
}

double measured_or_requested(const Json& result, const std::string& angle) {
  const double measured = number_at(result, result_key::measured_deg(angle));
  return std::isfinite(measured) ? measured : number_at(result, result_key::requested_deg(angle));
}

}  // namespace icebow
