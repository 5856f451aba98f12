// What a scenario consists of, written once: the key of a stored result, the text of a checkpoint and the
// Froude-Cauchy scaling are visitors of these descriptions.
//
// A visitor has four functions. `exponent` is that of the model law, base/units.h; 0 = the same at every
// scale.
//   field(name, value, exponent)              in every text
//   option(number, name, value, usual, exponent)
//                                             in a text only where it is not the usual value, after all
//                                             fields and in the order of the numbers: a text that is older
//                                             than the option stays as it was. The next new option takes
//                                             number 10.
//   follows(name, value, exponent)            computed from other fields of a study's case
//   ignored(name, value)                      no result depends on it
// Each description names every member of its struct: a member that is added does not compile until it is
// here.
#pragma once

#include <cstdint>

#include "base/units.h"
#include "solver/model/run_options.h"
#include "solver/model/scenario.h"

namespace icebow {

template <class Visitor, class Ice>
void describe_ice(Visitor& visit, Ice& ice) {
  auto& [h, rho, E, nu, s0, K_I, tensile_strength, crushing_pressure] = ice;
  visit.field("ice.h", h, scaling::length);
  visit.field("ice.rho", rho, 0.0);
  visit.field("ice.E", E, scaling::stress);
  visit.field("ice.nu", nu, 0.0);
  visit.field("ice.s0", s0, 0.0);
  visit.field("ice.K_I", K_I, scaling::toughness);
  visit.follows("ice.tensile_strength", tensile_strength, scaling::stress);
  visit.field("ice.crushing_pressure", crushing_pressure, scaling::stress);
}

template <class Visitor, class W>
void describe_water(Visitor& visit, W& water) {
  auto& [rho, buoyancy_and_gravity, inertia, added_mass, drag] = water;
  visit.field("water.rho", rho, 0.0);
  visit.field("water.buoyancy_and_gravity", buoyancy_and_gravity, 0.0);
  visit.option(3, "water.added_mass", added_mass, 0.0, scaling::length);
  visit.option(4, "water.inertia", inertia, WaterInertia::layer, 0.0);
  visit.option(5, "water.drag", drag, 0.0, 0.0);
}

template <class Visitor, class S>
void describe_sheet(Visitor& visit, S& sheet) {
  auto& [length, width, fixed, window_ahead, absorbing, half_model] = sheet;
  visit.field("sheet.length", length, scaling::length);
  visit.field("sheet.width", width, scaling::length);
  visit.field("sheet.fixed", fixed, 0.0);
  visit.field("sheet.window_ahead", window_ahead, scaling::length);
  visit.option(6, "sheet.absorbing", absorbing, 0.0, scaling::length);
  visit.option(2, "sheet.half_model", half_model, false, 0.0);
}

template <class Visitor, class N>
void describe_numerics(Visitor& visit, N& numerics) {
  auto& [dx, horizon_ratio, dt, dt_fraction, linear_below, surface_correction, precision, contact,
         floe_contact, floe_friction, ranks_along_x, friction] = numerics;
  visit.field("numerics.dx", dx, scaling::length);
  visit.field("numerics.horizon_ratio", horizon_ratio, 0.0);
  visit.field("numerics.dt", dt, scaling::time);
  visit.field("numerics.dt_fraction", dt_fraction, 0.0);
  visit.field("numerics.surface_correction", surface_correction, 0.0);
  visit.field("numerics.linear_below", linear_below, 0.0);
  visit.field("numerics.precision", precision, 0.0);
  visit.field("numerics.contact", contact, 0.0);
  visit.field("numerics.friction", friction, 0.0);
  visit.option(7, "numerics.floe_contact", floe_contact, false, 0.0);
  visit.option(9, "numerics.floe_friction", floe_friction, 0.0, 0.0);
  visit.ignored("numerics.ranks_along_x", ranks_along_x);
}

// The parts of a scenario and of a case that both have besides those structs.
template <class Visitor, class Value>
void describe_voyage(Visitor& visit, Value& V, Value& advance, Value& steady_from,
                     Value& stop_when_ci95_below) {
  visit.field("V", V, scaling::speed);
  visit.field("advance", advance, scaling::length);
  visit.field("steady_from", steady_from, scaling::length);
  visit.field("stop_when_ci95_below", stop_when_ci95_below, 0.0);
}

template <class Visitor>
void describe_output(Visitor& visit, std::uint64_t seed, int snapshots, int pictures, SnapshotFormat format) {
  visit.field("snapshots", snapshots, 0.0);
  visit.field("pictures", pictures, 0.0);
  visit.option(1, "seed", static_cast<double>(seed), 0.0, 0.0);
  visit.option(8, "snapshot_format", format, SnapshotFormat::vtp, 0.0);
}

template <class Visitor, class S>
void describe(Visitor& visit, S& scenario) {
  auto& [ice, water, sheet, numerics, V, advance, steady_from, stop_when_ci95_below] = scenario;
  describe_ice(visit, ice);
  describe_water(visit, water);
  describe_sheet(visit, sheet);
  describe_numerics(visit, numerics);
  describe_voyage(visit, V, advance, steady_from, stop_when_ci95_below);
}

}  // namespace icebow
