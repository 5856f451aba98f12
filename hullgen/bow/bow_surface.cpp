#include "hullgen/bow/bow_surface.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/units.h"

namespace icebow {
namespace {

// Distance covered by a slope of 1 that is kept for `hold`, falls smoothly (3u^2 - 2u^3) to 0 over `fade` and
// stays 0.
double faded(double d, double hold, double fade) {
  if (d <= hold) return d;
  const double u = std::min((d - hold) / fade, 1.0);
  return hold + fade * (u - u * u * u + 0.5 * u * u * u * u);
}

// 0 at the upper end of the bilge, 1 at the keel.
double bilge_depth(const BowSurface& b, double z) {
  return std::clamp((b.bilge - b.T - z) / b.bilge, 0.0, 1.0);
}

}  // namespace

double cot(double angle) {
  return std::cos(angle) / std::sin(angle);
}
double acot(double cotangent) {
  return std::atan2(1.0, cotangent);
}

BowSurface bow_surface(const BowParameters& bow) {
  const FamilyForm& form = family_form(bow.family);
  BowSurface b;
  b.reamer = reamer_step(bow);
  b.yq = bow_beam(bow) / 4.0;
  b.Lf = bow.Lf;
  b.T = bow.T;
  b.D = bow.D;
  b.c_stem = cot(bow.angles.stem);
  b.c_buttock = cot(bow.angles.buttock);
  b.c_deck = std::min(cot(form.deck_angle), b.c_buttock);
  b.c0 = cot(bow.angles.waterline);
  b.c1 = cot(bow.angles.flare) * b.c_buttock;  // (1) tan(waterline) = tan(flare) tan(buttock)
  b.s1 = b.yq * 0.5 * (b.c0 + b.c1);
  // Length left over by a waterline that is straight aft of B/4; a faired shoulder spends all of it, with a
  // crease on the way half of it at the crease.
  const double spare = (b.Lf - b.s1) / b.yq - b.c1, usable = std::max(spare, 0.0);
  b.chine = form.chines ? 2.0 * bow.chine - 1.0 : 0.0;
  b.fairing_from = form.chines ? b.chine : form.fairing_from;
  b.fairing_power = form.fairing_power;
  b.J = form.chines ? knuckle_share * usable / (1.0 - b.chine) : 0.0;
  b.K = form.faired_shoulder ? usable - b.J * (1.0 - b.chine) : 0.0;
  b.e = 2.0 * (spare - b.K - b.J * (1.0 - b.chine));
  b.bilge = std::min(bow.T / 4.0, bow_beam(bow) / 8.0);
  b.belt_below = bow.belt_below;
  b.belt_above = bow.belt_above;
  b.deck_fade = 0.5 * (bow.D - bow.T - bow.belt_above);
  b.fan_fade = form.straight_stem ? std::numeric_limits<double>::infinity()
                                  : std::min(0.25 * bow.T, bow.T - b.bilge - bow.belt_below);
  b.forefoot_slope = form.forefoot_slope;
  b.forefoot_fade = bow.T - b.bilge - bow.belt_below;
  return b;
}

// (3), (4): a parabola up to B/4, then a parabola and a quarter of a superellipse, with a crease before it
// where the family has one; w'(0) = c0, w'(yq) = c1, w(B/2) = Lf.
double BowSurface::waterline(double eta) const {
  const double x = eta / yq, t = x - 1.0;
  if (t <= 0.0) return yq * (c0 * x + 0.5 * (c1 - c0) * x * x);
  const double u = std::max((t - fairing_from) / (1.0 - fairing_from), 0.0);
  const double fairing = 1.0 - std::sqrt(std::max(1.0 - std::pow(u, fairing_power), 0.0));
  return s1 + yq * (c1 * t + 0.5 * e * t * t + K * fairing + J * std::max(t - chine, 0.0));
}

double BowSurface::longest() const {
  if (c1 + e >= 0.0) return Lf;
  const double t = -c1 / e;  // the waterline turns forward again here, towards the side edge
  return s1 + yq * (c1 * t + 0.5 * e * t * t);
}

// (5): from the stem's angle to the buttock's at B/4, parallel from there on.
double BowSurface::buttock_cotangent(double eta) const {
  const double x = std::min(eta / yq, 1.0);
  return c_stem + (c_buttock - c_stem) * x * (2.0 - x);
}

// (6): straight through the ice belt and down to the keel, or below the belt turning hollow or round; above
// the belt it fades out in favour of the deck's angle.
double BowSurface::run(double z) const {
  if (z > 0.0) return -faded(z, belt_above, deck_fade);
  if (forefoot_slope == 1.0) return -z;
  return -forefoot_slope * z + (1.0 - forefoot_slope) * faded(-z, belt_below, forefoot_fade);
}
double BowSurface::deck_run(double z) const {
  return z <= 0.0 ? 0.0 : faded(z, belt_above, deck_fade) - z;
}
double BowSurface::fan_run(double z) const {
  return z < 0.0 && std::isfinite(fan_fade) ? faded(-z, belt_below, fan_fade) : run(z);
}

// (7): a quarter ellipse makes bow and flat bottom meet tangentially, a quarter circle the side and the
// bottom.
double BowSurface::forefoot(double z) const {
  const double tau = bilge_depth(*this, z);
  return bilge * (1.0 - std::sqrt(1.0 - tau * tau));
}
double BowSurface::half_breadth(double z) const {
  return half_beam() - forefoot(z);
}

// (8) S = w + cot(buttock) F + (c - cot(buttock)) Phi + c_deck G + b
double BowSurface::s(double eta, double z) const {
  return waterline(eta) + c_buttock * run(z) + (buttock_cotangent(eta) - c_buttock) * fan_run(z) +
         c_deck * deck_run(z) + forefoot(z);
}

Vec3 BowSurface::point(double eta, double z) const {
  return Vec3(-s(eta, z), eta * half_breadth(z) / half_beam(), z);
}

}  // namespace icebow
