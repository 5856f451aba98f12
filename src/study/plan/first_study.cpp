#include "study/plan/first_study.h"

#include <algorithm>
#include <cmath>

#include "base/errors.h"
#include "base/units.h"
#include "hullgen/bow/family.h"
#include "hullgen/bow/feasibility.h"
#include "study/plan/feasible_box.h"
#include "study/plan/nearest_feasible.h"
#include "study/spec/read_study.h"

namespace icebow {
namespace {

double rounded(double value, double step) {
  return std::round(std::round(value / step) * step * 1e6) / 1e6;
}

[[noreturn]] void throw_no_bow(const FirstStudy& ship, const BowParameters& bow) {
  throw InputError("no feasible bow of the family " + std::string(family_form(ship.family).key) +
                   " was found for this length, beam and draught: " + check_feasibility(bow).reason);
}

// The family's preset, its bow as long in beams and its depth as high in draughts.
BowParameters bow_of(const FirstStudy& ship) {
  const BowParameters preset = preset_bow(ship.family);
  BowParameters bow = preset;
  bow.L = ship.length, bow.B = ship.beam, bow.T = ship.draft;
  bow.D = rounded(preset.D / preset.T * ship.draft, 0.1);
  bow.Lf = rounded(preset.Lf / preset.B * ship.beam, 0.1);
  bow.reamer_step = rounded(preset.reamer_step / preset.B * ship.beam, 0.01);
  BowParameters longer = bow;  // leaves the angles room
  longer.Lf = rounded(1.15 * bow.Lf, 0.1);
  for (const BowParameters& wanted : {longer, bow})
    if (check_feasibility(wanted).feasible) return wanted;
  const auto nearest = nearest_feasible(bow);
  if (!nearest) throw_no_bow(ship, bow);
  return nearest->bow;
}

// Where the waterline may not be hollow, the flare follows from waterline and buttock angle at B/4: three
// angles that are free of each other. A side edge wants all four.
std::vector<const char*> angles_of(const FamilyForm& form) {
  if (form.convex_required) return {"stem_deg", "waterline_deg", "buttock_deg"};
  return {"stem_deg", "waterline_deg", "buttock_deg", "flare_deg"};
}

double waterline_at_quarter_beam(const BowAngles& angles) {  // docs/bows.md, eq. (1)
  return std::atan(std::tan(angles.flare) * std::tan(angles.buttock));
}

Json bow_section(const BowParameters& bow) {
  const FamilyForm& form = family_form(bow.family);
  Json section = {{"family", form.key},
                  {"length_m", bow.L},
                  {"beam_m", bow.B},
                  {"draft_m", bow.T},
                  {"depth_m", bow.D},
                  {"bow_length_m", bow.Lf},
                  {"stem_deg", rounded(degrees(bow.angles.stem), 1e-2)},
                  {"waterline_deg", rounded(degrees(bow.angles.waterline), 1e-2)},
                  {"buttock_deg", rounded(degrees(bow.angles.buttock), 1e-2)},
                  {"flare_deg", rounded(degrees(bow.angles.flare), 1e-2)}};
  if (form.convex_required) {
    section["angles_at"] = "quarter_beam";
    section["waterline_deg"] = rounded(degrees(waterline_at_quarter_beam(bow.angles)), 1e-2);
    section.erase("flare_deg");
  }
  if (form.reamers) section["reamer_step_m"] = bow.reamer_step;
  if (form.chines) section["chine"] = bow.chine;
  return section;
}

// Of each variable from (1 - share) to (1 + share) of the bow's own.
Json box_around(const Json& bow, const std::vector<const char*>& angles, double share) {
  Json variables;
  for (const char* key : angles) {
    const double angle = bow.at(key);
    variables[std::string("/bow/") + key] = {{"min", rounded((1.0 - share) * angle, 0.1)},
                                             {"max", std::min(rounded((1.0 + share) * angle, 0.1), 88.0)}};
  }
  return variables;
}

// The widest box that is feasible as a whole, or whose bounds can be drawn in until it is.
void choose_box(Json& document, const std::vector<const char*>& angles) {
  Json& variables = document["method"]["variables"];
  for (const double share : {0.25, 0.15, 0.08, 0.04, 0.02}) {
    variables = box_around(document["bow"], angles, share);
    const FeasibleBox box = feasible_box(read_study(document, "first study"));
    if (box.feasible == box.tried) return;
    for (const Variable& v : box.variables)
      variables[v.pointer] = {{"min", rounded(v.lower, 1e-2)}, {"max", rounded(v.upper, 1e-2)}};
    if (!box.variables.empty()) return;
  }
}

}  // namespace

Json first_study(const FirstStudy& ship) {
  BowParameters bow = bow_of(ship);
  Json document = {
      {"icebow_study", 1},
      {"name", "A first study"},
      {"purpose",
       "Which angles of this ship's bow give the lowest mean load in level ice? By the breaking cycle of "
       "ship simulators, with Lindqvist's formula beside it."},
      {"bow", bow_section(bow)},
      {"ice",
       {{"thickness_m", ship.thickness},
        {"density_kg_m3", 900},
        {"elastic_modulus_GPa", 2.0},
        {"flexural_strength_kPa", 500},
        {"compressive_strength_MPa", 2.3},
        {"friction", 0.1}}},
      {"operation", {{"speed_kn", ship.speed}}},
      {"evaluators", {"lindqvist", "cycle"}}};
  // The file's angles have two decimals: a bow at the edge of what is feasible may lie beyond it then.
  for (int tries = 0; !check_feasibility(read_study(document, "first study").baseline.bow).feasible;
       ++tries) {
    if (tries == 10) throw_no_bow(ship, bow);
    bow.Lf = rounded(1.02 * bow.Lf, 0.1);
    document["bow"] = bow_section(bow);
  }
  document["method"] = {{"type", "latin_hypercube"}, {"samples", ship.samples}, {"seed", 1}};
  choose_box(document, angles_of(family_form(ship.family)));
  return document;
}

}  // namespace icebow
