#include "study/look/study_status.h"

#include <algorithm>
#include <filesystem>

#include "base/json_fields.h"
#include "study/evaluate/scenario_result.h"
#include "study/look/stored_design.h"
#include "study/plan/ranking.h"
#include "study/spec/design_name.h"
#include "study/spec/read_study.h"
#include "study/spec/spec_ranking.h"
#include "study/store/store_lock.h"

namespace icebow {
namespace {

std::string state_of(const Store& store, const std::string& directory) {
  const std::string state = store.fact("state");
  const std::string lock = (std::filesystem::path(directory) / "results.sqlite.lock").string();
  return state == "running" && !is_locked(lock) ? "killed" : state;
}

void count(Json& status, const std::vector<Evaluation>& evaluations) {
  for (const char* key : {"ok", "infeasible", "failed", "damaged"}) status[key] = 0;
  status["running"] = Json::array();
  for (const Evaluation& e : evaluations) {
    if (e.status == EvaluationStatus::running) {
      status["running"].push_back(e.name);
    } else {
      status[to_string(e.status)] = status.at(to_string(e.status)).get<int>() + 1;
    }
  }
}

// Points that an optimiser is still allowed; the numbered designs are those it has had.
int may_follow(const StudySpec& spec, const std::vector<Evaluation>& evaluations, const std::string& state) {
  if (spec.method.type != MethodType::optimise || state == "finished") return 0;
  const auto proposed = std::count_if(evaluations.begin(), evaluations.end(),
                                      [](const Evaluation& e) { return is_numbered_name(e.name); });
  return std::max(0, spec.method.max_evaluations - static_cast<int>(proposed));
}

}  // namespace

Json study_status(const std::string& directory) {
  const Store store = open_store_of(directory);
  const StudySpec spec = read_study(document_of(store), store.fact("study_file"));
  const std::vector<Evaluation> evaluations = store.all();
  const Ranking ranking = stored_ranking(store);
  const RankedDesign* best = best_of(ranking);
  const std::string state = state_of(store, directory);
  Json status = {{"name", spec.name},
                 {"state", state},
                 {"designs", store.designs()},
                 {"may_follow", may_follow(spec, evaluations, state)},
                 {"rank_by", ranking.rank_by},
                 {"best", best ? Json(best->evaluation.name) : Json(nullptr)},
                 {"value", best ? finite_or_null(best->value) : Json(nullptr)}};
  if (best && !scenario_loads(best->evaluation.result).empty()) {
    status["over_scenarios"] = std::string(spec.baseline.by_worst ? "worst" : "mean");
    status["scenarios"] = Json::array();
    for (const ScenarioLoad& load : scenario_loads(best->evaluation.result))
      status["scenarios"].push_back({{"name", load.name},
                                     {"weight", load.weight},
                                     {"mean_load_N", finite_or_null(load.mean)},
                                     {"mean_load_ci95_N", finite_or_null(load.ci95)}});
  }
  if (ranking.objective.given()) {
    status["second"] = to_json(ranking.objective);
    for (const FrontPlace place : {FrontPlace::front, FrontPlace::open})
      status[to_string(place)] = names_at(ranking, place);
  }
  for (const char* fact : {"started", "host", "command", "version"}) status[fact] = store.fact(fact);
  count(status, evaluations);
  return status;
}

}  // namespace icebow
