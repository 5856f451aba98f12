#include "study/model_notes.h"

#include <cmath>

namespace icebow {

std::vector<std::string> model_notes(const Case& c) {
  std::vector<std::string> notes;
  if (c.ice_model != IceModel::calibrated) return notes;
  const bool water_moves =
      c.water.drag > 0.0 && (c.water.added_mass > 0.0 || c.water.inertia == WaterInertia::plane);
  if (!c.numerics.floe_contact || !water_moves)
    notes.push_back(
        "calibrated ice whose pieces pass through each other or move no water has a third of the mean load "
        "that it has with solver.floe_contact, water.added_mass_m and water.drag (docs/validation.md)");
  if (std::lround(c.ice.h / c.numerics.dx) < 3)
    notes.push_back(
        "calibrated ice of fewer than three layers comes apart into sheets that lie on each other: "
        "solver.layers 3 or more for loads (docs/validation.md)");
  return notes;
}

}  // namespace icebow
