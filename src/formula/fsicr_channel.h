// Resistance in a channel of brash ice and a frozen layer on it, at 5 knots: the requirement on engine power
// of the Finnish-Swedish Ice Class Rules 2021 (TRAFICOM/68863/03.04.01.00/2021), 3.2.2. No level ice: the
// channel has been broken before. docs/formulas.md has the equations.
#pragma once

#include <string>
#include <vector>

namespace icebow {

struct ChannelInputs {
  double L = 0.0;          //!< length of the waterline [m]
  double B = 0.0;          //!< beam [m]
  double T = 0.0;          //!< draught [m]
  double L_bow = 0.0;      //!< length of the foreship at the waterline [m]
  double L_par = 0.0;      //!< length of the parallel midbody at the waterline [m]
  double A_wf = 0.0;       //!< waterline area of the foreship [m^2]
  double waterline = 0.0;  //!< alpha, at B/4 [rad]
  double stem = 0.0;       //!< phi_1, on the centre line [rad]
  double buttock = 0.0;    //!< phi_2, at B/4 [rad]
};

struct ChannelClass {
  std::string name;         // "IA Super", "IA", "IB", "IC"
  double thickness = 0.0;   //!< H_M, of the brash ice in the middle of the channel [m]
  double resistance = 0.0;  //!< R_CH [N]
};

struct ChannelResult {
  bool valid = false;
  std::string reason;  // the violated guard in words; empty where valid
  std::string
      caution;  // what lies outside the ships that the rule was validated on; empty where nothing does
  std::vector<ChannelClass> classes;
};

ChannelResult fsicr_channel(const ChannelInputs& in);

}  // namespace icebow
