#include "solver/ice/ice_cloud.h"

#include <cmath>
#include <map>
#include <utility>

namespace icebow {

void mark_cracks(IceCloud& ice, const std::vector<CrackedPlace>& places) {
  // Columns stand at half or whole multiples of the spacing.
  const auto column = [&](double x, double y) {
    return std::pair{std::llround(2.0 * x / ice.dx), std::llround(2.0 * y / ice.dx)};
  };
  std::map<std::pair<long long, long long>, std::int32_t> kinds;
  for (const CrackedPlace& place : places)
    kinds[column(place.x, place.y)] = 1 + static_cast<std::int32_t>(place.kind);
  ice.crack.assign(ice.x.size(), 0);
  for (std::size_t i = 0; i < ice.x.size(); ++i) {
    const float x = ice.x[i] - ice.ux[i], y = ice.y[i] - ice.uy[i];
    if (!std::isfinite(x) || !std::isfinite(y)) continue;
    const auto found = kinds.find(column(x, y));
    if (found != kinds.end()) ice.crack[i] = found->second;
  }
}

}  // namespace icebow
