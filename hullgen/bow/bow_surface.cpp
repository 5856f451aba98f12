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

// (11) A circle tangent to both sides, whose touching points lie `half_width` off the centre plane: how far
// its nose lies behind the edge in which the sides, of this cotangent, would meet.
double nose(double half_width, double c) {
  return half_width * c / (1.0 + 1.0 / std::sqrt(1.0 + c * c));  // h (1 + c^2 - sqrt(1 + c^2)) / c
}
double nose_by_cotangent(double half_width, double c) {
  const double root = std::sqrt(1.0 + c * c);
  return half_width * (1.0 - 1.0 / (root * (root + 1.0)));  // also where c = 0
}

double bilge_radius(const BowParameters& bow) {
  return std::min(bow.T / 4.0, bow_beam(bow) / 8.0);
}

double fin_half_width(const BowParameters& bow, double height, double width) {
  if (height == 0.0) return 0.0;
  if (width > 0.0) return 0.5 * width;
  return bow.centre.stem_radius > 0.0 ? stem_half_width(bow) : bow.B / 80.0;
}

// How much of the stem's cotangent the rounding takes from the fan: the nose lies the deeper the sharper the
// waterline, which the fan changes with height.
double share_of_fan(const BowSurface& b) {
  return 2.0 / b.yq * nose_by_cotangent(b.stem_half_width, b.c0);
}

// The rounded stem shows the angle asked for, so the sharp one in it has another.
void round_stem(const BowParameters& bow, BowSurface& b) {
  if (bow.centre.stem_radius == 0.0) return;
  b.stem_half_width = std::min(stem_half_width(bow), 0.1 * b.half_beam());  // more is refused
  b.setback = nose(b.stem_half_width, b.c0);
  const double share = share_of_fan(b);
  b.c_stem = (b.c_stem - share * b.c_buttock) / (1.0 - share);
}

void add_knife(const BowParameters& bow, BowSurface& b) {
  if (bow.centre.knife_height == 0.0) return;
  b.knife_top = bow.centre.knife_height - bow.T;
  b.knife_cotangent = cot(bow.centre.knife_angle);
  b.knife_from = b.s_without_knife(0.0, b.knife_top);
  b.knife_half_width = knife_half_width(bow);
}

}  // namespace

double stem_half_width(const BowParameters& bow) {
  return bow.centre.stem_radius * std::cos(bow.angles.waterline);
}
double knife_half_width(const BowParameters& bow) {
  return fin_half_width(bow, bow.centre.knife_height, bow.centre.knife_width);
}
double skeg_half_width(const BowParameters& bow) {
  return fin_half_width(bow, bow.centre.skeg_height, bow.centre.skeg_width / bottom_share(bow));
}
double bottom_share(const BowParameters& bow) {
  return 1.0 - (bilge_radius(bow) + reamer_step(bow)) / (0.5 * bow_beam(bow));
}

double shown_stem(const BowSurface& bow, double sharp) {
  const double share = bow.stem_half_width > 0.0 ? share_of_fan(bow) : 0.0;
  return sharp + share * (bow.c_buttock - sharp);
}

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
  round_stem(bow, b);
  b.Lf += b.setback;
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
  b.bilge = bilge_radius(bow);
  b.belt_below = bow.belt_below;
  b.belt_above = bow.belt_above;
  b.deck_fade = 0.5 * (bow.D - bow.T - bow.belt_above);
  b.fan_fade = form.straight_stem ? std::numeric_limits<double>::infinity()
                                  : std::min(0.25 * bow.T, bow.T - b.bilge - bow.belt_below);
  b.forefoot_slope = form.forefoot_slope;
  b.forefoot_fade = bow.T - b.bilge - bow.belt_below;
  add_knife(bow, b);
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

// dS/deta of (8) at eta = 0.
double BowSurface::entrance(double z) const {
  return c0 + 2.0 / yq * (c_buttock - c_stem) * fan_run(z);
}

// (11)
double BowSurface::stem_rounding(double eta, double z) const {
  if (eta >= stem_half_width) return 0.0;
  const double c = entrance(z), curvature = c / (stem_half_width * std::sqrt(1.0 + c * c)),
               k = curvature * eta;
  return nose(stem_half_width, c) + k * eta / (1.0 + std::sqrt(1.0 - k * k)) - c * eta;
}

// (12)
double BowSurface::knife(double eta, double z) const {
  if (eta >= knife_half_width || z >= knife_top) return 0.0;
  const double ahead = s_without_knife(0.0, z) - knife_from - (knife_top - z) * knife_cotangent;
  return std::max(ahead, 0.0) * (1.0 - eta / knife_half_width);
}

// (8) S = w + cot(buttock) F + (c - cot(buttock)) Phi + c_deck G + b
double BowSurface::s_without_knife(double eta, double z) const {
  const double sharp = waterline(eta) + c_buttock * run(z) +
                       (buttock_cotangent(eta) - c_buttock) * fan_run(z) + c_deck * deck_run(z) + forefoot(z);
  return stem_half_width > 0.0 ? sharp + stem_rounding(eta, z) - setback : sharp;
}
double BowSurface::s(double eta, double z) const {
  return s_without_knife(eta, z) - knife(eta, z);
}

Vec3 BowSurface::point(double eta, double z) const {
  return Vec3(-s(eta, z), eta * half_breadth(z) / half_beam(), z);
}

}  // namespace icebow
