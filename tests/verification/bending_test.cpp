// Ice bent by forces at rest, against the theory of beams and plates: see docs/verification.md.
#include <catch2/catch.hpp>

#include "solver/ice/energy.h"
#include "tests/support/bent_ice.h"

using namespace icebow;

namespace {

// D over that of plate theory of a sheet to which a cylindrical curvature is given, its thickness free, from
// the elastic energy away from its edges. By the principle of least energy not below that of a sheet at rest.
double rigidity_of_given_curvature(int layers, bool corrected) {
  const double curvature = 1e-4, dx = 0.013;
  const auto energy = [&](int nx, int ny) {
    const Scenario s = in_double_precision(bent_piece(nx, ny, layers, corrected));
    IceBlock b(s);
    const Lattice& l = b.lattice;
    const Vec3 middle(0.5 * (l.x(0) + l.x(nx - 1)), 0.0, 0.5 * (l.z(0) + l.z(layers - 1)));
    const double thinning = s.ice.nu / (1.0 - s.ice.nu);
    b.displace([&](const Vec3& point) -> Vec3 {
      const Vec3 x = point - middle;
      const double w = 0.5 * (x.x() * x.x() + thinning * x.z() * x.z());
      return curvature * Vec3(-x.x() * x.z(), 0.0, w);
    });
    b.accelerate();
    const EnergyModel model(s, l, b.material, 1e-5);
    return sheet_energy(b.sheet, model).elastic * model.quantum;
  };
  const double more = energy(48, 28) - energy(48, 20) - energy(32, 28) + energy(32, 20);
  const double D = rigidity(bent_piece(40, 40, layers, corrected).ice);
  return more / (16 * 8 * dx * dx) / (0.5 * D * curvature * curvature);
}

}  // namespace

TEST_CASE("a cantilever's modulus nears E with more layers, faster than in proportion to the spacing") {
  double coarser = 1.0;
  for (int layers = 2; layers <= 5; ++layers) {
    const double ratio = beam_modulus(layers, 4 * layers, true) / 52e6, error = (1.0 - ratio) * layers;
    INFO(layers << " layers, width 4 h: modulus of the bent beam " << ratio << " of E");
    CHECK(ratio < 1.0);
    CHECK(error < coarser);
    coarser = error;
  }
  CHECK(coarser < 0.7);  // a modulus above 0.86 E with 5 layers
}

TEST_CASE("corrected edges stiffen a narrow cantilever") {
  double wider = 0.0;
  for (int width_2h : {8, 4, 3}) {
    const double ratio = beam_modulus(4, 2 * width_2h, true) / 52e6;
    INFO("4 layers, width " << 0.5 * width_2h << " h: modulus of the bent beam " << ratio << " of E");
    CHECK(ratio > wider);
    wider = ratio;
  }
}

TEST_CASE("a clamped plate's rigidity nears E h^3 / (12 (1 - nu^2)) with more layers") {
  double coarser = 1.0;
  for (int layers = 2; layers <= 4; ++layers) {
    const double ratio = plate_rigidity(layers, true), error = (1.0 - ratio) * layers,
                 given = rigidity_of_given_curvature(layers, true);
    INFO(layers << " layers: rigidity " << ratio << ", where the curvature is given " << given
                << " of theory");
    CHECK(ratio < 1.0);
    CHECK(ratio == Approx(given).epsilon(0.04));  // where the clamp begins is not exact
    CHECK(error < coarser);
    coarser = error;
  }
  CHECK(coarser < 0.7);
}

TEST_CASE(
    "a given curvature stores less than a plate's energy, for bonds between layers feel their mean strain") {
  double thinner = 0.0;
  for (int layers = 2; layers <= 5; ++layers) {
    const double corrected = rigidity_of_given_curvature(layers, true),
                 bare = rigidity_of_given_curvature(layers, false);
    const double points = 1.0 - 1.0 / (layers * layers);  // moment of inertia of n layers of points
    INFO(layers << " layers: rigidity " << corrected << ", without surface correction " << bare
                << "; layers of points have " << points << " of theory");
    CHECK(corrected > thinner);
    CHECK(corrected < points);
    CHECK(bare < 0.65 * corrected);
    thinner = corrected;
  }
}

TEST_CASE("without surface correction a sheet bends far too easily") {
  for (int layers = 2; layers <= 3; ++layers) {
    const double beam = beam_modulus(layers, 4 * layers, false) / 52e6;
    const double plate = plate_rigidity(layers, false);
    INFO(layers << " layers: beam " << beam << ", plate " << plate << " of theory");
    CHECK(beam < 0.6 * beam_modulus(layers, 4 * layers, true) / 52e6);
    CHECK(plate < 0.5);
  }
}
