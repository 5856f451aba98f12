// Stands in front of latin_hypercube.cpp, which is loaded with OpenTURNS.
#include "base/plugin.h"
#include "study/plan/sampling.h"

namespace icebow {

std::vector<std::vector<double>> latin_hypercube(int dimension, int n, std::uint64_t seed) {
  using Sample = void (*)(int, int, std::uint64_t, std::vector<std::vector<double>>&);
  static const auto sample =
      reinterpret_cast<Sample>(plugin_function("libicebow_sampling.so", "icebow_latin_hypercube"));
  std::vector<std::vector<double>> points;
  sample(dimension, n, seed, points);
  return points;
}

}  // namespace icebow
