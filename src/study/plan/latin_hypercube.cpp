// The one file that includes OpenTURNS; loaded with it when points are first asked for.
#include <openturns/ComposedDistribution.hxx>
#include <openturns/GeometricProfile.hxx>
#include <openturns/LHSExperiment.hxx>
#include <openturns/Log.hxx>
#include <openturns/RandomGenerator.hxx>
#include <openturns/SimulatedAnnealingLHS.hxx>
#include <openturns/SpaceFillingPhiP.hxx>
#include <openturns/Uniform.hxx>

#include "study/plan/sampling.h"

namespace icebow {

// SpaceFillingPhiP is the smooth form of the smallest distance (Morris and Mitchell 1995), what annealing can
// follow.
extern "C" void icebow_latin_hypercube(int dimension, int n, std::uint64_t seed,
                                       std::vector<std::vector<double>>& points) {
  OT::Log::Show(OT::Log::NONE);
  OT::RandomGenerator::SetSeed(seed);
  const OT::ComposedDistribution cube(
      OT::ComposedDistribution::DistributionCollection(dimension, OT::Uniform(0.0, 1.0)));
  OT::LHSExperiment shuffled(cube, n, /*alwaysShuffle*/ true, /*randomShift*/ true);
  OT::Sample sample =
      n > 1 ? OT::SimulatedAnnealingLHS(shuffled, OT::SpaceFillingPhiP()).generate() : shuffled.generate();
  points.clear();
  for (OT::UnsignedInteger i = 0; i < sample.getSize(); ++i) {
    std::vector<double> point;
    for (OT::UnsignedInteger k = 0; k < sample.getDimension(); ++k) point.push_back(sample(i, k));
    points.push_back(point);
  }
}

}  // namespace icebow
