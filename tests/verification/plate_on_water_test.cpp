// A sheet afloat under a load at rest, against the plate on an elastic foundation of rho_w g.
#include <catch2/catch.hpp>
#include <cmath>

#include "base/units.h"
#include "bent_ice.h"

using namespace icebow;

namespace {

// Sheet whose characteristic length is `ell` spacings: soft, so that few particles make an endless plate.
struct Afloat {
  int layers;
  double ell;
  int n() const { return 2 * static_cast<int>(4.5 * ell) + 1; }
  int middle() const { return n() / 2; }
  Scenario scenario() const {
    Scenario s = bent_piece(n(), n(), layers, true);
    const double k = s.water.rho * gravity, h = s.ice.h;
    s.ice.E = 12.0 * (1.0 - s.ice.nu * s.ice.nu) * k * std::pow(ell * s.numerics.dx, 4) / (h * h * h);
    return s;
  }
};

// Deflection at distance r of an endless plate of rigidity D on a foundation k under 1 N spread over a disc
// of radius a, with shear (Mindlin 1951): the Hankel transform of k w + D del^4 w / (1 - (D/S) del^2) = p.
double endless_plate(double a, double r, double D, double S, double k) {
  const double ell = std::pow(D / k, 0.25), dt = 0.01 / ell;
  double sum = 0.0;
  for (double t = 0.5 * dt; t < 60.0 / ell; t += dt) {
    const double p = 2.0 * std::cyl_bessel_j(1.0, t * a) / (t * a) * std::cyl_bessel_j(0.0, t * r);
    sum += p * t * dt / (k + D * std::pow(t, 4) / (1.0 + D / S * t * t));
  }
  return sum / (2.0 * pi);
}

double deflection_at(const StillIce& plate, int i, int j) {
  double sum = 0.0;
  for (int k = 0; k < plate.ice.lattice.nz; ++k) sum += plate.u(i, j, k).z();
  return sum / plate.ice.lattice.nz;
}

}  // namespace

TEST_CASE("the formula for a disc and without shear is Hertz's P l^2 / (8 D) under a small one") {
  const double D = 288.0, k = 9806.65;
  CHECK(endless_plate(1e-3, 0.0, D, 1e12, k) == Approx(1.0 / (8.0 * std::sqrt(D * k))).epsilon(2e-3));
}

TEST_CASE("a loaded sheet afloat goes down as an endless plate of its own rigidity on water") {
  for (int layers : {2, 3}) {
    const Afloat sheet{layers, 8.0};
    const Scenario s = sheet.scenario();
    const int c = sheet.middle(), radius = 2;
    StillIce plate(s, Surroundings::water);
    const auto disc = [&](int i, int j, int) {
      return (i - c) * (i - c) + (j - c) * (j - c) <= radius * radius;
    };
    plate.push(disc, {0.0, 0.0, 1.0});
    plate.settle(1e-6);
    const double D = rigidity(s.ice), own = D * plate_rigidity(layers, true);
    const double S = 5.0 / 6.0 * s.ice.h * s.ice.E / (2.0 * (1.0 + s.ice.nu)), k = s.water.rho * gravity;
    const double dx = s.numerics.dx, a = std::sqrt(13.0 / pi) * dx;  // 13 particles make the disc
    for (int r : {0, 4, 8, 16}) {
      const double found = deflection_at(plate, c + r, c), nominal = endless_plate(a, r * dx, D, S, k),
                   effective = endless_plate(a, r * dx, own, S, k);
      INFO(layers << " layers, r = " << r / sheet.ell << " l: deflection " << found << " m/N, plate theory "
                  << nominal << ", with the rigidity of the clamped plate " << effective);
      CHECK(found == Approx(effective).epsilon(0.05));
    }
  }
}

TEST_CASE("at its free edge a sheet afloat goes down by Westergaard's (1 + 0.4 nu) P l^2 / (sqrt(6) D)") {
  const Afloat sheet{3, 10.0};
  const Scenario s = sheet.scenario();
  const int c = sheet.middle();
  StillIce plate(s, Surroundings::water);
  plate.push([&](int i, int j, int) { return i == 0 && j == c; }, {0.0, 0.0, 1.0});
  plate.settle(1e-6);
  const double own = plate_rigidity(3, true) * rigidity(s.ice);
  const auto theory = [&](double D) {
    return (1.0 + 0.4 * s.ice.nu) / std::sqrt(6.0 * D * s.water.rho * gravity);
  };
  const double found = deflection_at(plate, 0, c);
  INFO("deflection " << found << " m/N, theory " << theory(rigidity(s.ice))
                     << ", with the rigidity of the clamped plate " << theory(own));
  CHECK(found == Approx(theory(own)).epsilon(0.06));
}
