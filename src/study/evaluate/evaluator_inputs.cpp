#include "study/evaluate/evaluator_inputs.h"

#include "base/units.h"
#include "hullgen/bow/family.h"

namespace icebow {

Scenario model_scenario(const Case& full) {
  const double lambda = full.lambda;
  const auto model = [&](double value, double exponent) { return to_model_scale(value, lambda, exponent); };
  Scenario s;
  s.ice = full.ice;
  s.ice.h = model(full.ice.h, scaling::length);
  s.ice.E = model(full.ice.E, scaling::stress);
  s.ice.K_I = model(full.ice.K_I, scaling::toughness);
  s.ice.crushing_pressure = model(full.ice.crushing_pressure, scaling::stress);
  s.water = full.water;
  s.water.added_mass = model(full.water.added_mass, scaling::length);
  s.sheet = full.sheet;
  s.sheet.length = model(full.sheet.length, scaling::length);
  s.sheet.width = model(full.sheet.width, scaling::length);
  s.sheet.window_ahead = model(full.sheet.window_ahead, scaling::length);
  s.sheet.absorbing = model(full.sheet.absorbing, scaling::length);
  s.numerics = full.numerics;
  s.numerics.dx = model(full.numerics.dx, scaling::length);
  s.numerics.dt = model(full.numerics.dt, scaling::time);
  s.V = model(full.V, scaling::speed);
  s.advance = model(full.advance, scaling::length);
  s.steady_from = model(full.steady_from, scaling::length);
  s.stop_when_ci95_below = full.stop_when_ci95_below;
  return s;
}

LindqvistInputs lindqvist_inputs(const Case& full) {
  LindqvistInputs in;
  in.L = full.bow.L;
  in.B = bow_beam(full.bow);  // with reamers, the beam of the channel
  in.T = full.bow.T;
  in.stem = full.bow.angles.stem;
  in.waterline = full.bow.angles.waterline;
  in.h = full.ice.h;
  in.V = full.V;
  in.sigma_f = full.flexural_strength;
  in.E = full.ice.E;
  in.nu = full.ice.nu;
  in.mu = full.numerics.friction;
  in.rho_w = full.water.rho;
  in.rho_i = full.ice.rho;
  in.g = gravity;
  return in;
}

}  // namespace icebow
