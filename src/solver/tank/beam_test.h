// What a cantilever test of ice measures.
#pragma once

namespace icebow {

struct BeamTest {
  double elastic_modulus = 0.0;    //!< E of the Timoshenko cantilever as stiff as the unbroken one [Pa]
  double flexural_strength = 0.0;  //!< 6 F L / (b h^2) at the highest force [Pa]
  int breaks = 0;                  // equilibria that the piece went through
};

}  // namespace icebow
