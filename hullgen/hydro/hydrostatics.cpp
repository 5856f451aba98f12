#include "hullgen/hydro/hydrostatics.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/errors.h"
#include "base/text.h"
#include "base/units.h"
#include "geometry/triangles.h"

namespace icebow {
namespace {

using Triangle = std::array<Vec3, 3>;

// Coordinates of the water: along the surface forward, to port, and up from it.
struct WaterFrame {
  Vec3 origin, forward, up;

  explicit WaterFrame(const Flotation& at)
      : origin(at.x_level, 0.0, at.level),
        forward(std::cos(at.trim), 0.0, -std::sin(at.trim)),
        up(std::sin(at.trim), 0.0, std::cos(at.trim)) {}
  Vec3 local(const Vec3& p) const { return {(p - origin).dot(forward), p.y(), (p - origin).dot(up)}; }
  Vec3 hull(const Vec3& p) const { return origin + p.x() * forward + Vec3(0.0, p.y(), 0.0) + p.z() * up; }
};

struct Wetted {
  std::vector<Triangle> triangles;                                     // in the water's frame
  Vec3 lower = Vec3::Constant(1e300), upper = Vec3::Constant(-1e300);  // of the waterline, same frame

  void touch(const Vec3& p) {
    lower = lower.cwiseMin(p);
    upper = upper.cwiseMax(p);
  }
};

// The part of a triangle below the surface: nothing, a triangle or a quad. A triangle that only touches the
// surface from above is dry.
void add_wetted(const Triangle& t, Wetted& wetted) {
  if (std::none_of(t.begin(), t.end(), [](const Vec3& p) { return p.z() < 0.0; })) return;
  std::array<Vec3, 4> part;
  int n = 0;
  for (int k = 0; k < 3; ++k) {
    const Vec3 &p = t[k], &q = t[(k + 1) % 3];
    if (p.z() <= 0.0) part[n++] = p;
    if (p.z() == 0.0) wetted.touch(p);
    if ((p.z() < 0.0 && q.z() > 0.0) || (p.z() > 0.0 && q.z() < 0.0)) {
      part[n] = p + p.z() / (p.z() - q.z()) * (q - p);
      part[n].z() = 0.0;
      wetted.touch(part[n++]);
    }
  }
  for (int k = 2; k < n; ++k) wetted.triangles.push_back({part[0], part[k - 1], part[k]});
}

Wetted wetted_hull(const QuadMesh& mesh, const WaterFrame& frame) {
  std::vector<Vec3> local;
  local.reserve(mesh.points.size());
  for (const Vec3& p : mesh.points) local.push_back(frame.local(p));
  Wetted wetted;
  for (const auto& t : triangles(mesh)) add_wetted({local[t[0]], local[t[1]], local[t[2]]}, wetted);
  return wetted;
}

// Integrals over the wetted surface, n its outward normal. Every integrand is at most quadratic, for which
// the rule of the three edge midpoints is exact.
struct Moments {
  double area = 0.0;           // of the surface
  double volume = 0.0;         // z n_z: divergence 1, zero on the water surface, like the next
  Vec3 first = Vec3::Zero();   // (x z, y z, z^2/2) n_z: divergence (x, y, z)
  Vec3 plane = Vec3::Zero();   // (1, x, y) over the waterplane, which is what n_z dA projects to, turned over
  Vec3 second = Vec3::Zero();  // (x^2, y^2, 0) over the waterplane
};

Moments moments(const std::vector<Triangle>& wetted) {
  Moments m;
  for (const Triangle& t : wetted) {
    const Vec3 twice = (t[1] - t[0]).cross(t[2] - t[0]);
    m.area += 0.5 * twice.norm();
    const double share = 0.5 * twice.z() / 3.0;
    for (int k = 0; k < 3; ++k) {
      const Vec3 p = 0.5 * (t[k] + t[(k + 1) % 3]);
      m.volume += share * p.z();
      m.first += share * p.z() * Vec3(p.x(), p.y(), 0.5 * p.z());
      m.plane -= share * Vec3(1.0, p.x(), p.y());
      m.second -= share * Vec3(p.x() * p.x(), p.y() * p.y(), 0.0);
    }
  }
  return m;
}

double lowest(const QuadMesh& mesh) {
  return bounding_box(mesh).lower.z();
}

[[noreturn]] void not_afloat(const QuadMesh& mesh, const Flotation& at) {
  const Box box = bounding_box(mesh);
  throw InputError(text(
      "the water surface at z = %g m (x = %g m, trim %g deg) does not cut the hull, whose points are from z "
      "= "
      "%g to %g m: give a draft above 0 and below %g m, or less trim",
      at.level, at.x_level, degrees(at.trim), box.lower.z(), box.upper.z(), box.upper.z() - box.lower.z()));
}

// Immersed area of the section at x; a vertex in the section's plane counts as ahead of it or as behind.
double section_area(const std::vector<Triangle>& wetted, double x, bool vertex_ahead) {
  double twice = 0.0;
  for (const Triangle& t : wetted) {
    const auto ahead = [&](int k) { return vertex_ahead ? t[k].x() >= x : t[k].x() > x; };
    Vec3 in = Vec3::Zero(), out = Vec3::Zero();
    bool cut = false;
    for (int k = 0; k < 3; ++k) {
      const int l = (k + 1) % 3;
      if (ahead(k) == ahead(l)) continue;
      const Vec3 crossing = t[k] + (x - t[k].x()) / (t[l].x() - t[k].x()) * (t[l] - t[k]);
      (ahead(l) ? in : out) = crossing;
      cut = true;
    }
    if (cut) twice += (in.z() + out.z()) * (out.y() - in.y());
  }
  return 0.5 * std::abs(twice);
}

}  // namespace

Hydrostatics hydrostatics(const QuadMesh& mesh, const Flotation& at, double water_density) {
  const WaterFrame frame(at);
  const Wetted wetted = wetted_hull(mesh, frame);
  const Moments m = moments(wetted.triangles);
  if (!(m.volume > 0.0) || !(m.plane[0] > 0.0)) not_afloat(mesh, at);
  const double keel = lowest(mesh), xf = m.plane[1] / m.plane[0], yf = m.plane[2] / m.plane[0];
  Hydrostatics h;
  h.volume = m.volume;
  h.displacement = water_density * m.volume;
  h.buoyancy = frame.hull(m.first / m.volume);
  h.KB = h.buoyancy.z() - keel;
  h.waterplane_area = m.plane[0];
  h.flotation = frame.hull({xf, yf, 0.0});
  h.I_T = m.second[1] - h.waterplane_area * yf * yf;
  h.I_L = m.second[0] - h.waterplane_area * xf * xf;
  h.wetted_area = m.area;
  h.length = wetted.upper.x() - wetted.lower.x();
  h.beam = wetted.upper.y() - wetted.lower.y();
  h.draft = at.level - keel;
  h.fore_end = frame.hull({wetted.upper.x(), 0.0, 0.0}).x();
  h.aft_end = frame.hull({wetted.lower.x(), 0.0, 0.0}).x();
  h.block_coefficient = h.volume / (h.length * h.beam * h.draft * std::cos(at.trim));
  h.waterplane_coefficient = h.waterplane_area / (h.length * h.beam);
  h.BM_T = h.I_T / h.volume;
  h.BM_L = h.I_L / h.volume;
  h.KM_T = h.KB + h.BM_T * frame.up.z();
  return h;
}

double displaced_volume(const QuadMesh& mesh, double level) {
  return moments(wetted_hull(mesh, WaterFrame({level, 0.0, 0.0})).triangles).volume;
}

double immersed_section(const QuadMesh& mesh, double level, double x) {
  return section_area(wetted_hull(mesh, WaterFrame({level, 0.0, 0.0})).triangles, x, true);
}

std::vector<SectionArea> sectional_areas(const QuadMesh& mesh, const Flotation& at, int stations) {
  // Sheared, not turned: the surface becomes level and sections keep their plane, areas and heights.
  QuadMesh level = mesh;
  const double slope = std::tan(at.trim);
  for (Vec3& p : level.points) p.z() -= at.level + (at.x_level - p.x()) * slope;
  const Wetted wetted = wetted_hull(level, WaterFrame(Flotation{}));
  if (wetted.triangles.empty()) not_afloat(mesh, at);
  double aft = 1e300, fore = -1e300;
  for (const Triangle& t : wetted.triangles)
    for (const Vec3& p : t) aft = std::min(aft, p.x()), fore = std::max(fore, p.x());
  std::vector<SectionArea> curve;
  for (int k = 0; k < stations; ++k) {
    const double share = static_cast<double>(k) / (stations - 1);
    const double x = k == stations - 1 ? fore : aft + share * (fore - aft);
    curve.push_back({x, section_area(wetted.triangles, x, share > 0.5)});
  }
  return curve;
}

}  // namespace icebow
