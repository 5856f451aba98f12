// Curves of form: hydrostatics over draught, the draught for a displacement, and righting levers. Names and
// definitions are those of Principles of Naval Architecture [Lewis1988].
#pragma once

#include <vector>

#include "hullgen/hydro/hydrostatics.h"

namespace icebow {

// One draught of the curves, on even keel.
struct FormAtDraft {
  Hydrostatics values;
  double midship_area = 0.0;           //!< immersed section at half the waterline's length [m^2]
  double midship_coefficient = 0.0;    // midship_area / (beam draft)
  double prismatic_coefficient = 0.0;  // volume / (length midship_area)
  double tonnes_per_cm = 0.0;          //!< TPC: immersion [t/cm]
  double moment_to_trim = 0.0;  //!< MCT: density volume BM_L / (100 length), taking GM_L as BM_L [t m/cm]
  double lcb_percent = 0.0;     //!< of the length, from half of it, positive forward [%]
  double lcf_percent = 0.0;     //!< the same of the centre of flotation [%]
};
// `level` is z of the water surface. Throws InputError where it does not cut the hull.
FormAtDraft form_at(const QuadMesh& mesh, double level, double water_density);

// Drafts evenly spaced from `lowest` to `highest` above the keel [m], ends included.
std::vector<FormAtDraft> curves_of_form(const QuadMesh& mesh, double lowest, double highest, int drafts,
                                        double water_density);

// The draught at which the hull displaces the volume [m^3], on even keel, to 1e-9 of the depth, by bisection:
// volume grows with draught. Throws InputError where the whole hull displaces less.
double draft_for_volume(const QuadMesh& mesh, double volume);

struct RightingLever {
  double heel = 0.0;  //!< to port side down [rad]
  double KN = 0.0;    //!< lever about the keel, on the centre plane: GZ = KN - KG sin(heel) [m]
};
// At the volume displaced with the water surface at z = level, without change of trim. Watertight up to the
// mesh's top: no opening floods.
std::vector<RightingLever> righting_levers(const QuadMesh& mesh, double level,
                                           const std::vector<double>& heels);

}  // namespace icebow
