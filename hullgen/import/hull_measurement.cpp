#include "hullgen/import/hull_measurement.h"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <limits>

#include "base/errors.h"
#include "base/text.h"
#include "geometry/mesh_slice.h"

namespace icebow {
namespace {

constexpr double window_share = 1.0 / 40.0;  // of the beam
// Of the beam. Corners of a cut that are nearer to each other count as one: where a diagonal crosses the cut
// close to an edge, the slope between the two is noise.
constexpr double same_share = 1.0 / 200.0;
constexpr int y_axis = 1, z_axis = 2;

// One corner of a cut: s against the coordinate along the cut.
struct Sample {
  double along, s;
};
using Row = std::vector<Sample>;

// A cut on both sides of the point where it passes `at`: `before` has the smaller coordinates.
struct Cut {
  bool found = false;
  Vec3 point = Vec3::Zero();
  Row before, after;
};

// From a corner of a closed line on, as long as the coordinate moves away from `at`.
Row walk(const Polyline& loop, std::size_t from, int step, int axis, double at, double same) {
  const std::size_t n = loop.size() - 1;  // the last point is the first again
  Row row;
  double reached = -1.0;
  for (std::size_t k = 0, i = from; k < n; ++k, i = (i + n + step) % n) {
    const double away = std::abs(loop[i][axis] - at);
    if (away < reached - same) break;
    if (away > reached + same) {
      row.push_back({loop[i][axis], -loop[i].x()});
      reached = away;
    }
  }
  return row;
}

// Where the lines of a cut pass `at` farthest forward.
Cut foremost(const std::vector<Polyline>& loops, int axis, double at, double same) {
  const Polyline* best = nullptr;
  std::size_t corner = 0;
  Cut cut;
  for (const Polyline& loop : loops)
    for (std::size_t k = 0; k + 1 < loop.size(); ++k) {
      const Vec3 &p = loop[k], &q = loop[k + 1];
      if ((p[axis] >= at) == (q[axis] >= at)) continue;
      const Vec3 point = p + (at - p[axis]) / (q[axis] - p[axis]) * (q - p);
      if (best != nullptr && point.x() <= cut.point.x()) continue;
      best = &loop;
      corner = k;
      cut.point = point;
    }
  if (best == nullptr) return cut;
  cut.found = true;
  const std::size_t n = best->size() - 1;
  cut.before = walk(*best, corner, -1, axis, at, same);
  cut.after = walk(*best, (corner + 1) % n, +1, axis, at, same);
  if ((*best)[corner][axis] >= at) std::swap(cut.before, cut.after);
  // The point itself belongs to both sides, unless a corner is there already.
  for (Row* row : {&cut.before, &cut.after})
    if (row->empty() || std::abs(row->front().along - at) > same)
      row->insert(row->begin(), {at, -cut.point.x()});
  return cut;
}

Row both(const Cut& cut, double same) {
  Row row = cut.before;
  for (const Sample& s : cut.after)
    if (std::abs(s.along - row.front().along) > same) row.push_back(s);
  return row;
}

// Slope at `at` of the least-squares parabola through the samples within the window, at least three; where
// there are only two, of the panel between them.
double slope(Row row, double at, double window) {
  std::sort(row.begin(), row.end(), [at](const Sample& a, const Sample& b) {
    return std::abs(a.along - at) < std::abs(b.along - at);
  });
  std::size_t n = 0;
  while (n < row.size() && (n < 3 || std::abs(row[n].along - at) <= window)) ++n;
  if (n < 2) return std::numeric_limits<double>::quiet_NaN();
  if (n == 2) return (row[1].s - row[0].s) / (row[1].along - row[0].along);
  Eigen::MatrixX3d powers(n, 3);
  Eigen::VectorXd s(n);
  for (std::size_t k = 0; k < n; ++k) {
    const double d = (row[k].along - at) / window;
    powers.row(k) << 1.0, d, d * d;
    s[k] = row[k].s - row[0].s;
  }
  const Eigen::Vector3d parabola = powers.colPivHouseholderQr().solve(s);
  return parabola[1] / window;
}

double beam_of(const std::vector<Polyline>& waterlines) {
  double lower = 0.0, upper = 0.0;
  for (const Polyline& loop : waterlines)
    for (const Vec3& p : loop) lower = std::min(lower, p.y()), upper = std::max(upper, p.y());
  return upper - lower;
}

void require(bool holds, const char* what, const QuadMesh& mesh) {
  if (holds) return;
  const Box box = bounding_box(mesh);
  throw InputError(text(
      "%s: the hull reaches from z = %g to %g m and y = %g to %g m, z counted from the waterline: is the "
      "height of the waterline right, the unit, the axes?",
      what, box.lower.z(), box.upper.z(), box.lower.y(), box.upper.y()));
}

}  // namespace

HullMeasurement measure_hull(const QuadMesh& mesh) {
  const std::vector<Polyline> waterlines = slice(mesh, z_axis, 0.0);
  HullMeasurement result;
  result.beam = beam_of(waterlines);
  require(result.beam > 0.0, "the waterline does not cut the hull", mesh);
  const double yq = result.beam / 4.0, window = window_share * result.beam, same = same_share * result.beam;
  const Cut stem = foremost(slice(mesh, y_axis, 0.0), z_axis, 0.0, same);
  const Cut entrance = foremost(waterlines, y_axis, 0.0, same);
  const Cut buttock = foremost(slice(mesh, y_axis, yq), z_axis, 0.0, same);
  const Cut quarter = foremost(waterlines, y_axis, yq, same);
  require(stem.found && entrance.found && buttock.found && quarter.found,
          "the waterline does not meet the centre plane or the plane at B/4", mesh);
  const double cot_stem = -slope(both(stem, same), 0.0, window);
  const double cot_waterline = slope(entrance.after, 0.0, window);
  const double cot_buttock = -slope(both(buttock, same), 0.0, window);
  const double cot_quarter = 0.5 * (slope(quarter.before, yq, window) + slope(quarter.after, yq, window));
  result.angles = {std::atan2(1.0, cot_stem), std::atan2(1.0, cot_waterline), std::atan2(1.0, cot_buttock),
                   std::atan2(cot_buttock, cot_quarter)};
  result.waterline_at_quarter_beam = std::atan2(1.0, cot_quarter);
  result.flare_at_stem = std::atan2(cot_stem, cot_waterline);  // (2)
  result.P0 = entrance.point;
  result.P1 = quarter.point;
  return result;
}

}  // namespace icebow
