// Waves in the ice, and the tones of free bars and strips: see docs/verification.md.
#include <catch2/catch.hpp>
#include <cmath>

#include "base/units.h"
#include "tests/support/bent_ice.h"
#include "tests/support/motion.h"

using namespace icebow;

namespace {

enum class Wave { P, S };

double speed(Wave wave, const IceBlock& b, double rho) {
  const Material& m = b.material;
  return std::sqrt((wave == Wave::P ? m.kappa + 4.0 * m.mu / 3.0 : m.mu) / rho);
}

// Of a plane wave, from the acceleration in the middle of a block so large that nothing there feels its
// faces.
double found_speed(IceBlock& b, const Vec3& along, const Vec3& polarisation, double wavelength) {
  const int ci = b.lattice.nx / 2, cj = b.lattice.ny / 2, ck = b.lattice.nz / 2;
  const Vec3 middle = b.position(ci, cj, ck);
  const double wave_number = 2.0 * pi / wavelength, amplitude = 1e-6 * b.lattice.dx;
  b.displace([&](const Vec3& x) -> Vec3 {
    return amplitude * std::cos(wave_number * along.dot(x - middle)) * polarisation;
  });
  b.accelerate();
  const double a = b.acceleration(b.sheet.layout.row(cj, ck) + ci).dot(polarisation);
  return std::sqrt(-a / amplitude) / wave_number;
}

}  // namespace

TEST_CASE("long P and S waves travel with sqrt((kappa + 4/3 mu)/rho) and sqrt(mu/rho), short ones slower") {
  const Scenario s = in_double_precision(block_scenario(33, 21, 21));
  IceBlock b(s);
  const Vec3 axis(1.0, 0.0, 0.0), face(std::sqrt(0.5), std::sqrt(0.5), 0.0),
      space = Vec3(1.0, 1.0, 1.0).normalized(), z(0.0, 0.0, 1.0),
      across(std::sqrt(0.5), -std::sqrt(0.5), 0.0);
  struct Case {
    Wave wave;
    Vec3 along, polarisation;
    const char* name;
  };
  for (const Case& c : {Case{Wave::P, axis, axis, "P 100"}, Case{Wave::P, face, face, "P 110"},
                        Case{Wave::P, space, space, "P 111"}, Case{Wave::S, axis, z, "S 100"},
                        Case{Wave::S, face, across, "S 110"}, Case{Wave::S, space, across, "S 111"}}) {
    const double theory = speed(c.wave, b, s.ice.rho);
    double shorter = 0.0;
    for (int lambda : {8, 12, 24, 48, 96}) {
      const double ratio = found_speed(b, c.along, c.polarisation, lambda * b.lattice.dx) / theory;
      INFO(c.name << ", wavelength " << lambda << " dx: " << ratio << " of theory");
      CHECK(ratio > shorter);  // dispersion
      shorter = ratio;
    }
    INFO(c.name << ", longest wave: " << shorter << " of theory");
    CHECK(shorter == Approx(1.0).epsilon(0.055));  // the lattice has directions: horizon of 3 dx
    if (c.wave == Wave::P && c.along == axis)
      CHECK(shorter == Approx(1.0).epsilon(0.002));  // the correction is made for it
  }
}

TEST_CASE("a standing P wave in a block swings with the period wavelength / c until its faces are heard") {
  const Scenario s = block_scenario(49, 27, 27);
  IceBlock ice(s);
  const double lambda = 16 * ice.lattice.dx, middle = ice.lattice.x(24);
  ice.displace([&](const Vec3& x) -> Vec3 {
    return {1e-6 * std::cos(2.0 * pi * (x.x() - middle) / lambda), 0.0, 0.0};
  });
  ice.accelerate();
  Crossings crossings(2);
  const std::size_t p = ice.sheet.layout.row(13, 13) + 24;
  const double c = speed(Wave::P, ice, s.ice.rho);
  Motion(ice, s, 0.0).run(lambda / c, [&](double t) { return crossings.add(t, ice.sheet.u[0][p]); });
  INFO("period " << crossings.period() << " s, theory " << lambda / c << " s");
  CHECK(crossings.period() == Approx(lambda / c).epsilon(0.05));  // dispersion: 16 dx are 5.3 horizons
}

TEST_CASE("a free bar rings along its length with the period 2 L / sqrt(E/rho)") {
  const int n = 96;
  const Scenario s = block_scenario(n, 7, 3);
  IceBlock ice(s);
  const double L = n * ice.lattice.dx;
  ice.displace([&](const Vec3& x) -> Vec3 { return {1e-5 * std::cos(pi * x.x() / L), 0.0, 0.0}; });
  ice.accelerate();
  Crossings crossings;
  const std::size_t end = ice.sheet.layout.row(3, 1);
  Motion(ice, s, 0.0).run(0.1, [&](double t) { return crossings.add(t, ice.sheet.u[0][end]); });
  const double theory = 2.0 * L / std::sqrt(s.ice.E / s.ice.rho);
  INFO("period " << crossings.period() << " s, theory " << theory << " s");
  CHECK(crossings.period() == Approx(theory).epsilon(0.06));  // the corrected edges are too stiff
}

TEST_CASE("a free strip rings in its first bending mode as the beam of its own modulus") {
  const int layers = 3, ny = 12, n = 60;
  const Scenario s = block_scenario(n, ny, layers);
  IceBlock ice(s);
  const double L = n * ice.lattice.dx, h = s.ice.h, beta = 4.730041 / L;
  const double middle = 0.5 * (ice.lattice.z(0) + ice.lattice.z(layers - 1)), sigma = 0.982502;
  const auto mode = [&](double bx) {  // of a free-free beam, Blevins 1979, table 8-1
    return std::cosh(bx) + std::cos(bx) - sigma * (std::sinh(bx) + std::sin(bx));
  };
  const auto slope = [&](double bx) {
    return std::sinh(bx) - std::sin(bx) - sigma * (std::cosh(bx) + std::cos(bx));
  };
  ice.displace([&](const Vec3& x) -> Vec3 {
    const double bx = beta * x.x();
    return 1e-5 * Vec3(-(x.z() - middle) * beta * slope(bx), 0.0, mode(bx));
  });
  ice.accelerate();
  Crossings crossings(5);
  Motion(ice, s, 0.0).run(0.3, [&](double t) {
    double part = 0.0;  // of the mode in the deflection
    for (int i = 0; i < n; ++i)
      part += mode(beta * ice.lattice.x(i)) * ice.sheet.u[2][ice.sheet.layout.row(ny / 2, 1) + i];
    return crossings.add(t, part);
  });
  // Rayleigh's quotient of the mode for rotary inertia and for shear.
  const double r2 = h * h / (12.0 * L * L), G = s.ice.E / (2.0 * (1.0 + s.ice.nu));
  const double slower = std::sqrt(1.0 + r2 * (49.48 + 12.30 * s.ice.E / (5.0 / 6.0 * G)));
  const auto period = [&](double E) {
    return 2.0 * pi * slower / (beta * beta * std::sqrt(E * h * h / (12.0 * s.ice.rho)));
  };
  const double modulus = beam_modulus(layers, ny, true);
  INFO("period " << crossings.period() << " s; theory " << period(s.ice.E) << " s with E, " << period(modulus)
                 << " s with the modulus of the beam at rest");
  CHECK(crossings.period() == Approx(period(modulus)).epsilon(0.02));  // two ways to the same modulus
}
