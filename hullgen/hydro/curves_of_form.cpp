#include "hullgen/hydro/curves_of_form.h"

#include <Eigen/Geometry>
#include <cmath>

#include "base/errors.h"
#include "base/text.h"

namespace icebow {
namespace {

double lowest_point(const QuadMesh& mesh) {
  return bounding_box(mesh).lower.z();
}

// z of the water surface at which the mesh displaces the volume.
double level_for_volume(const QuadMesh& mesh, double volume) {
  const Box box = bounding_box(mesh);
  double lower = box.lower.z(), upper = box.upper.z();
  const double whole = enclosed_volume(mesh);
  if (!(volume > 0.0) || volume > whole)
    throw InputError(
        text("a displacement of %g m3 is asked for, but the hull has %g m3 up to its top: give less", volume,
             whole));
  const double end = 1e-9 * (upper - lower);
  while (upper - lower > end) {
    const double middle = 0.5 * (lower + upper);
    (displaced_volume(mesh, middle) < volume ? lower : upper) = middle;
  }
  return 0.5 * (lower + upper);
}

QuadMesh heeled(const QuadMesh& mesh, double heel, double keel) {
  QuadMesh result = mesh;
  const Eigen::AngleAxisd turn(-heel, Vec3::UnitX());
  for (Vec3& p : result.points) p = (turn * (p - Vec3(0.0, 0.0, keel))).eval();
  return result;
}

}  // namespace

FormAtDraft form_at(const QuadMesh& mesh, double level, double water_density) {
  FormAtDraft form;
  const Hydrostatics h = form.values = hydrostatics(mesh, {level, 0.0, 0.0}, water_density);
  const double middle = 0.5 * (h.fore_end + h.aft_end);
  form.midship_area = immersed_section(mesh, level, middle);
  form.midship_coefficient = form.midship_area / (h.beam * h.draft);
  form.prismatic_coefficient = h.volume / (h.length * form.midship_area);
  form.tonnes_per_cm = water_density * h.waterplane_area / 1e5;
  form.moment_to_trim = water_density * h.volume * h.BM_L / (1e5 * h.length);
  form.lcb_percent = 100.0 * (h.buoyancy.x() - middle) / h.length;
  form.lcf_percent = 100.0 * (h.flotation.x() - middle) / h.length;
  return form;
}

std::vector<FormAtDraft> curves_of_form(const QuadMesh& mesh, double lowest, double highest, int drafts,
                                        double water_density) {
  std::vector<FormAtDraft> curves;
  const double keel = lowest_point(mesh);
  for (int k = 0; k < drafts; ++k)
    curves.push_back(form_at(mesh, keel + lowest + k * (highest - lowest) / (drafts - 1), water_density));
  return curves;
}

double draft_for_volume(const QuadMesh& mesh, double volume) {
  return level_for_volume(mesh, volume) - lowest_point(mesh);
}

std::vector<RightingLever> righting_levers(const QuadMesh& mesh, double level,
                                           const std::vector<double>& heels) {
  const double volume = displaced_volume(mesh, level), keel = lowest_point(mesh);
  std::vector<RightingLever> levers;
  for (const double heel : heels) {
    const QuadMesh turned = heeled(mesh, heel, keel);
    const Hydrostatics h = hydrostatics(turned, {level_for_volume(turned, volume), 0.0, 0.0}, 1.0);
    levers.push_back({heel, h.buoyancy.y()});
  }
  return levers;
}

}  // namespace icebow
