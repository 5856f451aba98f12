#include "hullgen/bow/bow_volume.h"

#include <algorithm>
#include <cmath>

#include "base/units.h"
#include "hullgen/bow/bow_surface.h"
#include "hullgen/bow/dimensions.h"
#include "hullgen/bow/skeg.h"

namespace icebow {
namespace {

// Simpson's rule; what is integrated are polynomials of degree 5 at most, or has no corner.
template <class Function>
double integral(double from, double to, Function f) {
  constexpr int pairs = 32;
  if (!(to > from)) return 0.0;
  const double h = (to - from) / (2 * pairs);
  double sum = f(from) + f(to);
  for (int k = 1; k < 2 * pairs; ++k) sum += (k % 2 == 1 ? 4.0 : 2.0) * f(from + k * h);
  return sum * h / 3.0;
}

// Of the design waterline over eta from the centre plane to the side [m^2]: (3) and (4), term by term. A
// quarter of a superellipse has the area Gamma(1/n) Gamma(3/2) / (n Gamma(1/n + 3/2)).
double waterline_integral(const BowSurface& b) {
  const double n = b.fairing_power;
  const double quarter = std::tgamma(1.0 / n) * std::tgamma(1.5) / (n * std::tgamma(1.0 / n + 1.5));
  const double fore = b.yq * b.yq * (b.c0 / 2.0 + (b.c1 - b.c0) / 6.0);
  const double crease = 0.5 * b.J * (1.0 - b.chine) * (1.0 - b.chine);
  const double aft = b.c1 / 2.0 + b.e / 6.0 + b.K * (1.0 - b.fairing_from) * (1.0 - quarter) + crease;
  return fore + b.yq * (b.s1 + b.yq * aft);
}

// What the rounding of the stem takes from half a waterplane: half the tangents' kite less the sector [m^2].
double taken_by_rounding(const BowSurface& b, double z) {
  const double c = b.entrance(z), h = b.stem_half_width;
  const double share = c > 1e-3 ? (c - std::atan(c)) / (c * c) : c / 3.0 - c * c * c / 5.0;
  return 0.5 * h * h * (1.0 + c * c) * share;
}

// Area of port's waterplane at a height, from the bow to a transom at L.
double half_area(const BowSurface& b, double waterline, double L, double z) {
  const double hb = b.half_beam(), r = b.half_breadth(z), drop = b.c_buttock * b.run(z) + b.forefoot(z);
  double ahead =  // of S over eta
      waterline + hb * drop + b.yq / 3.0 * (b.c_stem - b.c_buttock) * b.fan_run(z);
  if (b.stem_half_width > 0.0) ahead += taken_by_rounding(b, z) - b.setback * hb;
  ahead -= 0.5 * b.knife_half_width * b.knife(0.0, z);
  // Behind the edge of a reamer the side draws in at 45 deg.
  const double edge = b.waterline(hb) + drop - b.setback;
  return (r - b.reamer) * L + b.reamer * (edge + 0.5 * b.reamer) - r / hb * ahead;
}

// The volume and how it grows with the length [m^2].
struct Volume {
  double value, per_length;
};
Volume volume_of(const BowParameters& bow) {
  const BowSurface b = bow_surface(bow);
  const double waterline = waterline_integral(b);
  const auto area = [&](double z) { return half_area(b, waterline, bow.L, z); };
  const double bilge_top = b.bilge - b.T, fade = std::isfinite(b.fan_fade) ? b.fan_fade : 0.0;
  const double faded = std::max(bilge_top, -b.belt_below - fade);
  // A piece of depth in two where the ice knife begins in it.
  const auto piece = [&](double from, double to) {
    if (b.knife_half_width == 0.0 || b.knife_top <= from || b.knife_top >= to)
      return integral(from, to, area);
    return integral(from, b.knife_top, area) + integral(b.knife_top, to, area);
  };
  double half = piece(-b.belt_below, 0.0) + piece(faded, -b.belt_below) + piece(bilge_top, faded);
  // Down the bilge by its angle, in which circle and ellipse are smooth where they stand vertical.
  const auto by_turn = [&](double turn) {
    return b.bilge * std::cos(turn) * area(bilge_top - b.bilge * std::sin(turn));
  };
  const double knife_turn = b.knife_half_width > 0.0 && b.knife_top < bilge_top
                                ? std::asin((bilge_top - b.knife_top) / b.bilge)
                                : 0.0;
  half += integral(0.0, knife_turn, by_turn) + integral(knife_turn, 0.5 * pi, by_turn);
  const double bilge_corner = (1.0 - 0.25 * pi) * b.bilge * b.bilge;
  return {2.0 * half + skeg_of(bow).volume(), 2.0 * ((b.half_beam() - b.reamer) * b.T - bilge_corner)};
}

bool computable(const BowParameters& bow) {
  return dimension_problem(bow).empty() && angle_range(bow.angles).margin >= 0.0;
}

double& dimension(BowParameters& bow, HeldBy by) {
  return by == HeldBy::beam ? bow.B : by == HeldBy::draft ? bow.T : bow.L;
}

}  // namespace

double bow_displacement(const BowParameters& bow) {
  return volume_of(bow).value;
}

std::optional<double> dimension_for_displacement(const BowParameters& bow, double volume, HeldBy by,
                                                 double lower, double upper) {
  if (by == HeldBy::length) {
    if (!computable(bow)) return std::nullopt;
    const Volume now = volume_of(bow);
    const double length = bow.L + (volume - now.value) / now.per_length;
    return length >= lower && length <= upper ? std::optional<double>(length) : std::nullopt;
  }
  BowParameters tried = bow;
  const auto lacks = [&](double value) {  // NaN where it cannot be computed
    dimension(tried, by) = value;
    return computable(tried) ? volume - bow_displacement(tried) : std::nan("");
  };
  // From the value as it is outwards, as far as bows can be computed and the sign is the same.
  const double start = dimension(tried, by), first = lacks(start);
  if (std::isnan(first)) return std::nullopt;
  const double factor = first > 0.0 ? 1.02 : 1.0 / 1.02;
  double from = start, to = start, there = first;
  while (first * there > 0.0) {
    from = to, to = std::clamp(to * factor, lower, upper), there = lacks(to);
    if (to == from || std::isnan(there)) return std::nullopt;
  }
  for (int k = 0; k < 60; ++k) {
    const double middle = 0.5 * (from + to);
    (first * lacks(middle) > 0.0 ? from : to) = middle;
  }
  return 0.5 * (from + to);
}

}  // namespace icebow
