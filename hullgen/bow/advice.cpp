#include "hullgen/bow/advice.h"

#include <cmath>

#include "base/units.h"
#include "hullgen/bow/bow_surface.h"

namespace icebow {

double at_least(double value) {
  return std::ceil(value * 100.0) / 100.0;
}
double at_most(double value) {
  return std::floor(value * 100.0) / 100.0;
}
double to_deg(double cotangent) {
  return degrees(acot(cotangent));
}

}  // namespace icebow
