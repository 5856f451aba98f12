#include "study/evaluate/evaluation_key.h"

#include <algorithm>
#include <cstdio>
#include <type_traits>

#include "base/sha256.h"
#include "study/evaluate/calibration.h"
#include "study/spec/case_hull.h"

namespace icebow {
namespace {

// Raise it when the same case would give another result: a changed model, a corrected error.
constexpr int result_version = 8;

// A field added to a case but not to its key would hand out results of another case: the sizes notice. Left
// out on purpose: numerics.ranks_along_x, because results do not depend on the ranks, bow.angles_at,
// because the four angles are the same either way, compressive_strength, which is only compared with or is
// the crushing pressure, and ice.tensile_strength, which follows from the flexural strength.
static_assert(sizeof(void*) != 8 ||
                  (sizeof(BowParameters) == 120 && sizeof(IceMaterial) == 64 && sizeof(Water) == 32 &&
                   sizeof(Sheet) == 48 && sizeof(Numerics) == 72 && sizeof(MeshFrame) == 80),
              "add the new field to describe() below, then correct the size");
static_assert(sizeof(void*) != 8 || sizeof(Case) == 8 + 120 + 168 + 64 + 24 + 32 + 48 + 72 + 32 + 8 + 8 + 8,
              "add the new field of Case to evaluation_key() below, then correct the size");

// One line a field, numbers as hexadecimal floats: exact, the same on every machine, and readable when two
// keys that should agree do not.
class Text {
 public:
  void add(const char* name, double value) {
    char buffer[64];
    std::snprintf(buffer, sizeof buffer, "%a", value == 0.0 ? 0.0 : value);  // -0.0 is 0.0
    line(name, buffer);
  }
  void add(const char* name, int value) { line(name, std::to_string(value)); }
  void add(const char* name, const std::string& value) { line(name, value); }
  void add(const char* name, bool value) { line(name, value ? "true" : "false"); }
  template <class E, class = std::enable_if_t<std::is_enum_v<E>>>
  void add(const char* name, E value) {
    line(name, std::to_string(static_cast<int>(value)));
  }
  const std::string& str() const { return text_; }

 private:
  void line(const char* name, const std::string& value) { text_ += std::string(name) + "=" + value + "\n"; }
  std::string text_;
};

void describe(Text& text, const BowAngles& angles) {
  text.add("bow.stem", angles.stem);
  text.add("bow.waterline", angles.waterline);
  text.add("bow.buttock", angles.buttock);
  text.add("bow.flare", angles.flare);
}

void describe(Text& text, const BowParameters& bow) {
  text.add("bow.family", bow.family);
  describe(text, bow.angles);
  text.add("bow.L", bow.L);
  text.add("bow.B", bow.B);
  text.add("bow.T", bow.T);
  text.add("bow.D", bow.D);
  text.add("bow.Lf", bow.Lf);
  text.add("bow.panel", bow.panel);
  text.add("bow.belt_below", bow.belt_below);
  text.add("bow.belt_above", bow.belt_above);
  // As a stored result has it that is older than these families.
  if (bow.reamer_step != 0.0) text.add("bow.reamer_step", bow.reamer_step);
  if (bow.chine != 0.0) text.add("bow.chine", bow.chine);
}

void describe(Text& text, const OwnHull& own) {
  text.add("hull.sha256", own.sha256);
  text.add("hull.unit", own.frame.unit);
  for (int k = 0; k < 3; ++k) text.add("hull.forward", own.frame.forward[k]);
  for (int k = 0; k < 3; ++k) text.add("hull.up", own.frame.up[k]);
  text.add("hull.left_handed", own.frame.left_handed);
  text.add("hull.waterline", own.frame.waterline);
  text.add("hull.draft", own.frame.draft);
  text.add("hull.mirror", own.mirror);
}

void describe(Text& text, const IceMaterial& ice) {
  text.add("ice.h", ice.h);
  text.add("ice.rho", ice.rho);
  text.add("ice.E", ice.E);
  text.add("ice.nu", ice.nu);
  text.add("ice.s0", ice.s0);
  text.add("ice.K_I", ice.K_I);
  text.add("ice.crushing_pressure", ice.crushing_pressure);
}

void describe(Text& text, const Numerics& numerics) {
  text.add("numerics.dx", numerics.dx);
  text.add("numerics.horizon_ratio", numerics.horizon_ratio);
  text.add("numerics.dt", numerics.dt);
  text.add("numerics.dt_fraction", numerics.dt_fraction);
  text.add("numerics.surface_correction", numerics.surface_correction);
  text.add("numerics.linear_below", numerics.linear_below);
  text.add("numerics.precision", numerics.precision);
  text.add("numerics.contact", numerics.contact);
  text.add("numerics.friction", numerics.friction);
}

}  // namespace

bool asks_for(const Json& document, const std::string& evaluator) {
  if (!document.contains("evaluators")) return true;
  const Json& list = document.at("evaluators");
  return std::find(list.begin(), list.end(), Json(evaluator)) != list.end();
}

std::string evaluation_text(const Case& c, bool use_lindqvist, bool use_peridynamics) {
  Text text;
  text.add("icebow.result_version", result_version);
  text.add("use_lindqvist", use_lindqvist);
  text.add("use_peridynamics", use_peridynamics);
  text.add("lambda", c.lambda);
  if (c.own.given()) {
    describe(text, c.own);  // all that is measured follows
    if (is_deformed(c)) describe(text, c.bow.angles);
  } else {
    describe(text, c.bow);
  }
  describe(text, c.ice);
  text.add("flexural_strength", c.flexural_strength);
  text.add("water.rho", c.water.rho);
  text.add("water.buoyancy_and_gravity", c.water.buoyancy_and_gravity);
  text.add("sheet.length", c.sheet.length);
  text.add("sheet.width", c.sheet.width);
  text.add("sheet.fixed", c.sheet.fixed);
  text.add("sheet.window_ahead", c.sheet.window_ahead);
  describe(text, c.numerics);
  text.add("V", c.V);
  text.add("advance", c.advance);
  text.add("steady_from", c.steady_from);
  text.add("stop_when_ci95_below", c.stop_when_ci95_below);
  text.add("snapshots", c.snapshots);
  text.add("pictures", c.pictures);
  // As a stored result has it that is older than the choice.
  if (c.ice_model == IceModel::calibrated) text.add("virtual_tests.version", virtual_tests_version);
  if (c.seed != 0) text.add("seed", static_cast<double>(c.seed));
  if (c.sheet.half_model) text.add("sheet.half_model", c.sheet.half_model);
  if (c.water.added_mass > 0.0) text.add("water.added_mass", c.water.added_mass);
  if (c.water.inertia != WaterInertia::layer) text.add("water.inertia", c.water.inertia);
  if (c.water.drag > 0.0) text.add("water.drag", c.water.drag);
  if (c.sheet.absorbing > 0.0) text.add("sheet.absorbing", c.sheet.absorbing);
  if (c.numerics.floe_contact) text.add("numerics.floe_contact", true);
  if (c.snapshot_format != SnapshotFormat::vtp) text.add("snapshot_format", c.snapshot_format);
  return text.str();
}

std::string evaluation_key(const Case& c, bool use_lindqvist, bool use_peridynamics) {
  return sha256(evaluation_text(c, use_lindqvist, use_peridynamics));
}

}  // namespace icebow
