// A sheet afloat under a load at rest, against the plate on an elastic foundation of rho_w g.
#include <catch2/catch.hpp>
#include <cmath>

#include "base/units.h"
#include "solver/model/plate_on_water.h"
#include "tests/support/bent_ice.h"

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

double deflection_at(const StillIce& plate, int i, int j) {
  double sum = 0.0;
  for (int k = 0; k < plate.ice.lattice.nz; ++k) sum += plate.u(i, j, k).z();
  return sum / plate.ice.lattice.nz;
}

}  // namespace

TEST_CASE("under a small disc a thin endless plate goes down as Hertz and Wyman say") {
  const double k = 9806.65, ell = 0.4, hertz = 1.0 / (8.0 * k * ell * ell);
  const PlateOnWater thin{k * std::pow(ell, 4), 1e12, k};
  CHECK(characteristic_length(thin) == Approx(ell));
  CHECK(deflection_under_disc(thin, 1e-3, 0.0) ==
        Approx(hertz).epsilon(5e-4));  // found 1.8e-4: the integral ends at 60 / ell
  // Wyman's ker' of the radius over ell, to the third power of it.
  const double a = 0.25, wyman = 1.0 + a * a / (2.0 * pi) * (std::log(0.5 * a) + 0.577216 - 1.25);
  CHECK(deflection_under_disc(thin, a * ell, 0.0) ==
        Approx(wyman * hertz).epsilon(5e-4));  // terms of (a / l)^4 are left out
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
    const PlateOnWater theory = plate_on_water(s.ice.E, s.ice.nu, s.ice.h, s.water.rho);
    PlateOnWater own = theory;
    own.bending *= plate_rigidity(layers, true);
    const double dx = s.numerics.dx, a = std::sqrt(13.0 / pi) * dx;  // 13 particles make the disc
    for (int r : {0, 4, 8, 16}) {
      const double found = deflection_at(plate, c + r, c), nominal = deflection_under_disc(theory, a, r * dx),
                   effective = deflection_under_disc(own, a, r * dx);
      INFO(layers << " layers, r = " << r / sheet.ell << " l: deflection " << found << " m/N, plate theory "
                  << nominal << ", with the rigidity of the clamped plate " << effective);
      CHECK(found == Approx(effective).epsilon(0.05));  // the clamped plate's rigidity is known to 4 %
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
  CHECK(found == Approx(theory(own)).epsilon(0.06));  // (1 + 0.4 nu) is a fit, the rigidity is known to 4 %
}
