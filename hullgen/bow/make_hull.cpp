#include "hullgen/bow/make_hull.h"

#include <cmath>

#include "hullgen/bow/bow_angles.h"
#include "hullgen/bow/bow_mesh.h"
#include "hullgen/bow/bow_surface.h"
#include "hullgen/bow/family.h"
#include "hullgen/bow/feasibility.h"
#include "hullgen/mesh/mesh_check.h"

namespace icebow {

Hull make_hull(const BowParameters& bow) {
  Hull hull;
  hull.form = family_form(bow.family).name;
  hull.requested = bow.angles;
  hull.feasibility = check_feasibility(bow);
  hull.reason = hull.feasibility.reason;
  if (!hull.feasibility.feasible) return hull;

  hull.mesh = bow_mesh(bow);
  const double rounded = stem_half_width(bow);
  hull.measured = measure_angles(hull.mesh, bow_beam(bow), rounded);
  if (rounded > 0.0) hull.stem_radius = measured_stem_radius(hull.mesh, bow_beam(bow), rounded);
  hull.waterline_at_quarter_beam = std::atan(std::tan(hull.measured.flare) * std::tan(hull.measured.buttock));
  hull.flare_at_stem = std::atan(std::tan(hull.measured.waterline) / std::tan(hull.measured.stem));

  hull.reason = angle_mismatch(bow.angles, hull.measured);
  if (hull.reason.empty()) hull.reason = check_mesh(hull.mesh).reason();
  hull.status = hull.reason.empty() ? HullStatus::ok : HullStatus::mesh_rejected;
  if (hull.status == HullStatus::mesh_rejected) hull.mesh = QuadMesh();
  return hull;
}

}  // namespace icebow
