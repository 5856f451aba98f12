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

std::vector<std::vector<double>> sequence(Sequence kind, int dimension, int n) {
  using Sample = void (*)(bool, int, int, std::vector<std::vector<double>>&);
  static const auto sample =
      reinterpret_cast<Sample>(plugin_function("libicebow_sampling.so", "icebow_sequence"));
  std::vector<std::vector<double>> points;
  sample(kind == Sequence::sobol, dimension, n, points);
  return points;
}

}  // namespace icebow
