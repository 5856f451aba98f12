#include "cycle/cycle_input.h"

#include <cmath>
#include <sstream>

#include "base/units.h"

namespace icebow::cycle {
namespace {

struct Limits {
  const char* name;
  double value, lower, upper;
};

std::string outside(const Limits& l) {
  if (l.value >= l.lower && l.value <= l.upper) return "";
  std::ostringstream text;
  text << l.name << " is " << l.value << ", allowed " << l.lower << " to " << l.upper;
  return text.str();
}

constexpr double longest_h = 1e5;  // keeps a typing error from running for hours

}  // namespace

double Ice::rigidity() const {
  return E * h * h * h / (12.0 * (1.0 - nu * nu));
}

double Ice::characteristic_length() const {
  return std::pow(rigidity() / (rho_w * gravity), 0.25);
}

std::string trouble_with(const Ice& ice, const Voyage& voyage, const BreakingRule& rule) {
  const Limits limits[] = {
      {"the ice's thickness [m]", ice.h, 1e-4, 100.0},
      {"the ice's density [kg/m3]", ice.rho, 1.0, 0.9999 * ice.rho_w},
      {"the water's density [kg/m3]", ice.rho_w, 100.0, 1e4},
      {"the ice's modulus [Pa]", ice.E, 1.0, 1e13},
      {"Poisson's ratio", ice.nu, 0.0, 0.499},
      {"the flexural strength [Pa]", ice.sigma_f, 1e-3, 1e12},
      {"the crushing pressure [Pa]", ice.p_c, 1e-3, 1e13},
      {"the friction coefficient", ice.friction, 0.0, 5.0},
      {"the speed [m/s]", voyage.speed, 0.0, 100.0},
      {"the voyage over the thickness", voyage.length / ice.h, 1.0, longest_h},
      {"the scatter of cusp radii", voyage.scatter, 0.0, 0.9},
      {"the step over the thickness", voyage.step_h, 1e-3, 0.5},
      {"the raster over the thickness", voyage.raster_h, 0.02, 1.0},
      {"C", rule.C, 0.01, 100.0},
      {"C_l", rule.C_l, 0.01, 5.0},
      {"C_v [s/m]", rule.C_v, -10.0, 0.0},
  };
  for (const Limits& l : limits) {
    const std::string words = outside(l);
    if (!words.empty()) return words;
  }
  if (rule.type == Breaking::calibrated && rule.table.empty())
    return "there are no patch tests to break ice by";
  return "";
}

}  // namespace icebow::cycle
