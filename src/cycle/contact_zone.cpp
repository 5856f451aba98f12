#include "cycle/contact_zone.h"

#include <algorithm>
#include <cmath>

#include "cycle/breaking.h"

namespace icebow::cycle {
namespace {

constexpr double near_equal = 1e-9;  // of the depth: an edge that is where it was presses still
constexpr int most_trials = 60;

// Part of a layer, 0 .. 1, in which the hull's surface from x0 to x1 is between a and b.
struct Part {
  double from, to;
  double length() const { return std::max(0.0, to - from); }
};
Part inside(double x0, double x1, double a, double b) {
  const double rise = x1 - x0;
  if (rise == 0.0) return x0 > a && x0 < b ? Part{0.0, 1.0} : Part{0.0, 0.0};
  double at_a = (a - x0) / rise, at_b = (b - x0) / rise;
  if (rise < 0.0) std::swap(at_a, at_b);
  return {std::clamp(at_a, 0.0, 1.0), std::clamp(at_b, 0.0, 1.0)};
}

}  // namespace

Directions directions(const Vec3& area, double friction_coefficient) {
  Directions d;
  d.normal = area.normalized();
  const double nx = d.normal.x(), across = std::sqrt(std::max(0.0, 1.0 - nx * nx));
  d.friction = across > 1e-9 ? Vec3((Vec3::UnitX() - nx * d.normal) / across) : Vec3(Vec3::Zero());
  const double push = -d.normal.z(), pull = friction_coefficient * d.friction.z();
  if (push * pull > 0.0 && std::abs(pull) > std::abs(push)) d.friction.z() = push / friction_coefficient;
  return d;
}

double down_area(const Vec3& area, double friction_coefficient) {
  const double across = std::sqrt(area.y() * area.y() + area.z() * area.z());
  if (across <= 1e-9 * area.x()) return -area.z();
  const double held = 1.0 - friction_coefficient * area.x() / across;
  return -area.z() * std::max(0.0, held);
}

double down_share(const Directions& d, double friction_coefficient) {
  return -d.normal.z() - friction_coefficient * d.friction.z();
}

ZoneSolver::ZoneSolver(const Ice& ice, const HullFront& front, const Strips& strips,
                       std::vector<IceStrip>& sheet)
    : ice_(ice), front_(front), strips_(strips), sheet_(sheet), stiffness_(edge_stiffness(ice)) {}

// Rows of the front that the ice's lower face lies between when it has gone down by w.
ZoneSolver::Level ZoneSolver::level(double w) const {
  const double highest = front_.map.rows() - HullFront::layers - 2;
  const double row = std::clamp(front_.bottom_row - w / front_.map.dz(), 0.0, highest);
  const int below = static_cast<int>(row);
  return {below, row - below};
}

void ZoneSolver::touch(Touch& t, double X, const Level& level) const {
  const Interval& edge = sheet_[static_cast<std::size_t>(t.strip)].intervals()[t.interval];
  const double* x = front_.map.column(t.strip) + level.row;
  double front[HullFront::layers + 1];
  for (int j = 0; j <= HullFront::layers; ++j) {
    const bool there = x[j] > FrontMap::none && x[j + 1] > FrontMap::none;
    front[j] = there ? X + x[j] + level.part * (x[j + 1] - x[j]) : FrontMap::none;
  }
  t.bare = edge.to, t.depth = 0.0, t.presses = false;
  double height = 0.0, plan = 0.0;  // of the contact in layers, and seen from above
  for (int j = 0; j < HullFront::layers; ++j) {
    const double x0 = front[j], x1 = front[j + 1], further = std::max(x0, x1);
    t.bare = std::min({t.bare, x0, x1});
    if (further <= edge.from || std::min(x0, x1) == FrontMap::none) continue;
    t.depth = std::max(t.depth, further - edge.from);
    const Part part = inside(x0, x1, edge.from, edge.to);
    height += part.length(), plan += part.length() * (x1 - x0);
  }
  if (height <= 0.0 || t.depth < edge.memory * (1.0 - near_equal)) return;
  const double width = strips_.width[static_cast<std::size_t>(t.strip)];
  const double up = height * width * front_.map.dz();
  t.area = Vec3(up, up * front_.map.slope_y(t.strip, level.row + (HullFront::layers + 1) / 2), -plan * width);
  t.presses = true;
}

double ZoneSolver::load(Zone& zone, double X, double w) const {
  const Level at = level(w);
  zone.area.setZero();
  zone.down = 0.0;
  for (Touch& t : zone.touches) {
    touch(t, X, at);
    if (!t.presses) continue;
    zone.area += t.area;
    zone.down += zone.factor * ice_.p_c * down_area(t.area, ice_.friction);
  }
  return zone.down;
}

void ZoneSolver::width(Zone& zone) const {
  const Touch *first = nullptr, *last = nullptr;
  for (const Touch& t : zone.touches) {
    if (!t.presses) continue;
    if (!first) first = &t;
    last = &t;
  }
  zone.width = 0.0;
  if (!first) return;
  const auto place = [&](const Touch& t) {
    return Eigen::Vector2d(sheet_[static_cast<std::size_t>(t.strip)].intervals()[t.interval].from,
                           strips_.y[static_cast<std::size_t>(t.strip)]);
  };
  const double ends = 0.5 * (strips_.width[static_cast<std::size_t>(first->strip)] +
                             strips_.width[static_cast<std::size_t>(last->strip)]);
  zone.width = zone.factor * ((place(*first) - place(*last)).norm() + ends);
}

double ZoneSolver::deflection(Zone& zone, double X, const Bounds& bounds, double way) const {
  const auto excess = [&](double w) { return way * load(zone, X, way * w) - stiffness_ * w; };
  double low = 0.0, high = bounds.largest, above = bounds.at_rest;
  double under = 0.0;
  // The edge was at `before` and goes down no faster than the hull comes: most roots lie in between.
  const double before = std::min(bounds.before, high), soon = std::min(before + bounds.descent, high);
  const double first = excess(soon);
  if (first >= 0.0) {
    if (soon >= high || (under = excess(high)) >= 0.0) return high;
    low = soon, above = first;
  } else {
    high = soon, under = first;
    const double second = before > 0.0 ? excess(before) : above;
    (second >= 0.0 ? low : high) = before;
    (second >= 0.0 ? above : under) = second;
  }
  // Regula falsi, the end that stays halved (Illinois): robust at the jumps.
  for (int trial = 0, side = 0; trial < most_trials && high - low > 1e-4 * bounds.descent; ++trial) {
    const double w = trial % 8 == 7 ? 0.5 * (low + high) : low + (high - low) * above / (above - under);
    const double value = excess(w);
    if (value >= 0.0) {
      if (side == 1) under *= 0.5;
      low = w, above = value, side = 1;
      if (value <= 1e-4 * stiffness_ * w) break;
    } else {
      if (side == -1) above *= 0.5;
      high = w, under = value, side = -1;
    }
  }
  return low;
}

// The load falls with w, by jumps where an edge that was crushed deeper before comes free; at a jump the
// contact bears a part of the crushing pressure.
void ZoneSolver::settle(Zone& zone, double X, double largest, double step) const {
  double before = 0.0;
  for (const Touch& t : zone.touches)
    if (std::abs(t.deflection_before) > std::abs(before)) before = t.deflection_before;
  const double at_rest = load(zone, X, 0.0), way = at_rest < 0.0 ? -1.0 : 1.0;
  double w = 0.0;
  if (at_rest != 0.0) {
    const double slope = std::abs(zone.area.z()) > 0.0 ? zone.area.x() / std::abs(zone.area.z()) : 1.0;
    w = deflection(zone, X,
                   {largest, std::abs(before), 1.5 * step * std::clamp(slope, 0.1, 10.0), std::abs(at_rest)},
                   way);
  }
  zone.deflection = way * w;
  load(zone, X, zone.deflection);
  zone.share = w > 0.0 && zone.down != 0.0 ? std::min(1.0, stiffness_ * w / std::abs(zone.down)) : 1.0;
  for (Touch& t : zone.touches) t.normal_force = t.presses ? zone.share * ice_.p_c * t.area.norm() : 0.0;
  zone.down *= zone.share;
  width(zone);
}

}  // namespace icebow::cycle
