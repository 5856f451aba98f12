#include "hullgen/bow.h"

#include <cmath>

#include "base/units.h"
#include "hullgen/bow_angles.h"
#include "hullgen/bow_mesh.h"
#include "hullgen/mesh_check.h"
#include "hullgen/text.h"

namespace icebow {
namespace {

constexpr double angle_tolerance = radians(0.05);

// "" where the mesh has the angles that were asked for.
std::string wrong_angles(const BowAngles& asked, const BowAngles& measured) {
  if (largest_difference(asked, measured) <= angle_tolerance) return "";
  return text(
      "the mesh does not have the angles asked for (measured / asked, deg): stem %.3f / %.3f, waterline %.3f "
      "/ "
      "%.3f, buttock %.3f / %.3f, flare %.3f / %.3f: refine the panel size or widen the ice belt",
      degrees(measured.stem), degrees(asked.stem), degrees(measured.waterline), degrees(asked.waterline),
      degrees(measured.buttock), degrees(asked.buttock), degrees(measured.flare), degrees(asked.flare));
}

}  // namespace

Hull make_hull(const BowParameters& bow) {
  Hull hull;
  hull.feasibility = check_feasibility(bow);
  hull.reason = hull.feasibility.reason;
  if (!hull.feasibility.feasible) return hull;

  hull.mesh = bow_mesh(bow);
  hull.measured = measure_angles(hull.mesh, bow.B);
  hull.waterline_at_quarter_beam = std::atan(std::tan(hull.measured.flare) * std::tan(hull.measured.buttock));
  hull.flare_at_stem = std::atan(std::tan(hull.measured.waterline) / std::tan(hull.measured.stem));

  hull.reason = wrong_angles(bow.angles, hull.measured);
  if (hull.reason.empty()) hull.reason = check_mesh(hull.mesh).reason();
  hull.status = hull.reason.empty() ? HullStatus::ok : HullStatus::mesh_rejected;
  if (hull.status == HullStatus::mesh_rejected) hull.mesh = QuadMesh();
  return hull;
}

}  // namespace icebow
