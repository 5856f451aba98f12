// A free block of ice let go from given displacements, for peridynamics_peer_test.py.
//   free_block NX NY NZ DX NU DT STEPS CORRECTION < displacements
// Input: ux uy uz [m] of each particle, x fastest, then z, then y. Output, likewise: its acceleration at the
// start, and its displacement STEPS steps of DT later.
#include <cstdio>
#include <cstdlib>
#include <iostream>
#include <vector>

#include "tests/support/ice_block.h"

using namespace icebow;

namespace {

struct Input {
  Scenario scenario;
  double dt;
  int steps;
};

Input read(char** words) {
  Scenario s =
      block_scenario(std::atoi(words[1]), std::atoi(words[2]), std::atoi(words[3]), std::atof(words[4]));
  s.ice.nu = std::atof(words[5]);
  s.numerics.precision = Precision::fp64;
  s.numerics.surface_correction = std::atoi(words[8]) != 0;
  return {s, std::atof(words[6]), std::atoi(words[7])};
}

std::vector<Vec3> let_go(IceBlock& ice, double dt, int steps) {
  std::vector<Vec3> start;
  ice.accelerate();
  ice.for_each([&](int, int, int, std::size_t p) {
    start.push_back(ice.acceleration(p));
    // Velocities live between the steps: at rest at the start, it moved the other way before.
    for (int c = 0; c < 3; ++c) ice.sheet.v[c][p] = -0.5 * dt * start.back()[c];
  });
  DriftSettings drift{};
  drift.dt = dt;
  drift.inverse_dx = 1.0 / ice.lattice.dx;
  for (int n = 0; n < steps; ++n) {
    ice.sheet.drift(drift);
    ice.sheet.dilatation();
    ice.sheet.force();
  }
  return start;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 9) {
    std::fprintf(stderr, "usage: free_block NX NY NZ DX NU DT STEPS CORRECTION < displacements\n");
    return 2;
  }
  const Input input = read(argv);
  IceBlock ice(input.scenario);
  bool complete = true;
  ice.for_each([&](int, int, int, std::size_t p) {
    double u[3];
    complete = complete && std::cin >> u[0] >> u[1] >> u[2];
    for (int c = 0; c < 3; ++c) ice.sheet.u[c][p] = complete ? u[c] : 0.0;
  });
  if (!complete) {
    std::fprintf(stderr, "free_block: fewer displacements than particles\n");
    return 2;
  }
  std::size_t n = 0;
  const std::vector<Vec3> start = let_go(ice, input.dt, input.steps);
  ice.for_each([&](int, int, int, std::size_t p) {
    const Vec3& a = start[n++];
    std::printf("%.17g %.17g %.17g %.17g %.17g %.17g\n", a.x(), a.y(), a.z(), double(ice.sheet.u[0][p]),
                double(ice.sheet.u[1][p]), double(ice.sheet.u[2][p]));
  });
}
