// What fp32 costs in accuracy: the same cases in fp32 and in fp64.
//
//   bench/precision [--json]
//
// Bending: a free strip of ice, 160 x 8 x 3 particles, rings in its first bending mode with a surface strain
// of a tenth of the critical one, 3000 steps. Breaking: a small ship sails 0.5 m into a sheet of 36,000
// particles. There rounding decides when a bond at its limit breaks, and two records part like any two runs
// of a chaotic system: compared are their means.
#include <cmath>
#include <cstdio>
#include <cstring>
#include <iostream>
#include <nlohmann/json.hpp>

#include "base/communicator.h"
#include "bench/machine.h"
#include "solver/lattice/stability.h"
#include "solver/run/simulation.h"
#include "tests/support/ice_block.h"
#include "tests/support/tiny_hull.h"

using namespace icebow;

namespace {

constexpr double dx = 0.013;

class Strip {
 public:
  explicit Strip(Precision precision) : ice_(scenario(precision)) {
    const double L = ice_.lattice.nx * dx;
    // A mode's curvature, near enough: w = a cos(2 pi x / L), surface strain a (2 pi / L)^2 h / 2.
    const double k = 2.0 * 3.14159265358979 / L, a = 5.2e-4 / (k * k * 1.5 * dx);
    ice_.displace([&](const Vec3& x) -> Vec3 {
      const double z = x.z() - ice_.lattice.z(1);
      return {z * a * k * std::sin(k * x.x()), 0.0, a * std::cos(k * x.x())};
    });
    drift_.dt = 0.8 * stable_time_step(ice_.sheet.stencil, ice_.material, dx, 826.6, true);
    drift_.inverse_dx = 1.0 / dx;
  }
  void run(int steps) {
    for (int n = 0; n < steps; ++n) {
      ice_.sheet.drift(drift_);
      ice_.sheet.dilatation();
      ice_.sheet.force();
    }
  }
  IceBlock& ice() { return ice_; }

 private:
  static Scenario scenario(Precision precision) {
    Scenario s = block_scenario(160, 8, 3);
    s.numerics.precision = precision;
    return s;
  }
  IceBlock ice_;
  DriftSettings drift_{};
};

// Largest difference of the displacements over their largest value.
double bending_error(int steps) {
  Strip single(Precision::fp32), reference(Precision::fp64);
  single.run(steps);
  reference.run(steps);
  double difference = 0.0, largest = 0.0;
  single.ice().for_each([&](int, int, int, std::size_t p) {
    for (int c = 0; c < 3; ++c) {
      const double u = reference.ice().sheet.u[c][p];
      difference = std::max(difference, std::abs(single.ice().sheet.u[c][p] - u));
      largest = std::max(largest, std::abs(u));
    }
  });
  return difference / largest;
}

RunResult breaking(Precision precision) {
  Scenario s;
  s.ice = {0.04, 826.6, 52e6, 0.33, 0.0, 60e3};
  s.sheet = {1.6, 1.2, FixedEdges::sides};
  s.numerics.dx = 0.04 / 3.0;
  s.numerics.friction = 0.1;
  s.numerics.precision = precision;
  s.V = 0.5;
  s.advance = 0.5;
  s.steady_from = 0.05;
  return simulate(Communicator::serial(), sloping_box(0.45, 0.4, 0.08, 0.15, 1.2), s, {});
}

nlohmann::json summary(const RunResult& r) {
  return {{"mean_load_N", r.metrics.resistance.mean},
          {"mean_load_ci95_N", r.metrics.resistance.ci95},
          {"max_load_N", r.metrics.resistance.max},
          {"broken_bonds", r.metrics.broken_bonds}};
}

// Samples until two load records differ by more than a thousandth of their largest value.
int samples_together(const RunResult& a, const RunResult& b) {
  std::size_t n = 0;
  while (n < a.history.rows.size() &&
         std::abs(a.history.rows[n].F[0] - b.history.rows[n].F[0]) < 1e-3 * b.metrics.resistance.max)
    ++n;
  return static_cast<int>(n);
}

}  // namespace

int main(int argc, char** argv) {
  const bool json = argc > 1 && !std::strcmp(argv[1], "--json");
  const RunResult single = breaking(Precision::fp32), reference = breaking(Precision::fp64);
  nlohmann::json result = {{"bending", {}}, {"machine", machine_context()}};
  for (int steps : {300, 3000})
    result["bending"].push_back({{"steps", steps}, {"largest_difference", bending_error(steps)}});
  result["breaking"] = {{"fp32", summary(single)},
                        {"fp64", summary(reference)},
                        {"samples", single.history.rows.size()},
                        {"samples_together", samples_together(single, reference)}};
  if (json) {
    std::cout << result << "\n";
    return 0;
  }
  for (const auto& b : result["bending"]) {
    std::printf("bending, %d steps: displacements differ by at most %.2g of the largest one\n",
                b["steps"].get<int>(), b["largest_difference"].get<double>());
  }
  for (const char* name : {"fp32", "fp64"}) {
    const auto& r = result["breaking"][name];
    std::printf("breaking, %s: mean load %.2f +- %.2f N, largest %.2f N, %lld broken bonds\n", name,
                r["mean_load_N"].get<double>(), r["mean_load_ci95_N"].get<double>(),
                r["max_load_N"].get<double>(), r["broken_bonds"].get<long long>());
  }
  std::printf("breaking: records agree to 0.1 %% of the largest load for %d of %zu samples\n",
              result["breaking"]["samples_together"].get<int>(), single.history.rows.size());
}
