#include "study/look/design_card.h"

#include <cmath>
#include <filesystem>

#include "base/errors.h"
#include "base/json_fields.h"
#include "base/shell_word.h"
#include "solver/tank/virtual_tests.h"
#include "study/look/stored_design.h"
#include "study/plan/ranking.h"
#include "study/spec/document_keys.h"
#include "study/spec/read_study.h"
#include "study/spec/spec_hints.h"
#include "study/store/design_files.h"

namespace icebow {
namespace {

// The lattice's next finer one: a layer more, or a spacing that is three quarters of the file's.
std::string finer_lattice(const Json& document, const Case& c) {
  const Json& solver = part_at(document, document_key::solver);
  for (const char* key : {"spacing_m", "spacing_cm", "spacing_mm"})
    if (solver.is_object() && solver.contains(key))
      return std::string(" --set /solver/") + key + "=" + brief(0.75 * solver.at(key).get<double>());
  const long layers = std::lround(c.ice.h / c.numerics.dx) + 1;
  if (c.ice_model == IceModel::calibrated && layers > most_tested_layers) return "";
  return " --set /solver/layers=" + std::to_string(layers);
}

std::string finer_cycle(const Case& c) {
  return " --set /cycle/step=" + brief(c.cycle.step / 2) +
         " --set /cycle/raster=" + brief(c.cycle.raster / 2) +
         " --set /cycle/voyages=" + std::to_string(2 * c.cycle.voyages);
}

// The cycle instead of the formula or beside programs.
std::string by_cycle(const Json& document) {
  Json evaluators = part_at(document, document_key::evaluators);
  if (!evaluators.is_array()) evaluators = {"lindqvist"};
  evaluators.push_back("cycle");
  return " --set " + shell_word("/evaluators=" + evaluators.dump()) + " --set /ranking/by=mean_load";
}

// Nothing where it cannot be finer.
std::string finer_options(const Design& design) {
  const Case& c = *design.given;
  if (design.asked.peridynamics) return finer_lattice(design.document, c);
  return design.asked.cycle ? finer_cycle(c) : by_cycle(design.document);
}

// A program, and several conditions but for the simulation, are evaluated by `icebow run` alone.
Json commands_for(const std::string& directory, const Design& design) {
  const std::string rest = " " + shell_word(directory) + " --design " + shell_word(design.name);
  const std::string options = finer_options(design);
  const bool simulated = design.asked.peridynamics, programs = !design.asked.programs.empty();
  if (programs || simulated || !design.given->scenarios.empty()) {
    const std::string command = (simulated && !programs ? "icebow simulate" : "icebow run") + rest;
    return {{"again", command + " --out again"},
            {"finer", options.empty() ? Json(nullptr) : Json(command + options + " --out finer")}};
  }
  if (design.asked.cycle)
    return {{"again", "icebow cycle" + rest}, {"finer", "icebow cycle" + rest + options}};
  return {{"again", "icebow resistance" + rest}, {"finer", "icebow cycle" + rest}};
}

void add_rank(Json& card, const Store& store, const std::string& name) {
  const Ranking ranking = stored_ranking(store);
  int ranked = 0;
  card["rank_by"] = ranking.rank_by, card["rank"] = 0, card["value"] = nullptr;
  for (const RankedDesign& row : ranking.rows) {
    ranked += row.rank > 0 ? 1 : 0;
    if (row.evaluation.name != name || row.rank == 0) continue;
    card["rank"] = row.rank, card["value"] = finite_or_null(row.value);
    if (!ranking.objective.given()) continue;
    card["second"] = {{"by", ranking.objective.by}, {"value", finite_or_null(row.second)}};
    card["front"] = to_string(row.front);
  }
  card["designs"] = ranked;
}

std::vector<std::string> notes_on(const StoredDesign& stored) {
  std::vector<std::string> notes;
  if (!stored.evaluation) notes.emplace_back("is planned, but has not been evaluated yet");
  if (stored.evaluation && !stored.is_same)
    notes.emplace_back(
        "was evaluated by another version of the program, or before its study file was changed: this program "
        "would evaluate it anew");
  if (!stored.planned.design.given) notes.push_back(stored.planned.design.mistake);
  return notes;
}

}  // namespace

Json design_card(const std::string& directory, const std::string& name) {
  const Store store = open_store_of(directory);
  const StudySpec spec = read_study(document_of(store), store.fact("study_file"));
  const auto stored = stored_design(spec, store, name);
  if (!stored) {
    std::vector<std::string> names;
    for (const Evaluation& e : store.all()) names.push_back(e.name);
    throw InputError(directory + ": has no design \"" + name + "\"" + did_you_mean(name, names) +
                     "; `icebow rank " + directory + "` lists them");
  }
  const Evaluation& e = stored->evaluation ? *stored->evaluation : Evaluation();
  const Design& design = stored->planned.design;
  Json card = {{"design", name},
               {"status", stored->evaluation ? to_string(e.status) : "planned"},
               {"reason", e.reason},
               {"parameters", parameters_json(design.parameters)},
               {"key", stored->planned.key},
               {"notes", notes_on(*stored)},
               {"commands", design.given ? commands_for(directory, design) : Json(nullptr)},
               {"document", design.document},
               {"result", e.result}};
  const std::string files = design_directory(directory, name);
  card["directory"] = std::filesystem::is_directory(files) ? Json(files) : Json(nullptr);
  add_rank(card, store, name);
  return card;
}

}  // namespace icebow
