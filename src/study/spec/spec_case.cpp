#include "study/spec/spec_case.h"

#include <algorithm>
#include <cmath>

#include "base/units.h"
#include "hullgen/bow/bow_angles.h"
#include "hullgen/bow/family.h"
#include "solver/tank/virtual_tests.h"
#include "study/spec/spec_derived.h"
#include "study/spec/spec_hints.h"
#include "study/spec/spec_hold.h"
#include "study/spec/spec_hull.h"
#include "study/spec/spec_scenarios.h"

namespace icebow {
namespace {

constexpr double most_particles = 2e9;

struct Sections {
  Mistakes of_no_bow;  // what a hull of the user's own makes up for
  Section bow, ice, water, sheet, operation, solver, cycle;

  Sections(const Json& d, double lambda, Mistakes& m)
      : bow(d, "bow", lambda, d.contains("hull") ? of_no_bow : m),
        ice(d, "ice", lambda, m),
        water(d, "water", lambda, m),
        sheet(d, "sheet", lambda, m),
        operation(d, "operation", lambda, m),
        solver(d, "solver", lambda, m),
        cycle(d, "cycle", lambda, m) {}
};

double lambda_of(const Json& document, Mistakes& mistakes) {
  const auto scale = document.find("scale");
  const Key& key = *find_key("", "scale");
  if (scale == document.end()) return key.fallback;
  if (scale->is_number() && scale->get<double>() >= key.lower && scale->get<double>() <= key.upper) {
    return scale->get<double>();
  }
  const std::string wrong = scale->is_number() ? ", allowed " : ", must be a number, allowed ";
  mistakes.push_back(
      {"/scale", "is " + shown(*scale) + wrong + range_in_words(key, units_of(key.quantity).front())});
  return key.fallback;
}

double given_or(const Section& section, const std::string& key, double fallback) {
  return section.has(key) ? section.number(key) : fallback;
}

// Two protocols: docs/study_file.md, "Angles".
void read_angles(Section& s, BowParameters& bow) {
  const double stem = s.number("stem"), waterline = s.number("waterline"), buttock = s.number("buttock");
  if (s.text("angles_at", "") != "quarter_beam") {
    bow.angles = {stem, waterline, buttock, s.number("flare")};
    s.require("flare",
              "(flare angle, from the vertical, at B/4 on the design waterline); add it, or give the "
              "waterline angle at B/4 and \"angles_at\": \"quarter_beam\"");
    s.refuse("entrance",
             "is the waterline angle once more: drop it, or give the waterline angle at B/4 and "
             "\"angles_at\": \"quarter_beam\"");
    return;
  }
  bow.angles_at = AnglesAt::quarter_beam;
  bow.angles = angles_at_quarter_beam(stem, waterline, buttock, given_or(s, "entrance", waterline));
  s.refuse("flare",
           "follows from waterline and buttock angle where \"angles_at\" is \"quarter_beam\": drop it, or "
           "that");
}

// What only one family has.
void read_features(Section& s, BowParameters& bow) {
  const FamilyForm& form = family_form(bow.family);
  if (form.reamers) bow.reamer_step = given_or(s, "reamer_step", usual_reamer_step * bow.B);
  if (form.chines) bow.chine = given_or(s, "chine", usual_chine);
  const std::string other = std::string("is not known to the family ") + form.key + ": drop it, or choose ";
  if (s.text("family", "").empty()) return;  // a mistake that is noted already
  if (!form.reamers) s.refuse("reamer_step", other + "spoon_reamers");
  if (!form.chines) s.refuse("chine", other + "semi_spoon_chines");
}

// What stands in the centre plane, in any family.
CentrePlane read_centre(Section& s) {
  CentrePlane centre;
  centre.stem_radius = given_or(s, "stem_radius", 0.0);
  centre.knife_height = given_or(s, "ice_knife_height", 0.0);
  centre.knife_width = given_or(s, "ice_knife_width", 0.0);
  centre.knife_angle = given_or(s, "ice_knife_angle", centre.knife_angle);
  centre.skeg_height = given_or(s, "skeg_height", 0.0);
  centre.skeg_length = given_or(s, "skeg_length", 0.0);
  centre.skeg_width = given_or(s, "skeg_width", 0.0);
  centre.skeg_angle = given_or(s, "skeg_angle", centre.skeg_angle);
  if (!s.has("ice_knife_height"))
    for (const char* key : {"ice_knife_width", "ice_knife_angle"})
      s.refuse(key, "is of an ice knife, which the bow has not: give ice_knife_height_m too, or drop this");
  if (s.has("skeg_height"))
    s.require("skeg_length", "(length of the skeg at its root); add it, or drop skeg_height");
  else
    for (const char* key : {"skeg_length", "skeg_width", "skeg_angle"})
      s.refuse(key, "is of a skeg, which the bow has not: give skeg_height_m too, or drop this");
  return centre;
}

BowParameters read_bow(Section& s) {
  BowParameters bow;
  bow.family = family_of_key(s.text("family", ""));
  read_angles(s, bow);
  bow.L = s.number("length");
  bow.B = s.number("beam");
  bow.T = s.number("draft");
  bow.D = s.number("depth");
  bow.Lf = s.number("bow_length");
  read_features(s, bow);
  bow.centre = read_centre(s);
  bow.panel = given_or(s, "panel", 0.0);
  // The default belt of a ship would reach through the bottom and the deck of a boat.
  bow.belt_below = given_or(s, "belt_below", std::min(s.number("belt_below"), 0.5 * bow.T));
  bow.belt_above = given_or(s, "belt_above", std::min(s.number("belt_above"), 0.5 * (bow.D - bow.T)));
  return bow;
}

// Compressive over flexural strength of ice of which only the latter is known. Sea ice has 3 to 5 (Timco and
// Weeks 2010), model ice less.
constexpr double usual_compressive = 3.0;

// Bonds break at a stretch, given by it or by the toughness; or by stress, calibrated to the flexural
// strength.
void read_fracture(Section& s, Case& c) {
  if (s.text("model", "calibrated") == "paper") {
    c.ice.s0 = given_or(s, "critical_stretch", 0.0);
    c.ice.K_I = s.has("critical_stretch") ? 0.0 : s.number("fracture_toughness");
    return;
  }
  c.ice_model = IceModel::calibrated;
  for (const char* given : {"fracture_toughness", "critical_stretch"}) {
    s.refuse(given,
             "cannot be given where \"model\" is \"calibrated\", which it is where nothing is said: bonds "
             "then break by "
             "their stress, found from the flexural strength, and the toughness follows. Drop it, or add "
             "\"model\": "
             "\"paper\"");
  }
}

void read_ice(Section& s, Case& c) {
  c.ice.h = s.number("thickness");
  c.ice.rho = s.number("density");
  c.ice.E = s.number("elastic_modulus");
  c.ice.nu = s.number("poisson");
  read_fracture(s, c);
  c.flexural_strength = s.number("flexural_strength");
  const bool calibrated = c.ice_model == IceModel::calibrated;
  c.compressive_strength =
      given_or(s, "compressive_strength", calibrated ? usual_compressive * c.flexural_strength : 0.0);
  c.numerics.friction = s.number("friction");
}

FixedEdges fixed_edges(const std::string& text) {
  if (text == "none") return FixedEdges::none;
  return text == "sides_and_far" ? FixedEdges::sides_and_far : FixedEdges::sides;
}

ContactRule contact_rule(const std::string& text) {
  if (text == "paper") return ContactRule::paper;
  if (text == "crushing") return ContactRule::crushing;
  return text == "penalty" ? ContactRule::penalty : ContactRule::relocation;
}

void read_contact(const Section& solver, Section& ice, Case& c) {
  const bool calibrated = c.ice_model == IceModel::calibrated;
  c.numerics.contact = contact_rule(solver.text("contact", calibrated ? "crushing" : "relocation"));
  if (c.numerics.contact != ContactRule::crushing) return;
  if (!calibrated)
    ice.require("compressive_strength",
                "is missing: the contact rule \"crushing\" needs it (/solver/contact)");
  c.ice.crushing_pressure = c.compressive_strength;
}

std::uint64_t seed_of(const Section& s) {
  const double seed = s.number("seed");
  return std::isnan(seed) ? 0 : static_cast<std::uint64_t>(seed);
}

CycleSettings read_cycle(const Section& s, const Case& c) {
  CycleSettings cycle;
  const std::string rule = s.text("breaking", "literature");
  cycle.rule.type = rule == "plate"        ? cycle::Breaking::plate
                    : rule == "calibrated" ? cycle::Breaking::calibrated
                                           : cycle::Breaking::literature;
  cycle.rule.C = s.number("capacity"), cycle.rule.C_l = s.number("cusp"),
  cycle.rule.C_v = s.number("cusp_change_s_m");
  const double usual =
      c.compressive_strength > 0.0 ? c.compressive_strength : usual_compressive * c.flexural_strength;
  cycle.crushing_pressure = given_or(s, "crushing_pressure", usual);
  cycle.voyage = s.number("voyage"), cycle.voyages = s.integer("voyages"), cycle.seed = seed_of(s);
  cycle.scatter = s.number("scatter"), cycle.step = s.number("step"), cycle.raster = s.number("raster");
  cycle.symmetric = s.boolean("symmetric"), cycle.submersion = s.boolean("submersion");
  cycle.submersion_by_hull = s.text("submersion_by", "hull") != "lindqvist";
  return cycle;
}

// Lengths not given follow from the ship: see docs/study_file.md, "Defaults in terms of the ship".
void read_operation_and_sheet(const Section& operation, const Section& sheet, Case& c) {
  c.V = operation.number("speed");
  c.advance = given_or(operation, "advance", c.bow.Lf + 2.2 * c.bow.B);
  c.steady_from = given_or(operation, "steady_from", std::min(c.bow.Lf, 0.5 * c.advance));
  c.stop_when_ci95_below = given_or(operation, "stop_when_ci95_below", 0.0);
  c.sheet.window_ahead = given_or(sheet, "window_ahead", 0.0);
  const double ahead = c.sheet.window_ahead > 0.0 ? c.sheet.window_ahead : c.advance;
  c.sheet.length = given_or(sheet, "length", ahead + c.bow.Lf + c.bow.B);
  c.sheet.width = given_or(sheet, "width", 3.5 * c.bow.B);
  c.sheet.fixed = fixed_edges(sheet.text("fixed_edges", "sides"));
  c.sheet.absorbing = sheet.number("absorbing");
}

void read_numerics(const Section& s, double thickness, Numerics& numerics) {
  numerics.dx = s.has("spacing") ? s.number("spacing") : thickness / s.number("layers");
  numerics.horizon_ratio = s.number("horizon_ratio");
  numerics.dt = given_or(s, "time_step", 0.0);
  numerics.dt_fraction = s.number("time_step_fraction");
  numerics.surface_correction = s.boolean("surface_correction");
  numerics.linear_below = s.number("linear_below");
  numerics.precision = s.text("precision", "fp32") == "fp64" ? Precision::fp64 : Precision::fp32;
}

// Of the study's ice: what calibrated ice needs to carry a load between its failures, which the published
// model does not have (docs/study_file.md, "Defaults of the ice").
constexpr double usual_added_mass = 4.0;  // thicknesses: floes 6 to 10 thicknesses wide
constexpr double usual_drag = 1.2;        // of a square plate across the flow

// Of ice on ice: the middle of what was measured in the field on natural surfaces, 0.48 where they slide for
// the first time and 0.05 once they are polished, at any speed (Sukhorukov and Loset 2013).
constexpr double usual_friction_between_pieces = 0.3;

void read_surroundings(const Section& ice, const Section& water, const Section& solver, const Section& sheet,
                       Case& c) {
  const bool calibrated = c.ice_model == IceModel::calibrated, afloat = water.boolean("buoyancy_and_gravity"),
             with_water = calibrated && afloat;
  c.water = {water.number("density"), afloat,
             water.text("inertia", "layer") == "plane" ? WaterInertia::plane : WaterInertia::layer,
             given_or(water, "added_mass", with_water ? usual_added_mass * c.ice.h : 0.0),
             given_or(water, "drag", with_water ? usual_drag : 0.0)};
  c.numerics.floe_contact = solver.has("floe_contact") ? solver.boolean("floe_contact") : calibrated;
  c.numerics.floe_friction =
      given_or(ice, "friction_between_pieces",
               calibrated && c.numerics.floe_contact ? usual_friction_between_pieces : 0.0);
  // A hull of the user's own need not be its own mirror image.
  const bool symmetric = !c.own.given() || c.own.mirror;
  c.sheet.half_model = sheet.has("half_model") ? sheet.boolean("half_model") : calibrated && symmetric;
}

std::string metres(double value) {
  return brief(value) + " m";
}

// Values that are each allowed but make no sense together. NaN (a value already refused) never compares true.
// Lengths in the messages are full scale.
void check_ship(const Case& c, const Sections& s, Mistakes& m) {
  if (c.bow.T >= c.bow.D) {
    m.push_back({s.bow.pointer("draft"), "is " + metres(c.bow.T) + ", not less than the depth of " +
                                             metres(c.bow.D) + "; a ship needs freeboard"});
  }
  if (c.bow.B >= c.bow.L) {
    m.push_back({s.bow.pointer("beam"),
                 "is " + metres(c.bow.B) + ", not less than the length of " + metres(c.bow.L)});
  }
  if (c.bow.Lf >= c.bow.L) {
    m.push_back({s.bow.pointer("bow_length"),
                 "is " + metres(c.bow.Lf) + ", not less than the length of " + metres(c.bow.L)});
  }
  if (c.water.buoyancy_and_gravity && c.ice.rho >= c.water.rho) {
    m.push_back({s.ice.pointer("density"), "is " + brief(c.ice.rho) + " kg/m3, not less than the water's " +
                                               brief(c.water.rho) + " kg/m3; such ice does not float"});
  }
}

void check_run(const Case& c, const Sections& s, Mistakes& m) {
  if (c.sheet.width <= bow_beam(c.bow)) {
    m.push_back({s.sheet.pointer("width"), "is " + metres(c.sheet.width) + ", not wider than the beam of " +
                                               metres(bow_beam(c.bow)) + "; 3.5 beams is usual"});
  }
  if (c.sheet.window_ahead > 0.0 && c.sheet.length < c.sheet.window_ahead + c.bow.Lf) {
    m.push_back({s.sheet.pointer("length"),
                 "is " + metres(c.sheet.length) + ": a window with " + metres(c.sheet.window_ahead) +
                     " ahead of the stem must also hold the bow, " + metres(c.bow.Lf) +
                     " long; make it at least " + metres(c.sheet.window_ahead + c.bow.Lf) +
                     " or shorten /sheet/window_ahead_m"});
  }
  if (c.sheet.window_ahead == 0.0 && c.sheet.length <= c.advance) {
    m.push_back({s.sheet.pointer("length"),
                 "is " + metres(c.sheet.length) + ", but the ship advances " + metres(c.advance) +
                     ": it would sail out of the ice; lengthen the sheet or shorten /operation/advance_m"});
  }
  if (c.numerics.floe_friction > 0.0 && !c.numerics.floe_contact) {
    m.push_back(
        {s.ice.pointer("friction_between_pieces"),
         "is " + brief(c.numerics.floe_friction) +
             ", but pieces pass through each other; give /solver/floe_contact true, or leave it out"});
  }
  if (c.steady_from >= c.advance) {
    m.push_back({s.operation.pointer("steady_from"),
                 "is " + metres(c.steady_from) + ", not less than the advance of " + metres(c.advance) +
                     ": no record is left for the metrics"});
  }
  const double layers = c.ice.h / c.numerics.dx;
  if (layers < 1.0 - 1e-9) {
    m.push_back({s.solver.pointer("spacing"), "is " + metres(c.numerics.dx) + ", coarser than the ice of " +
                                                  metres(c.ice.h) + ": less than one layer of particles"});
  }
  if (c.ice_model == IceModel::calibrated && layers >= 1.0 - 1e-9 &&
      (layers < 1.5 || layers >= most_tested_layers + 0.5)) {
    m.push_back(
        {s.solver.pointer(s.solver.has("spacing") ? "spacing" : "layers"),
         "makes " + brief(std::round(layers)) + " layers: ice of the model \"calibrated\" has 2 to " +
             std::to_string(most_tested_layers) +
             ". A single layer cannot bend, and a beam of more takes long to break; change the layers "
             "or choose \"model\": \"paper\""});
  }
  const double width = c.sheet.width / (c.sheet.half_model ? 2 : 1);
  const double particles = c.sheet.length * width * c.ice.h / std::pow(c.numerics.dx, 3);
  if (particles > most_particles) {
    m.push_back({s.solver.pointer(s.solver.has("spacing") ? "spacing" : "layers"),
                 "makes about " + brief(particles) + " particles, at most " + brief(most_particles) +
                     "; coarsen the lattice or shrink the sheet"});
  }
}

}  // namespace

Case parse_case(const Json& given, Mistakes& mistakes) {
  Json derived;
  if (given.contains("derived")) {
    derived = given;
    apply_derived(derived, mistakes);
  }
  const Json& document = given.contains("derived") ? derived : given;
  Case c;
  c.lambda = lambda_of(document, mistakes);
  Sections s(document, c.lambda, mistakes);
  if (document.contains("hull")) {
    read_hull(document, c, mistakes);
  } else {
    c.bow = read_bow(s.bow);
  }
  read_ice(s.ice, c);
  read_operation_and_sheet(s.operation, s.sheet, c);
  read_numerics(s.solver, c.ice.h, c.numerics);
  read_surroundings(s.ice, s.water, s.solver, s.sheet, c);
  read_contact(s.solver, s.ice, c);
  c.seed = seed_of(s.solver);
  c.cycle = read_cycle(s.cycle, c);
  const Section output(document, "output", c.lambda, mistakes);
  c.snapshots = output.integer("snapshots");
  c.pictures = output.integer("pictures");
  if (output.text("format", "vtp") == "vtkhdf") c.snapshot_format = SnapshotFormat::vtkhdf;
  check_ship(c, s, mistakes);
  check_run(c, s, mistakes);
  check_hold(document, c, mistakes);
  read_scenarios(document, parse_case, c, mistakes);
  return c;
}

Case read_case(const Json& document, const std::string& name) {
  Mistakes mistakes;
  if (!document.is_object())
    throw InputError(name, {{"", "is " + type_name(document) + ", must be an object"}});
  const Case c = parse_case(document, mistakes);
  if (!mistakes.empty()) throw InputError(name, std::move(mistakes));
  return c;
}

}  // namespace icebow
