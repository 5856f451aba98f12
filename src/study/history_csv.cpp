#include "study/history_csv.h"

#include <cinttypes>
#include <cstdio>

namespace icebow {

std::string history_csv(const History& history) {
  std::string text =
      "time_s,advance_m,Fx_N,Fy_N,Fz_N,Mx_Nm,My_Nm,Mz_Nm,broken_bonds,contacts,kinetic_energy_J\n";
  for (const HistoryRow& row : history.rows) {
    char line[512];
    std::snprintf(line, sizeof line,
                  "%.17g,%.17g,%.17g,%.17g,%.17g,%.17g,%.17g,%.17g,%" PRId64 ",%" PRId64 ",%.17g\n", row.t,
                  row.advance, row.F[0], row.F[1], row.F[2], row.M[0], row.M[1], row.M[2], row.broken_bonds,
                  row.contacts, row.kinetic_energy);
    text += line;
  }
  return text;
}

}  // namespace icebow
