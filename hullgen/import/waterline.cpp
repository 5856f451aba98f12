#include "hullgen/import/waterline.h"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>

#include "base/units.h"

namespace icebow {
namespace {

// More than a chord of a fair waterline turns against its fit; of coarse panels, which turn more from one to
// the next, a bar is told only by a turn that stands out among theirs.
constexpr double turn_at_bar = radians(4.0), stands_out = 1.5;
constexpr double sharpest_told = radians(75.0);  // blunter sides meet too flatly to tell a bar from the bow

double signed_area(const Polyline& loop) {
  double twice = 0.0;
  for (std::size_t k = 0; k + 1 < loop.size(); ++k)
    twice += loop[k].x() * loop[k + 1].y() - loop[k + 1].x() * loop[k].y();
  return 0.5 * twice;
}

bool inside(const Polyline& loop, const Vec3& p) {
  bool in = false;
  for (std::size_t k = 0; k + 1 < loop.size(); ++k) {
    const Vec3 &a = loop[k], &b = loop[k + 1];
    if ((a.y() > p.y()) != (b.y() > p.y()) &&
        p.x() < a.x() + (p.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x()))
      in = !in;
  }
  return in;
}

// s against y: a parabola, or a line through two points.
struct Side {
  double s0 = 0.0, slope = 0.0, curve = 0.0;
  double heading(double y) const { return std::atan2(1.0, slope + 2.0 * curve * y); }
};
Side fitted(const Polyline& side, std::size_t from, std::size_t to) {
  const auto n = static_cast<Eigen::Index>(to - from);
  const int terms = n >= 3 ? 3 : 2;
  const double scale = side[to - 1].y();
  Eigen::MatrixXd a(n, terms);
  Eigen::VectorXd s(n);
  for (Eigen::Index k = 0; k < n; ++k) {
    const Vec3& p = side[from + static_cast<std::size_t>(k)];
    const double y = p.y() / scale;
    a(k, 0) = 1.0, a(k, 1) = y;
    if (terms == 3) a(k, 2) = y * y;
    s[k] = -p.x();
  }
  const Eigen::VectorXd c = a.colPivHouseholderQr().solve(s);
  return {c[0], c[1] / scale, terms == 3 ? c[2] / (scale * scale) : 0.0};
}

// The first point that lies at least so far outboard.
std::size_t first_beyond(const Polyline& side, double y) {
  std::size_t k = 0;
  while (k < side.size() && side[k].y() < y) ++k;
  return k;
}

}  // namespace

Waterline waterline_at(const QuadMesh& mesh, double z) {
  Waterline w;
  std::vector<Polyline> loops = slice(mesh, 2, z);
  const auto larger = [](const Polyline& a, const Polyline& b) {
    return std::abs(signed_area(a)) < std::abs(signed_area(b));
  };
  const auto largest = std::max_element(loops.begin(), loops.end(), larger);
  if (largest == loops.end()) return w;
  w.loop = *largest;
  const double sign = signed_area(w.loop) < 0.0 ? -1.0 : 1.0;
  if (sign < 0.0) std::reverse(w.loop.begin(), w.loop.end());
  w.area = std::abs(signed_area(w.loop));
  w.port = w.starboard = w.loop[0].y();
  for (const Vec3& p : w.loop) w.port = std::max(w.port, p.y()), w.starboard = std::min(w.starboard, p.y());
  double largest_hole = 0.0;
  for (auto loop = loops.begin(); loop != loops.end(); ++loop) {
    if (loop == largest) continue;
    const double area = signed_area(*loop);
    if (area * sign >= 0.0 || !inside(w.loop, loop->front())) {
      ++w.islands;
      continue;
    }
    w.hole_area += std::abs(area);
    if (std::abs(area) > largest_hole) largest_hole = std::abs(area), w.hole = loop->front();
  }
  return w;
}

Polyline port_side_from_stem(const Waterline& w) {
  const std::size_t n = w.loop.empty() ? 0 : w.loop.size() - 1;
  std::size_t corner = 0;
  double foremost = -1e300;
  for (std::size_t k = 0; k < n; ++k) {
    const Vec3 &p = w.loop[k], &q = w.loop[k + 1];
    if ((p.y() >= 0.0) == (q.y() >= 0.0)) continue;
    const double x = p.x() + p.y() / (p.y() - q.y()) * (q.x() - p.x());
    if (x > foremost) foremost = x, corner = k;
  }
  Polyline side;
  if (foremost == -1e300) return side;
  side.push_back({foremost, 0.0, w.loop[0].z()});
  // Counter-clockwise, port follows the stem.
  for (std::size_t k = 1; k <= n; ++k) {
    const Vec3& p = w.loop[(corner + k) % n];
    if (p.y() < side.back().y()) break;
    if (p.y() > side.back().y()) side.push_back(p);
  }
  return side;
}

// Of the chord from point k - 1 to k.
double chord(const Polyline& side, std::size_t k) {
  return std::atan2(side[k].y() - side[k - 1].y(), side[k - 1].x() - side[k].x());
}
double off_fit(const Polyline& side, std::size_t k, const Side& fit) {
  return std::abs(chord(side, k) - fit.heading(0.5 * (side[k - 1].y() + side[k].y())));
}

// Whether a chord inboard of `from` leaves the fit of the sides by more than their own chords turn.
bool stem_is_blunt(const Polyline& side, std::size_t from, std::size_t to, const Side& fit) {
  double most = 0.0, turn = 0.0;
  for (std::size_t k = 1; k <= from; ++k) most = std::max(most, off_fit(side, k, fit));
  for (std::size_t k = from + 1; k + 1 < to; ++k)
    turn = std::max(turn, std::abs(chord(side, k) - chord(side, k + 1)));
  return most > std::max(turn_at_bar, stands_out * turn);
}

StemBar stem_bar(const Polyline& side, double beam) {
  StemBar bar;
  std::size_t to = std::min(std::max(first_beyond(side, beam / 8.0) + 1, std::size_t{4}), side.size());
  while (to > 3 && side[to - 1].y() > beam / 4.0) --to;
  std::size_t from = std::min(first_beyond(side, beam / 20.0), to);
  if (to < from + 3) from = to > 4 ? to - 3 : 1;
  if (from >= to || to - from < 2) return bar;
  for (int round = 0; round < 3; ++round) {
    const Side fit = fitted(side, from, to);
    std::size_t k = from;
    for (; k > 0; --k) {
      if (off_fit(side, k, fit) > turn_at_bar) break;
    }
    if (k == 0 || !stem_is_blunt(side, from, to, fit)) return bar;  // fair up to the centre plane
    if (k == from && round > 0) break;
    from = std::max<std::size_t>(k, 1);
    if (to < from + 2) return bar;
  }
  const Side fit = fitted(side, from, to);
  const double sharp = fit.heading(0.0), ahead = -side[0].x() - fit.s0;
  if (sharp > sharpest_told || ahead <= 1e-5 * beam) return bar;
  bar.radius = ahead / (1.0 / std::sin(sharp) - 1.0);
  bar.half_width = side[from].y();
  return bar;
}

}  // namespace icebow
