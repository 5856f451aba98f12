// The one file that includes OpenTURNS; loaded with it when points are first asked for.
#include <openturns/ComposedDistribution.hxx>
#include <openturns/GeometricProfile.hxx>
#include <openturns/HaltonSequence.hxx>
#include <openturns/LHSExperiment.hxx>
#include <openturns/Log.hxx>
#include <openturns/RandomGenerator.hxx>
#include <openturns/SimulatedAnnealingLHS.hxx>
#include <openturns/SobolSequence.hxx>
#include <openturns/SpaceFillingPhiP.hxx>
#include <openturns/Uniform.hxx>

#include "study/plan/sampling.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace icebow {
namespace {

using Points = std::vector<std::vector<double>>;

constexpr int most_annealed = 100;   // points: the annealing's time grows with their square
constexpr int most_of_sobol = 1000;  // dimensions

Points points_of(const OT::Sample& sample) {
  Points points;
  for (OT::UnsignedInteger i = 0; i < sample.getSize(); ++i) {
    std::vector<double> point;
    for (OT::UnsignedInteger k = 0; k < sample.getDimension(); ++k) point.push_back(sample(i, k));
    points.push_back(point);
  }
  return points;
}

// Along each axis, the k-th point in order moves to a random place in the k-th of the equal intervals.
void make_latin(Points& points) {
  const auto n = static_cast<double>(points.size());
  std::vector<std::size_t> order(points.size());
  for (std::size_t axis = 0; axis < points.front().size(); ++axis) {
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::sort(order.begin(), order.end(),
              [&](std::size_t a, std::size_t b) { return points[a][axis] < points[b][axis]; });
    for (std::size_t k = 0; k < order.size(); ++k)
      points[order[k]][axis] = (static_cast<double>(k) + OT::RandomGenerator::Generate()) / n;
  }
}

// Sobol' points, turned by a random vector and then made Latin: spread evenly in any number, in a time that
// grows with that number (Saka, Gunzburger and Burkardt 2007).
Points latinised_sobol(int dimension, int n) {
  Points points = points_of(OT::SobolSequence(dimension).generate(n));
  const OT::Point shift = OT::RandomGenerator::Generate(dimension);
  for (std::vector<double>& point : points)
    for (int k = 0; k < dimension; ++k) point[k] = std::fmod(point[k] + shift[k], 1.0);
  make_latin(points);
  return points;
}

}  // namespace

// SpaceFillingPhiP is the smooth form of the smallest distance (Morris and Mitchell 1995), what annealing can
// follow.
extern "C" void icebow_latin_hypercube(int dimension, int n, std::uint64_t seed,
                                       std::vector<std::vector<double>>& points) {
  OT::Log::Show(OT::Log::NONE);
  OT::RandomGenerator::SetSeed(seed);
  if (n > most_annealed && dimension <= most_of_sobol) {
    points = latinised_sobol(dimension, n);
    return;
  }
  const OT::ComposedDistribution cube(
      OT::ComposedDistribution::DistributionCollection(dimension, OT::Uniform(0.0, 1.0)));
  OT::LHSExperiment shuffled(cube, n, /*alwaysShuffle*/ true, /*randomShift*/ true);
  points = points_of(n > 1 && n <= most_annealed
                         ? OT::SimulatedAnnealingLHS(shuffled, OT::SpaceFillingPhiP()).generate()
                         : shuffled.generate());
}

// The first `n` points of a sequence in the unit cube: a longer one begins with the shorter.
extern "C" void icebow_sequence(bool sobol, int dimension, int n, std::vector<std::vector<double>>& points) {
  OT::Log::Show(OT::Log::NONE);
  points =
      points_of(sobol ? OT::SobolSequence(dimension).generate(n) : OT::HaltonSequence(dimension).generate(n));
}

}  // namespace icebow
