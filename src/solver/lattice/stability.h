// The largest stable time step of the lattice.
#pragma once

#include "solver/lattice/stencil.h"
#include "solver/model/scenario.h"

namespace icebow {

// dt_limit = 2 / omega_max of the leapfrog scheme [s]. omega_max is the highest frequency of a small free
// sheet with this many layers: its edges and corners, where surface corrections stiffen the bonds, decide the
// limit. Found by Lanczos iterations on the linearised forces. Breaking bonds only lowers frequencies.
double stable_time_step(const Stencil& stencil, const Material& material, double dx, double rho,
                        bool surface_correction);

// The limit where particles of this mass [kg] also have springs of this stiffness [N/m] to the hull: no
// frequency rises above the root of omega_max^2 + stiffness / mass (Weyl's inequality).
double with_contact(double dt_limit, double stiffness, double mass);

}  // namespace icebow
