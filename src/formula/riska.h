// Level-ice resistance of Riska et al. 1997 ("Performance of merchant vessels in ice in the Baltic"): a line
// in the speed, fitted to full-scale trials of Baltic ships. The ice's strength does not enter.
#pragma once

#include <string>

namespace icebow {

struct RiskaInputs {
  double L = 0.0;      //!< ship length [m]
  double B = 0.0;      //!< beam [m]
  double T = 0.0;      //!< draught [m]
  double L_par = 0.0;  //!< length of the parallel midbody at the waterline [m]
  double L_bow = 0.0;  //!< length of the bow at the waterline [m]
  double stem = 0.0;   //!< phi, stem angle on the centre line [rad]
  double h = 0.0;      //!< ice thickness [m]
  double V = 0.0;      //!< speed [m/s]
};

struct RiskaResult {
  bool valid = false;
  std::string reason;  // the violated guard in words; empty where valid
  double C1 = 0.0;     //!< resistance at no speed [N]
  double C2 = 0.0;     //!< its growth with speed [N s/m]
  double total = 0.0;  //!< C1 + C2 V [N]
};

RiskaResult riska_1997(const RiskaInputs& in);

}  // namespace icebow
