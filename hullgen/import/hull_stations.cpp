#include "hullgen/import/hull_stations.h"

#include <algorithm>
#include <cmath>

#include "base/units.h"
#include "hullgen/import/surface_normal.h"
#include "hullgen/import/waterline.h"

namespace icebow {
namespace {

constexpr double full_breadth = 0.995;

// Where the side has this breadth first, going aft.
double shoulder(const Polyline& side, double y) {
  for (std::size_t k = 0; k + 1 < side.size(); ++k) {
    const Vec3 &p = side[k], &q = side[k + 1];
    if (q.y() >= y) return p.x() + (y - p.y()) / (q.y() - p.y()) * (q.x() - p.x());
  }
  return side.back().x();
}

Vec3 place_at(const Polyline& side, double x) {
  for (std::size_t k = 0; k + 1 < side.size(); ++k) {
    const Vec3 &p = side[k], &q = side[k + 1];
    if (q.x() > x || p.x() == q.x()) continue;
    return p + std::clamp((p.x() - x) / (p.x() - q.x()), 0.0, 1.0) * (q - p);
  }
  return side.back();
}

StationAngles angles_of(const SurfaceNormal& fit, const Vec3& at, double share) {
  const Vec3& n = fit.normal;
  StationAngles a;
  a.share = share;
  a.at = at;
  a.waterline = std::atan2(n.x(), n.y());
  a.buttock = std::atan2(n.x(), -n.z() + 0.0);
  a.flare = std::atan2(-n.z() + 0.0, n.y());
  a.normal_flare = std::asin(std::clamp(-n.z() + 0.0, -1.0, 1.0));
  a.plate_slope = 0.5 * pi - a.normal_flare;
  a.spread = fit.spread;
  return a;
}

}  // namespace

const std::vector<double>& station_shares() {
  static const std::vector<double> shares = {0.0625, 0.125, 0.25, 0.375, 0.5, 0.625, 0.75, 0.875};
  return shares;
}

WaterlineAngles angles_along_waterline(const QuadMesh& mesh, double z, const std::vector<int>& on_chords) {
  WaterlineAngles result;
  result.z = z;
  const Waterline waterline = waterline_at(mesh, z);
  const SurfaceNormals normals(mesh, on_chords);
  const Polyline side = normals.on_chords().without(port_side_from_stem(waterline));
  if (side.size() < 2) return result;
  const double half_breadth = side.back().y(), beam = waterline.port - waterline.starboard;
  const double fore = side.front().x();
  result.bow_length = fore - shoulder(side, full_breadth * half_breadth);
  if (!(result.bow_length > 0.0)) return result;
  const StemBar bar = stem_bar(side, beam);
  for (const double share : station_shares()) {
    const Vec3 at = place_at(side, fore - share * result.bow_length);
    const double inboard = at.y() > bar.half_width ? bar.half_width * (1.0 - 1e-6) : -1e300;
    const SurfaceNormal fit = normals.at({at, at, std::max(inboard, 0.0), beam / 4.0, false});
    if (fit.found) result.stations.push_back(angles_of(fit, at, share));
  }
  return result;
}

}  // namespace icebow
