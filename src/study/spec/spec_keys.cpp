#include "study/spec/spec_keys.h"

#include <algorithm>
#include <limits>
#include <map>
#include <utility>

#include "base/units.h"
#include "hullgen/bow/family.h"
#include "study/spec/spec_hints.h"

namespace icebow {
namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();
constexpr double any = 9007199254740992.0;  // 2^53: every integer below has a double

// clang-format off
// Ranges are wide enough for a full-scale ship and for its model in the tank.
const std::vector<Key> table = {
  // section, name, quantity, lowest, highest, required, default, default in words, meaning, choices
  {"", "icebow_study", Quantity::integer, 1, 1, true, none, "", "version of the format", {}},
  {"", "name", Quantity::text, 0, 0, false, none, "the file's name", "title of the study", {}},
  {"", "purpose", Quantity::text, 0, 0, false, none, "empty", "what the study is to find out; printed in the report", {}},
  {"", "scale", Quantity::number, 1, 1000, false, 25, "25", "lambda: full scale / simulated model; 1 simulates at full scale", {}},
  {"", "include_baseline", Quantity::boolean, 0, 0, false, 1, "true", "evaluate the file's own design, named \"baseline\", first", {}},
  {"", "repeats", Quantity::integer, 1, 100, false, 1, "1", "each design is simulated so many times, with /solver/seed counted up from the file's; the ranking goes by the mean of the runs and its interval by their scatter", {}},

  {"bow", "family", Quantity::choice, 0, 0, true, none, "", "which form the bow has", family_keys()},
  {"bow", "length", Quantity::length, 0.5, 600, true, none, "", "length between perpendiculars L", {}},
  {"bow", "beam", Quantity::length, 0.05, 120, true, none, "", "moulded beam B", {}},
  {"bow", "draft", Quantity::length, 0.02, 50, true, none, "", "draught T to the design waterline", {}},
  {"bow", "depth", Quantity::length, 0.03, 80, true, none, "", "moulded depth D, keel to deck", {}},
  {"bow", "bow_length", Quantity::length, 0.01, 300, true, none, "", "length of the bow along the design waterline, stem to full beam", {}},
  {"bow", "angles_at", Quantity::choice, 0, 0, false, none, "stem_and_quarter_beam", "where the waterline angle is given: at the stem, with the flare at B/4, or at B/4 like the buttock angle, from which the flare follows", {"stem_and_quarter_beam", "quarter_beam"}},
  {"bow", "stem", Quantity::angle, 5, 85, true, none, "", "stem angle, from the horizontal, at the centre plane on the design waterline", {}},
  {"bow", "waterline", Quantity::angle, 5, 90, true, none, "", "waterline angle, from the centre plane, at the stem (entrance angle), or where angles_at says", {}},
  {"bow", "entrance", Quantity::angle, 5, 90, false, none, "the waterline angle: straight from stem to B/4", "waterline angle at the stem; only with angles_at quarter_beam", {}},
  {"bow", "buttock", Quantity::angle, 5, 85, true, none, "", "buttock angle, from the horizontal, at B/4 on the design waterline", {}},
  {"bow", "flare", Quantity::angle, 1, 89, false, none, "none: required unless angles_at is quarter_beam", "flare angle, from the vertical, at B/4 on the design waterline", {}},
  {"bow", "reamer_step", Quantity::length, 0.0005, 12, false, none, "0.03 B", "the bow is wider than the beam by this on either side; only spoon_reamers", {}},
  {"bow", "chine", Quantity::number, innermost_chine, outermost_chine, false, none, "0.8", "where the crease runs, as a share of the half-beam; only semi_spoon_chines", {}},
  {"bow", "stem_radius", Quantity::length, 0, 12, false, none, "0: a sharp stem", "radius of the stem bar in the design waterline; the angles are those outside it", {}},
  {"bow", "ice_knife_height", Quantity::length, 0, 45, false, none, "0: no ice knife", "height of the ice knife under the forefoot, from the keel up to where its edge leaves the stem", {}},
  {"bow", "ice_knife_angle", Quantity::angle, 10, 90, false, none, "90 deg", "angle of the ice knife's edge against the horizontal; with ice_knife_height", {}},
  {"bow", "ice_knife_width", Quantity::length, 0.0005, 12, false, none, "that of the stem bar, or B/40", "breadth of the ice knife where it meets the bow, tapering to its edge; with ice_knife_height", {}},
  {"bow", "skeg_height", Quantity::length, 0, 25, false, none, "0: no skeg", "the skeg under the bottom's centreline reaches this far below the bottom, and below draft", {}},
  {"bow", "skeg_length", Quantity::length, 0.001, 600, false, none, "none: required with skeg_height", "length of the skeg at its root, from the fore end of the bottom aft", {}},
  {"bow", "skeg_angle", Quantity::angle, 10, 80, false, none, "45 deg", "angle of the skeg's two ends against the horizontal; with skeg_height", {}},
  {"bow", "skeg_width", Quantity::length, 0.0005, 12, false, none, "that of the stem bar, or B/40", "breadth of the skeg at its root, tapering to its foot; with skeg_height", {}},
  {"bow", "panel", Quantity::length, 0.0005, 20, false, none, "B/60", "wanted edge length of a hull panel in the ice belt", {}},
  {"bow", "belt_below", Quantity::length, 0.001, 30, false, 1.5, "1.5 m full scale", "the ice belt reaches this far below the design waterline", {}},
  {"bow", "belt_above", Quantity::length, 0.001, 30, false, 1.0, "1.0 m full scale", "the ice belt reaches this far above the design waterline", {}},

  {"hold", "displacement", Quantity::volume, 1e-6, 1e7, false, none, "that of the file's own bow", "volume under the design waterline that every bow of the study displaces, full scale", {}},
  {"hold", "by", Quantity::choice, 0, 0, false, none, "length", "the dimension of the ship that follows, in place of the one in bow", {"length", "beam", "draft"}},

  {"hull", "file", Quantity::text, 0, 0, true, none, "", "the user's own hull, instead of `bow`: a mesh (.obj, .stl, .ply), surfaces (.step, .igs) or offsets (.csv), from the study file's directory; closed, or one side of a closed hull", {}},
  {"hull", "unit", Quantity::choice, 0, 0, false, none, "m", "unit of the file's coordinates", {"m", "cm", "mm", "ft", "in"}},
  {"hull", "factor", Quantity::number, 1e-4, 1e4, false, 1, "1", "the file's lengths are multiplied by this as well, to be full scale: 25 for the mesh of a 1:25 model", {}},
  {"hull", "forward", Quantity::choice, 0, 0, false, none, "x", "axis of the file that points forward", {"x", "y", "z", "-x", "-y", "-z"}},
  {"hull", "up", Quantity::choice, 0, 0, false, none, "z", "axis of the file that points up", {"x", "y", "z", "-x", "-y", "-z"}},
  {"hull", "left_handed", Quantity::boolean, 0, 0, false, 0, "false", "the file's axes x, y, z are left-handed: port and starboard change places", {}},
  {"hull", "draft", Quantity::length, 0.02, 50, false, none, "as waterline_height says", "draught to the waterline, from the mesh's lowest point; instead of waterline_height", {}},
  {"hull", "waterline_height", Quantity::length, -1000, 1000, false, none, "0", "height of the waterline along the up axis, full scale; instead of draft", {}},
  {"hull", "mirror", Quantity::boolean, 0, 0, false, 0, "false", "the file has one side of the hull, up to its own centre plane: add the other", {}},
  {"hull", "outer_surface", Quantity::boolean, 0, 0, false, 0, "false", "the file has an open boat with its plating: take its outside, closed by a deck", {}},
  {"hull", "stem", Quantity::angle, 5, 85, false, none, "as measured", "the bow is deformed to this stem angle", {}},
  {"hull", "waterline", Quantity::angle, 5, 90, false, none, "as measured", "the bow is deformed to this waterline angle at the stem", {}},
  {"hull", "buttock", Quantity::angle, 5, 85, false, none, "as measured", "the bow is deformed to this buttock angle at B/4", {}},
  {"hull", "flare", Quantity::angle, 1, 89, false, none, "as measured", "the bow is deformed to this flare angle at B/4", {}},

  {"ice", "thickness", Quantity::length, 0.001, 10, true, none, "", "thickness h of the level ice", {}},
  {"ice", "density", Quantity::density, 500, 1000, false, 900, "900 kg/m3", "density of the ice", {}},
  {"ice", "elastic_modulus", Quantity::stress, 1e4, 2e10, false, 1.3e9, "1.3 GPa full scale", "Young's modulus E", {}},
  {"ice", "poisson", Quantity::number, 0.05, 0.45, false, 0.33, "0.33", "Poisson's ratio", {}},
  {"ice", "model", Quantity::choice, 0, 0, false, none, "calibrated", "where the simulation has its modulus and strength from: found so that virtual tests of the lattice return elastic_modulus, flexural_strength and compressive_strength, bonds breaking by normal stress; or, in the published model, as given, bonds breaking at a critical stretch", {"calibrated", "paper"}},
  {"ice", "flexural_strength", Quantity::stress, 100, 1e8, false, 5e5, "500 kPa full scale", "flexural strength, for the formulas and for the model calibrated", {}},
  {"ice", "compressive_strength", Quantity::stress, 100, 1e9, false, none, "3 flexural_strength where the model is calibrated", "uniaxial compressive strength: the pressure at which the hull crushes the ice, with solver.contact \"crushing\"; else only compared with by `icebow calibrate`", {}},
  {"ice", "fracture_toughness", Quantity::toughness, 10, 1e9, false, 7.5e6, "7.5 MPa sqrt(m) full scale", "model paper: toughness from which the simulation takes its critical stretch; instead of critical_stretch", {}},
  {"ice", "critical_stretch", Quantity::number, 1e-6, 0.5, false, none, "from the toughness", "model paper: stretch at which a bond breaks; instead of fracture_toughness", {}},
  {"ice", "friction", Quantity::number, 0, 1, false, 0.1, "0.1", "Coulomb friction coefficient between hull and ice", {}},
  {"ice", "friction_between_pieces", Quantity::number, 0, 1, false, none, "0.3 where the ice is calibrated and its pieces push each other, else 0", "Coulomb friction coefficient of ice on ice; with solver.floe_contact", {}},

  {"water", "density", Quantity::density, 900, 1100, false, 1025, "1025 kg/m3", "density of the water", {}},
  {"water", "buoyancy_and_gravity", Quantity::boolean, 0, 0, false, 1, "true", "the sheet floats; false: it is held by its fixed edges alone, as in the paper", {}},
  {"water", "inertia", Quantity::choice, 0, 0, false, none, "layer", "water that ice accelerating across its plane moves with it: a layer of added_mass under each column; or, under ice that lies in the sheet's plane, all of it (docs/theory.md)", {"layer", "plane"}},
  {"water", "added_mass", Quantity::length, 0, 100, false, none, "4 thicknesses where the ice is calibrated and afloat, else 0", "depth of the layer of water that goes with ice accelerating across its plane, with inertia plane with what has left that; 0 = none", {}},
  {"water", "drag", Quantity::number, 0, 10, false, none, "1.2 where the ice is calibrated and afloat, else 0", "drag coefficient of a plate of ice that moves across its plane under water, 1.2 for a square plate; 0 = none", {}},

  {"sheet", "length", Quantity::length, 0.05, 20000, false, none, "advance + bow_length + B", "extent of the sheet along the course", {}},
  {"sheet", "width", Quantity::length, 0.05, 20000, false, none, "3.5 B", "extent of the sheet across the course, centred on the ship", {}},
  {"sheet", "window_ahead", Quantity::length, 0.05, 20000, false, none, "no window", "the sheet is a window of this length that moves with the ship: fresh ice is laid so that this much lies ahead of the stem, the channel is dropped astern", {}},
  {"sheet", "fixed_edges", Quantity::choice, 0, 0, false, none, "sides", "edges held fast: none, port and starboard, or the edge ahead as well", {"none", "sides", "sides_and_far"}},
  {"sheet", "absorbing", Quantity::length, 0, 20000, false, 0, "0", "the ice is damped within this distance of the side edges and the edge ahead, so that waves that run out to them do not come back; one characteristic length is usual; 0 = not", {}},
  {"sheet", "half_model", Quantity::boolean, 0, 0, false, none, "true where the ice is calibrated and the hull generated or mirrored, else false", "simulate the port half and take starboard for its mirror image, for half the work: both sides break at once, so the mean is as good, its scatter and peaks up to a third higher (docs/validation.md), and no load sways or turns the ship", {}},

  {"operation", "speed", Quantity::speed, 0.001, 20, true, none, "", "speed V of the ship, constant", {}},
  {"operation", "advance", Quantity::length, 0.001, 20000, false, none, "bow length + 2.2 B", "distance sailed from first touch to the end of the run", {}},
  {"operation", "steady_from", Quantity::length, 0, 20000, false, none, "the bow's length, at most half the advance", "metrics use the record from this advance on", {}},
  {"operation", "stop_when_ci95_below", Quantity::number, 0.01, 1, false, none, "the whole advance is run", "end the run once the half width of the mean load's 95 % interval is at most this part of the mean", {}},

  {"solver", "spacing", Quantity::length, 0.0001, 5, false, none, "thickness / layers", "lattice spacing; instead of layers", {}},
  {"solver", "layers", Quantity::integer, 1, 50, false, 3, "3", "particles through the thickness; instead of spacing", {}},
  {"solver", "horizon_ratio", Quantity::number, 1.5, 3.9, false, 3, "3", "horizon / spacing", {}},
  {"solver", "time_step", Quantity::time, 1e-8, 1, false, none, "time_step_fraction of the limit", "time step; instead of time_step_fraction", {}},
  {"solver", "time_step_fraction", Quantity::number, 0.01, 1, false, 0.95, "0.95", "time step as a fraction of the stability limit; instead of time_step", {}},
  {"solver", "surface_correction", Quantity::boolean, 0, 0, false, 1, "true", "correct the stiffness of particles near a surface", {}},
  {"solver", "linear_below", Quantity::number, 0, 0.01, false, 1e-3, "0.001", "ice whose displacement gradient is below this follows the linearised bond law, at a fraction of the cost; 0 = nowhere", {}},
  {"solver", "precision", Quantity::choice, 0, 0, false, none, "fp32", "floating point of displacements and velocities; sums over the sheet are exact in both", {"fp32", "fp64"}},
  {"solver", "contact", Quantity::choice, 0, 0, false, none, "relocation; crushing where the ice is calibrated", "contact rule between hull and ice", {"relocation", "paper", "penalty", "crushing"}},
  {"solver", "floe_contact", Quantity::boolean, 0, 0, false, none, "true where the ice is calibrated, else false", "pieces of ice push back what they meet; false: they pass through each other", {}},
  {"solver", "seed", Quantity::integer, 0, any, false, 0, "0", "start of the random numbers by which the ice has small velocities of its own when the run begins, so that runs with different seeds break differently; 0 = at rest", {}},

  {"cycle", "breaking", Quantity::choice, 0, 0, false, none, "literature", "how an edge breaks: by the numbers of ship simulators, by plate theory, or by patch tests of this study's own ice (docs/cycle.md)", {"literature", "plate", "calibrated"}},
  {"cycle", "voyage", Quantity::length, 1, 20000, false, 200, "200 m full scale", "length of each voyage, counted from where the bow has entered", {}},
  {"cycle", "voyages", Quantity::integer, 1, 1000, false, 3, "3", "voyages, with the seeds counted up; the mean load is theirs", {}},
  {"cycle", "seed", Quantity::integer, 0, any, false, 1, "1", "seed of the first voyage: of the scatter of its pieces", {}},
  {"cycle", "scatter", Quantity::number, 0, 0.9, false, 0.3, "0.3", "the pieces' radii vary evenly by this part either way; 0 locks them into a pattern", {}},
  {"cycle", "crushing_pressure", Quantity::stress, 100, 1e9, false, none, "ice.compressive_strength, or 3 flexural_strength", "pressure at which the hull crushes the edge", {}},
  {"cycle", "capacity", Quantity::number, 0.05, 20, false, 0.8, "0.8", "literature: load that breaks an edge, over flexural strength x thickness^2", {}},
  {"cycle", "cusp", Quantity::number, 0.05, 3, false, 0.32, "0.32", "literature: radius of the pieces at rest over the characteristic length", {}},
  {"cycle", "cusp_change_s_m", Quantity::number, -5, 0, false, -0.14, "-0.14", "literature: relative change of the radius with the hull's normal speed [s/m]", {}},
  {"cycle", "symmetric", Quantity::boolean, 0, 0, false, 0, "false", "the port half and its mirror image instead of the whole ship", {}},
  {"cycle", "submersion", Quantity::boolean, 0, 0, false, 1, "true", "add what the broken ice costs on its way under and round the hull; false: breaking alone", {}},
  {"cycle", "submersion_by", Quantity::choice, 0, 0, false, none, "hull", "along the hull's own surface, or by Lindqvist's formula with its speed factor", {"hull", "lindqvist"}},
  {"cycle", "step", Quantity::number, 0.002, 0.2, false, 0.04, "0.04", "step of the way over the thickness", {}},
  {"cycle", "raster", Quantity::number, 0.02, 0.5, false, 1.0 / 7, "1/7", "width of the ice's strips along the waterline over the thickness", {}},

  {"output", "snapshots", Quantity::integer, 0, 10000, false, 0, "0", "ParaView snapshots of each run", {}},
  {"output", "format", Quantity::choice, 0, 0, false, none, "vtp", "files of the ice's snapshots: XML, a piece for each MPI rank, or one HDF5 file for millions of particles", {"vtp", "vtkhdf"}},
  {"output", "pictures", Quantity::integer, 0, 1000, false, 3, "3", "top-view pictures of each run", {}},

  {"method", "type", Quantity::choice, 0, 0, false, none, "list", "how designs are proposed", {"list", "grid", "one_at_a_time", "latin_hypercube", "sobol", "halton", "morris", "central_composite", "box_behnken", "table", "optimise"}},
  {"method", "file", Quantity::text, 0, 0, false, none, "none", "table: CSV with a column for each variable, headed by its pointer, and a line for each design, from the study file's directory", {}},
  {"method", "samples", Quantity::integer, 1, 100000, false, 10, "10", "latin_hypercube, sobol, halton: number of designs; morris: of trajectories, each of one design more than there are variables", {}},
  {"method", "replace_infeasible", Quantity::boolean, 0, 0, false, 0, "false", "latin_hypercube, sobol, halton: a bow that the margins rule out is replaced by the next feasible one of a sequence, and counted", {}},
  {"method", "seed", Quantity::integer, 0, any, false, 1, "1", "latin_hypercube, morris, optimise: seed of the random numbers", {}},
  {"method", "algorithm", Quantity::text, 0, 0, false, none, "cobyla", "optimise: which optimiser", {}},
  {"method", "max_evaluations", Quantity::integer, 1, 100000, false, 60, "60", "optimise: stop after this many points, the start among them", {}},
  {"method", "tolerance", Quantity::number, 0, 0.5, false, 0.01, "0.01", "optimise: stop when the parameters move less than this part of their range", {}},
  {"method", "initial", Quantity::integer, 0, 1000, false, 0, "2 (variables + 1)", "expected_improvement: points of the initial design, the start among them", {}},
  {"method", "batch", Quantity::integer, 1, 256, false, none, "execution.designs_at_once, or 1", "expected_improvement: points proposed at once after that, to be evaluated side by side", {}},
  {"method", "least_gain", Quantity::number, 0, 0.5, false, 0.001, "0.001", "expected_improvement: stop when the next point is expected to lower the best load by less than this part of it; 0 = never", {}},
  {"method", "prior", Quantity::choice, 0, 0, false, none, "cycle for loads of peridynamics, lindqvist for those of the cycle, else none", "expected_improvement: cheaper response that the model begins with", {"none", "lindqvist", "cycle"}},

  {"confirm", "best", Quantity::integer, 0, 1000, false, 3, "3", "simulate so many of the best designs by the cycle (docs/cycle.md, \"Two fidelities\")", {}},
  {"confirm", "spread", Quantity::integer, 0, 1000, false, 2, "2", "and so many far from those in the variables, the baseline first: the ratio of simulation and cycle is fitted over both", {}},

  {"decide", "best_within", Quantity::number, 0.001, 1, false, 0.05, "0.05", "the race is over once the design that leads is surely at most this part of its load above the lowest one (docs/study_engine.md, \"The race\")", {}},
  {"decide", "confidence", Quantity::number, 0.5, 0.9999, false, 0.95, "0.95", "how sure: a wrong answer comes in at most 1 - confidence of all races", {}},
  {"decide", "budget_core_h", Quantity::number, 0, 1e6, false, 0, "0", "no design is sailed on once the simulations have taken so many core hours; 0 = no limit", {}},
  {"decide", "longest", Quantity::length, 0.001, 200000, false, none, "operation.steady_from + 20 (advance - steady_from)", "no voyage is sailed farther", {}},

  {"ranking", "by", Quantity::text, 0, 0, false, none, "mean_load; lindqvist_breaking where only the formula is evaluated", "what is compared; smaller is better. mean_load is that of peridynamics where the study has it, else that of the cycle; or a load of a result by its pointer, like /programs/yard/resistance_N. A list of two weighs this against another number: \"Two objectives\"", {}},

  {"ranking", "over_scenarios", Quantity::choice, 0, 0, false, none, "mean", "with /scenarios: by the mean of the loads with the scenarios' weights, or by the worst", {"mean", "worst"}},

  {"execution", "ranks_per_design", Quantity::integer, 1, 4096, false, 1, "1", "MPI ranks for one design", {}},
  {"execution", "designs_at_once", Quantity::integer, 0, 4096, false, 0, "0", "designs that run side by side; 0 = as many as the ranks or cores allow", {}},
  {"execution", "time_limit", Quantity::time, 0, 1e8, false, 0, "0", "wall time after which a design is given up; 0 = none", {}},
  {"execution", "stop_at_failure_rate", Quantity::number, 0, 1, false, 0, "0", "the study ends once more than this part of five designs or more have failed; 0 = it does not", {}},
  {"execution", "launcher", Quantity::text, 0, 0, false, none, "mpirun -n {ranks} --oversubscribe --bind-to none for two ranks or more, else nothing", "words that start each design's process, like \"srun --exact -n {ranks}\"", {}},
};
// clang-format on

}  // namespace

const std::vector<Unit>& units_of(Quantity quantity) {
  static const std::vector<Unit> length = {{"_m", "m", 1.0}, {"_cm", "cm", 0.01}, {"_mm", "mm", 0.001}},
                                 speed = {{"_m_s", "m/s", 1.0}, {"_kn", "kn", metres_per_second_per_knot}},
                                 time = {{"_s", "s", 1.0}},
                                 angle = {{"_deg", "deg", radians(1.0)}, {"_rad", "rad", 1.0}},
                                 stress = {{"_Pa", "Pa", 1.0},
                                           {"_kPa", "kPa", 1e3},
                                           {"_MPa", "MPa", 1e6},
                                           {"_GPa", "GPa", 1e9}},
                                 toughness = {{"_Pa_sqrt_m", "Pa sqrt(m)", 1.0},
                                              {"_kPa_sqrt_m", "kPa sqrt(m)", 1e3},
                                              {"_MPa_sqrt_m", "MPa sqrt(m)", 1e6}},
                                 density = {{"_kg_m3", "kg/m3", 1.0}}, volume = {{"_m3", "m3", 1.0}},
                                 plain = {{"", "", 1.0}};
  switch (quantity) {
    case Quantity::length:
      return length;
    case Quantity::speed:
      return speed;
    case Quantity::time:
      return time;
    case Quantity::angle:
      return angle;
    case Quantity::stress:
      return stress;
    case Quantity::toughness:
      return toughness;
    case Quantity::density:
      return density;
    case Quantity::volume:
      return volume;
    default:
      return plain;
  }
}

double scale_exponent(Quantity quantity) {
  switch (quantity) {
    case Quantity::length:
      return scaling::length;
    case Quantity::speed:
      return scaling::speed;
    case Quantity::time:
      return scaling::time;
    case Quantity::stress:
      return scaling::stress;
    case Quantity::toughness:
      return scaling::toughness;
    default:
      return 0.0;
  }
}

const std::vector<Key>& study_keys() {
  return table;
}

std::vector<const Key*> keys_of_section(const std::string& section) {
  std::vector<const Key*> keys;
  for (const Key& key : table) {
    if (key.section == section) keys.push_back(&key);
  }
  return keys;
}

const Key* find_key(const std::string& section, const std::string& name) {
  for (const Key& key : table) {
    if (key.section == section && key.name == name) return &key;
  }
  return nullptr;
}

bool is_numeric(Quantity quantity) {
  return quantity != Quantity::boolean && quantity != Quantity::choice && quantity != Quantity::text;
}

std::string spelled(const Key& key) {
  return std::string(key.name) + units_of(key.quantity).front().suffix;
}

Spelling find_spelling(const std::string& section, const std::string& spelling) {
  static const auto all = [] {
    std::map<std::pair<std::string, std::string>, Spelling> spellings;
    for (const Key& key : table)
      for (const Unit& unit : units_of(key.quantity))
        spellings.emplace(std::pair(std::string(key.section), std::string(key.name) + unit.suffix),
                          Spelling{&key, &unit});
    return spellings;
  }();
  const auto found = all.find({section, spelling});
  return found == all.end() ? Spelling() : found->second;
}

Spelling find_pointer(const std::string& pointer) {
  if (pointer.empty() || pointer[0] != '/') return {};
  const std::size_t slash = pointer.find('/', 1);
  if (slash == std::string::npos) return find_spelling("", pointer.substr(1));
  return find_spelling(pointer.substr(1, slash - 1), pointer.substr(slash + 1));
}

double lower_in(const Key& key, const Unit& unit) {
  return key.lower * (units_of(key.quantity).front().to_si / unit.to_si);
}

double upper_in(const Key& key, const Unit& unit) {
  return key.upper * (units_of(key.quantity).front().to_si / unit.to_si);
}

std::string range_in_words(const Key& key, const Unit& unit) {
  if (key.lower == key.upper) return brief(key.lower);
  const std::string symbol = unit.symbol;
  return brief(lower_in(key, unit)) + " to " + brief(upper_in(key, unit)) +
         (symbol.empty() ? "" : " " + symbol);
}

bool section_has_scale(const std::string& section) {
  static const std::vector<std::string> with = {"bow", "ice", "sheet", "operation", "solver", "cycle"};
  return std::find(with.begin(), with.end(), section) != with.end();
}

const std::vector<std::string>& design_sections() {
  static const std::vector<std::string> sections = {"bow",   "hull",      "ice",    "water",
                                                    "sheet", "operation", "solver", "cycle"};
  return sections;
}

const std::vector<std::string>& structural_keys() {
  static const std::vector<std::string> keys = {
      "bow",         "derived", "hold",    "hull",   "ice",        "water",    "sheet",
      "operation",   "solver",  "cycle",   "output", "evaluators", "designs",  "scenarios",
      "constraints", "method",  "confirm", "decide", "ranking",    "execution"};
  return keys;
}

}  // namespace icebow
