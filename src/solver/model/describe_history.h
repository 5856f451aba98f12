// The columns of a load record, written once: history.csv and the checkpoint are visitors of this
// description.
//
// A visitor has two functions: column(name, value) for what every sample has, a double or a 64-bit integer,
// and sometimes(name, value) for what is NaN where it was not evaluated. A member that is added to HistoryRow
// does not compile until it is here.
#pragma once

#include "solver/model/history.h"

namespace icebow {

template <class Visitor, class Row>
void describe(Visitor& visit, Row& row) {
  auto& [t, advance, F, M, broken_bonds, contacts, kinetic_energy, potential, hull_work, contact_loss,
         water_loss, floe_loss, edge_loss, elastic, fracture, balance_error] = row;
  visit.column("time_s", t);
  visit.column("advance_m", advance);
  visit.column("Fx_N", F[0]);
  visit.column("Fy_N", F[1]);
  visit.column("Fz_N", F[2]);
  visit.column("Mx_Nm", M[0]);
  visit.column("My_Nm", M[1]);
  visit.column("Mz_Nm", M[2]);
  visit.column("broken_bonds", broken_bonds);
  visit.column("contacts", contacts);
  visit.sometimes("kinetic_energy_J", kinetic_energy);
  visit.sometimes("potential_J", potential);
  visit.sometimes("hull_work_J", hull_work);
  visit.sometimes("contact_loss_J", contact_loss);
  visit.sometimes("elastic_J", elastic);
  visit.sometimes("fracture_J", fracture);
  visit.sometimes("balance_error_J", balance_error);
  visit.sometimes("water_loss_J", water_loss);
  visit.sometimes("floe_loss_J", floe_loss);
  visit.sometimes("edge_loss_J", edge_loss);
}

}  // namespace icebow
