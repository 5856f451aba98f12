#include "hullgen/bow/bow_angles.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "base/text.h"
#include "base/units.h"

namespace icebow {
namespace {

// One vertex of a row: s against the coordinate along the row.
struct Sample {
  double along, s;
};

constexpr double angle_tolerance = radians(0.05);

using Row = std::vector<Sample>;

// Value and slope at `at` of the parabola through the three samples nearest to it.
struct Parabola {
  double value, slope;
};
Parabola parabola(Row row, double at) {
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  if (row.size() < 3) return {none, none};
  std::partial_sort(row.begin(), row.begin() + 3, row.end(), [at](const Sample& a, const Sample& b) {
    return std::abs(a.along - at) < std::abs(b.along - at);
  });
  Parabola result{0.0, 0.0};  // sums of s_i L_i(at) and s_i L_i'(at), L_i Lagrange's polynomials
  for (int i = 0; i < 3; ++i) {
    const Sample &p = row[i], &q = row[(i + 1) % 3], &r = row[(i + 2) % 3];
    const double weight = p.s / ((p.along - q.along) * (p.along - r.along));
    result.value += weight * (at - q.along) * (at - r.along);
    result.slope += p.s * (2.0 * at - q.along - r.along) / ((p.along - q.along) * (p.along - r.along));
  }
  return result;
}

double slope(const Row& row, double at) {
  return parabola(row, at).slope;
}

struct Rows {
  Row centreline, quarter_buttock;    // along z
  Row waterline_fore, waterline_aft;  // along y: up to B/4 and from B/4 on
};

Rows rows_of(const QuadMesh& mesh, double B) {
  const double near = 1e-6 * B, yq = B / 4.0;
  std::vector<char> in_bow(mesh.points.size(), 0);
  for (std::size_t q = 0; q < mesh.quads.size(); ++q)
    if (mesh.patch[q] == Patch::bow)
      for (int corner : mesh.quads[q]) in_bow[corner] = 1;
  Rows rows;
  for (std::size_t i = 0; i < mesh.points.size(); ++i) {
    if (!in_bow[i]) continue;
    const Vec3& p = mesh.points[i];
    const double s = -p.x();
    if (std::abs(p.y()) <= near) rows.centreline.push_back({p.z(), s});
    if (std::abs(p.y() - yq) <= near) rows.quarter_buttock.push_back({p.z(), s});
    if (std::abs(p.z()) > near) continue;
    if (p.y() >= -near && p.y() <= yq + near) rows.waterline_fore.push_back({p.y(), s});
    if (p.y() >= yq - near) rows.waterline_aft.push_back({p.y(), s});
  }
  return rows;
}

// Of the waterline, the part outside the stem's rounding.
Row outside(Row waterline, double rounded, double B) {
  const double from = rounded > 0.0 ? rounded - 1e-6 * B : -B;
  waterline.erase(
      std::remove_if(waterline.begin(), waterline.end(), [from](const Sample& s) { return s.along < from; }),
      waterline.end());
  return waterline;
}

}  // namespace

BowAngles angles_at_quarter_beam(double stem, double waterline, double buttock, double entrance) {
  return {stem, entrance, buttock,
          std::atan2(std::sin(waterline) * std::cos(buttock), std::cos(waterline) * std::sin(buttock))};
}

BowAngles measure_angles(const QuadMesh& mesh, double B, double rounded) {
  const Rows rows = rows_of(mesh, B);
  const double yq = B / 4.0;
  const double buttock = -slope(rows.quarter_buttock, 0.0);  // cotangent
  const double waterline = 0.5 * (slope(rows.waterline_fore, yq) + slope(rows.waterline_aft, yq));
  BowAngles angles;
  angles.stem = std::atan2(1.0, -slope(rows.centreline, 0.0));
  angles.waterline = std::atan2(1.0, slope(outside(rows.waterline_fore, rounded, B), 0.0));
  angles.buttock = std::atan2(1.0, buttock);
  angles.flare = std::atan2(buttock, waterline);  // tan(flare) = tan(waterline) / tan(buttock), both at P1
  return angles;
}

double measured_stem_radius(const QuadMesh& mesh, double B, double rounded) {
  const Rows rows = rows_of(mesh, B);
  const Parabola sides = parabola(outside(rows.waterline_fore, rounded, B), 0.0);
  const double back = parabola(rows.centreline, 0.0).value - sides.value;
  return back / (std::hypot(1.0, sides.slope) - 1.0);  // 1 / sin(waterline), slope its cotangent
}

double largest_difference(const BowAngles& a, const BowAngles& b) {
  double largest = 0.0;
  for (double d : {a.stem - b.stem, a.waterline - b.waterline, a.buttock - b.buttock, a.flare - b.flare}) {
    if (std::isnan(d)) return std::numeric_limits<double>::infinity();
    largest = std::max(largest, std::abs(d));
  }
  return largest;
}

std::string angle_mismatch(const BowAngles& asked, const BowAngles& measured) {
  if (largest_difference(asked, measured) <= angle_tolerance) return "";
  return text(
      "the mesh does not have the angles asked for (measured / asked, deg): stem %.3f / %.3f, waterline %.3f "
      "/ "
      "%.3f, buttock %.3f / %.3f, flare %.3f / %.3f: refine the panel size or widen the ice belt",
      degrees(measured.stem), degrees(asked.stem), degrees(measured.waterline), degrees(asked.waterline),
      degrees(measured.buttock), degrees(asked.buttock), degrees(measured.flare), degrees(asked.flare));
}

}  // namespace icebow
