#pragma once

#include <cassert>
#include <vector>

namespace icebow {

// x0 y0 z0 x1 y1 z1 ..., as VTK wants vectors.
inline std::vector<float> interleaved(const std::vector<float>& x, const std::vector<float>& y,
                                      const std::vector<float>& z) {
  assert(x.size() == y.size() && x.size() == z.size());
  std::vector<float> xyz;
  xyz.reserve(3 * x.size());
  for (std::size_t i = 0; i < x.size(); ++i) xyz.insert(xyz.end(), {x[i], y[i], z[i]});
  return xyz;
}

}  // namespace icebow
