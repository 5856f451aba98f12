#include "study/look/stored_design.h"

#include <algorithm>
#include <filesystem>

#include "base/errors.h"
#include "base/json_fields.h"
#include "study/evaluate/result_keys.h"
#include "study/plan/confirmation.h"
#include "study/plan/repeats.h"
#include "study/run/race_loop.h"
#include "study/spec/design_name.h"
#include "study/spec/spec_ranking.h"

namespace icebow {
namespace {

std::string store_in(const std::string& directory) {
  return (std::filesystem::path(directory) / "results.sqlite").string();
}

std::optional<PlannedDesign> named(std::vector<PlannedDesign> designs, const std::string& name) {
  const auto found = std::find_if(designs.begin(), designs.end(),
                                  [&](const PlannedDesign& p) { return p.design.name == name; });
  if (found == designs.end()) return std::nullopt;
  return std::move(*found);
}

// The values of the study's variables, where the evaluation has them all.
std::vector<double> point_of(const StudySpec& spec, const Evaluation& e) {
  std::vector<double> x;
  for (const Variable& v : spec.method.variables) {
    const auto found = e.parameters.find(v.pointer);
    if (found == e.parameters.end()) return {};
    x.push_back(found->second);
  }
  return x;
}

// Baseline and named designs are in the plan whatever the method; its points may be many, and an optimiser's
// are known by their parameters alone.
std::optional<PlannedDesign> swept_design(const StudySpec& spec, const Store& store,
                                          const std::string& name) {
  StudySpec without_points = spec;
  without_points.method.type = MethodType::list;
  if (auto found = named(plan_study(without_points).designs, name)) return found;
  const auto evaluation = store.find_name(name);
  const bool of_a_method = is_numbered_name(name) && !spec.method.variables.empty();
  if (evaluation && of_a_method) {
    const std::vector<double> x = point_of(spec, *evaluation);
    if (!x.empty()) return design_at(spec, name, x);
  }
  return of_a_method ? named(plan_study(spec).designs, name) : std::nullopt;
}

}  // namespace

bool is_study_directory(const std::string& path) {
  return std::filesystem::is_regular_file(store_in(path));
}

Store open_store_of(const std::string& directory) {
  if (!is_study_directory(directory))
    throw InputError(directory +
                     ": holds no study (no results.sqlite); name the --out directory of `icebow run`");
  return Store::open_read_only(store_in(directory));
}

Ranking stored_ranking(const Store& store) {
  const std::string by = store.fact("rank_by");
  const std::string second = store.fact("second_objective");  // none in older stores
  Ranking ranking =
      rank_designs(store.all(), by.empty() ? StudySpec().rank_by : by,
                   second_objective_from(second.empty() ? Json() : parse_json(second, "results.sqlite")));
  ranking.race = read_race(store);
  return ranking;
}

Json document_of(const Store& store) {
  return parse_json(store.fact("study"), "results.sqlite, the study that was run");
}

std::optional<StoredDesign> stored_design(const StudySpec& spec, const Store& store,
                                          const std::string& name) {
  const std::string run = run_name(name).design, swept = is_confirmation(run) ? confirmed_design(run) : run;
  const auto design = swept_design(spec, store, swept);
  if (!design) return std::nullopt;
  const auto planned =
      named(is_confirmation(run) ? confirmations(spec, design->design) : runs_of(spec, *design), name);
  if (!planned) return std::nullopt;
  StoredDesign found{*planned, store.find_name(name), false};
  if (found.evaluation && found.planned.design.sail_to > 0.0) {
    const double sailed = number_at(found.evaluation->result, result_key::sailed_to);
    if (sailed > 0.0) found.planned.design = sailed_to(std::move(found.planned.design), sailed);
  }
  found.is_same = found.evaluation && found.evaluation->key == planned->key;
  return found;
}

}  // namespace icebow
