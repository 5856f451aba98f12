#include "study/evaluate/evaluator_inputs.h"

#include "base/units.h"
#include "hullgen/bow/family.h"
#include "solver/model/describe_scenario.h"

namespace icebow {

namespace {

// Froude-Cauchy, from full to model scale.
class ToModelScale {
 public:
  explicit ToModelScale(double lambda) : lambda_(lambda) {}

  void field(const char* /*name*/, double& value, double exponent) { scale(value, exponent); }
  void option(int /*number*/, const char* /*name*/, double& value, double /*usual*/, double exponent) {
    scale(value, exponent);
  }
  void follows(const char* /*name*/, double& value, double exponent) { scale(value, exponent); }
  // Whole numbers, choices and switches are the same at every scale.
  template <class T>
  void field(const char* /*name*/, T& /*value*/, double /*exponent*/) {}
  template <class T, class U>
  void option(int /*number*/, const char* /*name*/, T& /*value*/, U /*usual*/, double /*exponent*/) {}
  template <class T>
  void ignored(const char* /*name*/, T& /*value*/) {}

 private:
  void scale(double& value, double exponent) const {
    if (exponent != 0.0) value = to_model_scale(value, lambda_, exponent);
  }
  double lambda_;
};

}  // namespace

Scenario model_scenario(const Case& full) {
  Scenario scenario{full.ice, full.water,   full.sheet,       full.numerics,
                    full.V,   full.advance, full.steady_from, full.stop_when_ci95_below};
  ToModelScale to_model(full.lambda);
  describe(to_model, scenario);
  return scenario;
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
