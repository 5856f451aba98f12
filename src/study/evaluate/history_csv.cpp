#include "study/evaluate/history_csv.h"

#include <cinttypes>
#include <cmath>
#include <cstdio>

namespace icebow {

namespace {

// Empty where it was not evaluated.
std::string cell(double value) {
  if (std::isnan(value)) return ",";
  char text[32];
  std::snprintf(text, sizeof text, ",%.17g", value);
  return text;
}

}  // namespace

std::string history_csv(const History& history) {
  std::string text =
      "time_s,advance_m,Fx_N,Fy_N,Fz_N,Mx_Nm,My_Nm,Mz_Nm,broken_bonds,contacts,kinetic_energy_J,potential_J,"
      "hull_work_J,contact_loss_J,elastic_J,fracture_J,balance_error_J,water_loss_J,floe_loss_J,edge_loss_"
      "J\n";
  for (const HistoryRow& row : history.rows) {
    char line[512];
    std::snprintf(line, sizeof line, "%.17g,%.17g,%.17g,%.17g,%.17g,%.17g,%.17g,%.17g,%" PRId64 ",%" PRId64,
                  row.t, row.advance, row.F[0], row.F[1], row.F[2], row.M[0], row.M[1], row.M[2],
                  row.broken_bonds, row.contacts);
    text += line;
    for (const double energy :
         {row.kinetic_energy, row.potential, row.hull_work, row.contact_loss, row.elastic, row.fracture,
          row.balance_error, row.water_loss, row.floe_loss, row.edge_loss})
      text += cell(energy);
    text += "\n";
  }
  return text;
}

}  // namespace icebow
