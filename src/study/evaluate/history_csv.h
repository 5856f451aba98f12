// The load record of a run as a table.
#pragma once

#include <string>

#include "solver/model/history.h"

namespace icebow {

// One header line with the units, then a row a sample, every digit kept: time_s, advance_m, Fx_N, Fy_N, Fz_N,
// Mx_Nm, My_Nm, Mz_Nm, broken_bonds, contacts, kinetic_energy_J, potential_J, hull_work_J, contact_loss_J,
// elastic_J, fracture_J, balance_error_J (these three empty between their evaluations), water_loss_J,
// floe_loss_J, edge_loss_J.
std::string history_csv(const History& history);

}  // namespace icebow
