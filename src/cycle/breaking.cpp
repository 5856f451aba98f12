#include "cycle/breaking.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "base/units.h"

namespace icebow::cycle {
namespace {

// Shortest cusp of the literature's rule over that at rest, as the sources cut its speed term off.
constexpr double least_of_speed = 0.6;
// Deflection of a half-infinite floating plate under a load on its free edge: w = 0.46 P / (rho_w g l^2)
// (Westergaard).
constexpr double edge_deflection = 0.46;
// A floating beam breaks at this part of l, which the formula of the wedge reaches at a width of 142 h.
constexpr double beam_length = 1.11;
// Depth of the water that moves with the plate over the thickness: 0.4 of the width of a piece of ten.
constexpr double water_layer_h = 4.0;

Capacity by_literature(const Ice& ice, const BreakingRule& rule, const Press& press) {
  const double shorter = std::max(least_of_speed, 1.0 + rule.C_v * press.normal_speed);
  return {rule.C * ice.sigma_f * ice.h * ice.h, rule.C_l * ice.characteristic_length() * shorter};
}

// A 90 degree wedge truncated to the contact (three of 60 degrees for the load), at rest and driven down.
Capacity by_plate(const Ice& ice, const Press& press) {
  const double width_h = std::clamp(press.width / ice.h, 0.25, 142.0);
  const double at_rest = std::clamp(0.40 + 0.33 * std::log10(width_h), 0.20, beam_length);
  const double fast = press.edge_speed / inertial_speed(ice);
  const double driven = fast > 0.0 ? 0.66 / std::sqrt(fast) : at_rest;
  const double length = std::min(at_rest, driven);
  const double load = 0.60 + 0.0375 * width_h * at_rest / length;
  return {load * ice.sigma_f * ice.h * ice.h, length * ice.characteristic_length()};
}

// Linear in the logarithm of the width, linear in the speed, held constant outside the tests.
class Table {
 public:
  explicit Table(const std::vector<PatchTest>& tests) : tests_(tests) {
    for (const PatchTest& t : tests) widths_.insert(t.width_h);
  }

  PatchTest at(double width_h, double speed) const {
    auto above = widths_.lower_bound(width_h);
    if (above == widths_.end()) return at_width(*widths_.rbegin(), speed);
    if (above == widths_.begin() || *above == width_h) return at_width(*above, speed);
    const double high = *above, low = *--above;
    const double t = std::log(width_h / low) / std::log(high / low);
    return between(at_width(low, speed), at_width(high, speed), t);
  }

 private:
  static PatchTest between(const PatchTest& a, const PatchTest& b, double t) {
    PatchTest result = a;
    result.capacity += t * (b.capacity - a.capacity);
    result.length_l += t * (b.length_l - a.length_l);
    return result;
  }

  PatchTest at_width(double width_h, double speed) const {
    const PatchTest *below = nullptr, *above = nullptr;
    for (const PatchTest& t : tests_) {
      if (t.width_h != width_h) continue;
      if (t.edge_speed <= speed && (!below || t.edge_speed > below->edge_speed)) below = &t;
      if (t.edge_speed >= speed && (!above || t.edge_speed < above->edge_speed)) above = &t;
    }
    if (!below || !above) return below ? *below : *above;
    if (below->edge_speed == above->edge_speed) return *below;
    return between(*below, *above, (speed - below->edge_speed) / (above->edge_speed - below->edge_speed));
  }

  const std::vector<PatchTest>& tests_;
  std::set<double> widths_;
};

Capacity by_table(const Ice& ice, const BreakingRule& rule, const Press& press) {
  const PatchTest found = Table(rule.table).at(std::max(press.width / ice.h, 1e-3), press.edge_speed);
  return {found.capacity * ice.sigma_f * ice.h * ice.h, found.length_l * ice.characteristic_length()};
}

}  // namespace

double edge_stiffness(const Ice& ice) {
  return ice.rho_w * gravity * std::pow(ice.characteristic_length(), 2) / edge_deflection;
}

double inertial_speed(const Ice& ice) {
  const double mass = (ice.rho + ice.rho_w * water_layer_h) * ice.h;
  return ice.sigma_f * ice.h * ice.h / (6.0 * std::sqrt(ice.rigidity() * mass));
}

Capacity capacity(const Ice& ice, const BreakingRule& rule, const Press& press) {
  if (rule.type == Breaking::plate) return by_plate(ice, press);
  if (rule.type == Breaking::calibrated) return by_table(ice, rule, press);
  return by_literature(ice, rule, press);
}

double largest_radius(const Ice& ice, const BreakingRule& rule) {
  const double l = ice.characteristic_length();
  if (rule.type == Breaking::plate) return beam_length * l;
  double longest = rule.type == Breaking::literature ? rule.C_l : 0.0;
  for (const PatchTest& t : rule.table) longest = std::max(longest, t.length_l);
  return longest * l;
}

}  // namespace icebow::cycle
