// Inertia of deep water under a plane, against exact solutions.
#include "solver/water/water_plane.h"

#include <Eigen/Dense>
#include <catch2/catch.hpp>
#include <cmath>
#include <random>

using namespace icebow;

namespace {

constexpr double rho_w = 1000.0;

// Accelerations given: cells that no force moves.
std::vector<double> force_of(WaterPlane& plane, std::vector<double> acceleration) {
  // A force as small as 1e-9 of what they have without it.
  const std::vector<double> mobility(acceleration.size(), 1e-9);
  return plane.resistance(acceleration, mobility);
}

}  // namespace

// One side of a rigid disc in a rigid lid: 8/3 rho a^3 (Rayleigh's piston at low frequency).
TEST_CASE("a disc in a lid has its exact added mass") {
  constexpr double cell = 0.05, a = 1.0;
  WaterPlane plane({48, 48, cell, false, rho_w}, 1e-9);
  std::vector<double> up(48 * 48, 0.0);
  double area = 0.0;
  for (int i = 0; i < 48; ++i) {
    for (int j = 0; j < 48; ++j) {
      if (std::hypot((i - 23.5) * cell, (j - 23.5) * cell) > a) continue;
      up[i * 48 + j] = 1.0;
      area += cell * cell;
    }
  }
  const std::vector<double> force = force_of(plane, up);
  double on_disc = 0.0;
  for (std::size_t c = 0; c < up.size(); ++c) on_disc += up[c] * force[c];
  CHECK(area == Approx(M_PI * a * a).epsilon(0.01));  // squares make the edge of the disc
  CHECK(on_disc ==
        Approx(8.0 / 3.0 * rho_w * std::pow(std::sqrt(area / M_PI), 3)).epsilon(0.01));  // likewise
}

// Of a plane that bends in waves the water's mass is rho / k.
TEST_CASE("a wave carries the water of its wave number") {
  constexpr int n = 120;
  constexpr double cell = 0.1;
  WaterPlane plane({n, n, cell, false, rho_w}, 1e-9);
  for (const int cells : {6, 12, 24}) {
    const double k = 2.0 * M_PI / (cells * cell);
    std::vector<double> up(n * n);
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j) up[i * n + j] = std::cos(k * cell * (i - n / 2));
    const double here = force_of(plane, up)[n / 2 * n + n / 2];
    // A cell is flat: over the cell its pressure is that of steps, not of a cosine.
    CHECK(here / (cell * cell) ==
          Approx(rho_w / k).epsilon(cells > 6 ? 0.03 : 0.06));  // flat cells; the plane ends
  }
}

TEST_CASE(
    "the resistance is in balance with what it leaves of the accelerations, and a mirror changes nothing") {
  constexpr int nx = 9, ny = 7;
  constexpr double cell = 0.05, most = 1.0 / 0.08;
  std::mt19937 random(3);
  std::uniform_real_distribution<double> part(0.0, 1.0);
  std::vector<double> a(nx * ny), beta(nx * ny), whole_a(2 * nx * ny), whole_beta(2 * nx * ny);
  for (int i = 0; i < nx; ++i) {
    for (int j = 0; j < ny; ++j) {
      const int c = i * ny + j;
      beta[c] = part(random) < 0.3 ? 0.0 : most * part(random);
      a[c] = beta[c] > 0.0 ? part(random) - 0.3 : 0.0;
      for (const int jj : {ny + j, ny - 1 - j}) {
        whole_a[i * 2 * ny + jj] = a[c];
        whole_beta[i * 2 * ny + jj] = beta[c];
      }
    }
  }
  WaterPlane whole({nx, 2 * ny, cell, false, rho_w}, most), half({nx, ny, cell, true, rho_w}, most);
  const std::vector<double> force = whole.resistance(whole_a, whole_beta), by_half = half.resistance(a, beta);
  CHECK(whole.iterations() < 20);  // 5 are found
  double worst = 0.0, largest = 0.0, mirrored = 0.0;
  for (int i = 0; i < nx; ++i) {
    for (int j = 0; j < 2 * ny; ++j) {
      double sum = 0.0;
      for (int m = 0; m < nx; ++m) {
        for (int n = 0; n < 2 * ny; ++n) {
          constexpr int cuts = 24;
          double inverse = 0.0;
          for (int p = 0; p < cuts; ++p) {
            for (int q = 0; q < cuts; ++q)
              inverse += 1.0 / std::hypot(m - i + (p + 0.5) / cuts - 0.5, n - j + (q + 0.5) / cuts - 0.5);
          }
          const int c = m * 2 * ny + n;
          sum += (whole_a[c] - whole_beta[c] * force[c]) * inverse / (cuts * cuts);
        }
      }
      const double own = force[i * 2 * ny + j];
      worst = std::max(worst, std::abs(own - rho_w * std::pow(cell, 3) / (2.0 * M_PI) * sum));
      largest = std::max(largest, std::abs(own));
      if (j >= ny) mirrored = std::max(mirrored, std::abs(own - by_half[i * ny + j - ny]));
    }
  }
  REQUIRE(largest > 0.0);
  CHECK(worst < 0.02 * largest);     // of the sum over 24 x 24 points in the cell itself
  CHECK(mirrored < 1e-4 * largest);  // found 1e-6; the iterations end at 1e-4
}
