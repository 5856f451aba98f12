#include "study/plan/model_notes.h"

#include <cmath>

#include "solver/model/plate_on_water.h"
#include "study/spec/spec_hints.h"

namespace icebow {
namespace {

void note_on_calibrated_ice(const Case& c, std::vector<std::string>& notes) {
  if (c.ice_model != IceModel::calibrated) return;
  const bool water_moves =
      c.water.drag > 0.0 && (c.water.added_mass > 0.0 || c.water.inertia == WaterInertia::plane);
  if (!c.numerics.floe_contact || !water_moves)
    notes.push_back(
        "calibrated ice whose pieces pass through each other or move no water lacks most of the mean load "
        "that it has with solver.floe_contact, water.added_mass_m and water.drag (docs/validation.md)");
  if (std::lround(c.ice.h / c.numerics.dx) < 3)
    notes.push_back(
        "calibrated ice of fewer than three layers comes apart into sheets that lie on each other: "
        "solver.layers 3 or more for loads (docs/validation.md)");
}

// Ice laid where the sheet bends joins what is strained beyond its strength, and is torn off.
void note_on_window(const Case& c, std::vector<std::string>& notes) {
  const double length = characteristic_length(plate_on_water(c.ice.E, c.ice.nu, c.ice.h, c.water.rho));
  if (c.sheet.window_ahead == 0.0 || c.sheet.window_ahead >= length) return;
  notes.push_back("sheet.window_ahead_m is " + brief(c.sheet.window_ahead) +
                  " m, less than the characteristic length of the floating sheet, " + brief(length) +
                  " m: fresh ice is laid where the sheet bends, and is torn off; two lengths are safe");
}

// While the bow enters the ice, ever more of it breaks ice.
void note_on_entering(const Case& c, std::vector<std::string>& notes) {
  if (c.steady_from >= c.bow.Lf) return;
  notes.push_back("operation.steady_from_m is " + brief(c.steady_from) +
                  " m, less than the bow's length of " + brief(c.bow.Lf) +
                  " m: the bow is still entering the ice, and the mean load is too low; count from " +
                  brief(c.bow.Lf) + " m on, and sail that far again at the least");
}

}  // namespace

std::vector<std::string> model_notes(const Case& c, bool confirms) {
  std::vector<std::string> notes;
  note_on_calibrated_ice(c, notes);
  note_on_window(c, notes);
  if (!confirms) note_on_entering(c, notes);
  return notes;
}

}  // namespace icebow
