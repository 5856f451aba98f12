#include "study/evaluate/evaluation_key.h"

#include "base/sha256.h"
#include "base/text.h"
#include "solver/model/describe_scenario.h"
#include "solver/model/described_text.h"
#include "study/evaluate/calibration.h"
#include "study/evaluate/program_evaluator.h"
#include "study/spec/case_hull.h"

namespace icebow {
namespace {

// Raise it when the same case would give another result: a changed model, a corrected error.
constexpr int result_version = 11;

// Numbers as hexadecimal floats: exact, the same on every machine, and readable when two keys that should
// agree do not. Left out is what follows: ice.tensile_strength, from the flexural strength.
struct Spelling {
  static constexpr const char* equals = "=";
  static constexpr bool with_following = false;
  static std::string spelled(double value) { return text("%a", value == 0.0 ? 0.0 : value); }  // -0.0 is 0.0
  static std::string spelled(int value) { return std::to_string(value); }
  static std::string spelled(bool value) { return value ? "true" : "false"; }
  static std::string spelled(const std::string& value) { return value; }
};
using Text = DescribedText<Spelling>;

void describe_angles(Text& text, const BowAngles& angles) {
  const auto& [stem, waterline, buttock, flare] = angles;
  text.field("bow.stem", stem);
  text.field("bow.waterline", waterline);
  text.field("bow.buttock", buttock);
  text.field("bow.flare", flare);
}

// What a bow does not have is not in its text, as in that of an older result.
void describe_centre(Text& text, const CentrePlane& centre) {
  const auto& [stem_radius, knife_height, knife_width, knife_angle, skeg_height, skeg_length, skeg_width,
               skeg_angle] = centre;
  if (stem_radius != 0.0) text.field("bow.stem_radius", stem_radius);
  if (knife_height != 0.0) {
    text.field("bow.knife_height", knife_height);
    text.field("bow.knife_width", knife_width);
    text.field("bow.knife_angle", knife_angle);
  }
  if (skeg_height != 0.0) {
    text.field("bow.skeg_height", skeg_height);
    text.field("bow.skeg_length", skeg_length);
    text.field("bow.skeg_width", skeg_width);
    text.field("bow.skeg_angle", skeg_angle);
  }
}

void describe_bow(Text& text, const BowParameters& bow) {
  const auto& [family, angles_at, angles, L, B, T, D, Lf, panel, belt_below, belt_above, reamer_step, chine,
               centre] = bow;
  text.field("bow.family", family);
  text.ignored("bow.angles_at", angles_at);  // the four angles are the same either way
  describe_angles(text, angles);
  text.field("bow.L", L);
  text.field("bow.B", B);
  text.field("bow.T", T);
  text.field("bow.D", D);
  text.field("bow.Lf", Lf);
  text.field("bow.panel", panel);
  text.field("bow.belt_below", belt_below);
  text.field("bow.belt_above", belt_above);
  // As a stored result has it that is older than these families.
  if (reamer_step != 0.0) text.field("bow.reamer_step", reamer_step);
  if (chine != 0.0) text.field("bow.chine", chine);
  describe_centre(text, centre);
}

void describe_own_hull(Text& text, const OwnHull& own) {
  const auto& [file, checksum, frame, mirror, outer_surface, imported] = own;
  const auto& [unit, forward, up, left_handed, waterline, draft] = frame;
  text.field("hull.sha256", checksum);
  text.field("hull.unit", unit);
  for (int k = 0; k < 3; ++k) text.field("hull.forward", forward[k]);
  for (int k = 0; k < 3; ++k) text.field("hull.up", up[k]);
  text.field("hull.left_handed", left_handed);
  text.field("hull.waterline", waterline);
  text.field("hull.draft", draft);
  text.field("hull.mirror", mirror);
  if (outer_surface) text.field("hull.outer_surface", outer_surface);  // older results have no such word
  text.ignored("hull.file", file);                                     // its bytes count
  text.ignored("hull.imported", imported);                             // follows from them
}

// All that is measured on a hull of the user's own follows from its file; the angles are those it is deformed
// to.
void describe_hull(Text& text, const Case& c) {
  if (!c.own.given()) return describe_bow(text, c.bow);
  describe_own_hull(text, c.own);
  if (is_deformed(c)) describe_angles(text, c.bow.angles);
}

void describe_case(Text& text, const Case& c) {
  const auto& [lambda, bow, own, ice, ice_model, flexural_strength, compressive_strength, water, sheet,
               numerics, V, advance, steady_from, stop_when_ci95_below, seed, snapshots, pictures,
               snapshot_format, cycle, scenarios, by_worst] = c;
  text.ignored("cycle", cycle);          // described where it is asked for
  text.ignored("scenarios", scenarios);  // each is a text of its own
  text.ignored("by_worst", by_worst);
  text.field("lambda", lambda);
  describe_hull(text, c);
  describe_ice(text, ice);
  text.field("flexural_strength", flexural_strength);
  text.ignored("compressive_strength",
               compressive_strength);  // only compared with, or is, the crushing pressure
  describe_water(text, water);
  describe_sheet(text, sheet);
  describe_numerics(text, numerics);
  describe_voyage(text, V, advance, steady_from, stop_when_ci95_below);
  describe_output(text, seed, snapshots, pictures, snapshot_format);
  const int version = ice_model == IceModel::calibrated ? virtual_tests_version : 0;
  text.option(0, "virtual_tests.version", version, 0);
}

// What the formula and the cycle read: the ship, the ice and the speed. Sheet, lattice, seed and files are
// the simulation's.
void describe_ship_in_ice(Text& text, const Case& c) {
  describe_hull(text, c);
  text.field("ice.h", c.ice.h);
  text.field("ice.rho", c.ice.rho);
  text.field("ice.E", c.ice.E);
  text.field("ice.nu", c.ice.nu);
  text.field("flexural_strength", c.flexural_strength);
  text.field("water.rho", c.water.rho);
  text.field("numerics.friction", c.numerics.friction);
  text.field("V", c.V);
}

// The cycle's patch tests break pieces of the simulation's lattice.
bool reads_lattice(const Case& c, const Evaluators& asked) {
  return asked.peridynamics || (asked.cycle && c.cycle.rule.type == cycle::Breaking::calibrated);
}

// Raise it when the same case would give another result of the cycle.
constexpr int cycle_version = 2;

void describe_cycle(Text& text, const CycleSettings& settings) {
  const auto& [rule, crushing_pressure, voyage, voyages, seed, scatter, step, raster, symmetric, submersion,
               submersion_by_hull] = settings;
  const auto& [type, C, C_l, C_v, table] = rule;
  text.field("cycle.version", cycle_version);
  text.field("cycle.breaking", static_cast<int>(type));
  text.field("cycle.C", C);
  text.field("cycle.C_l", C_l);
  text.field("cycle.C_v", C_v);
  text.ignored("cycle.table", table);  // follows from the ice and the solver
  text.field("cycle.crushing_pressure", crushing_pressure);
  text.field("cycle.voyage", voyage);
  text.field("cycle.voyages", voyages);
  text.field("cycle.seed", static_cast<double>(seed));
  text.field("cycle.scatter", scatter);
  text.field("cycle.step", step);
  text.field("cycle.raster", raster);
  text.field("cycle.symmetric", symmetric);
  text.field("cycle.submersion", submersion);
  text.field("cycle.submersion_by_hull", submersion_by_hull);
}

// The conditions of the file itself are not evaluated then.
std::string text_of_scenarios(const Case& c, const Evaluators& asked) {
  std::string all = c.by_worst ? "worst of\n" : "mean of\n";
  for (const CaseScenario& scenario : c.scenarios) {
    Text text;
    text.field("scenario", scenario.name);
    text.field("weight", scenario.weight);
    all += text.str() + evaluation_text(*scenario.given, asked);
  }
  return all;
}

}  // namespace

std::string evaluation_text(const Case& c, const Evaluators& asked) {
  if (!c.scenarios.empty()) return text_of_scenarios(c, asked);
  Text text;
  text.field("icebow.result_version", result_version);
  text.field("use_lindqvist", asked.lindqvist);
  text.field("use_peridynamics", asked.peridynamics);
  reads_lattice(c, asked) ? describe_case(text, c) : describe_ship_in_ice(text, c);
  if (asked.cycle) describe_cycle(text, c.cycle);
  std::string programs;
  for (const ProgramEvaluator& program : asked.programs) programs += program_text(program);
  return text.str() + programs;
}

std::string evaluation_key(const Case& c, const Evaluators& asked) {
  return sha256(evaluation_text(c, asked));
}

}  // namespace icebow
