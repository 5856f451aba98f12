// Numbers in advice, rounded to the two printed decimals so that who follows it ends up on the feasible side.
#pragma once

namespace icebow {

double at_least(double value);
double at_most(double value);
double to_deg(double cotangent);  // angle in (0, 180) deg

}  // namespace icebow
