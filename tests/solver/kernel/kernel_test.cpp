#include "solver/kernel/kernel.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <random>
#include <tuple>
#include <vector>

#include "base/errors.h"
#include "tests/support/ice_block.h"

using namespace icebow;

namespace {

template <class Real, int n>
double evaluate(const Real (&c)[n], double e) {
  double p = 0.0;
  for (int power = n - 1; power >= 0; --power) p = p * e + c[power];
  return p;
}

// `first` is what the coefficients of G and H are divided by.
template <class Real, int degree>
void check_fits(const LawFits<Real, degree>& law, double lower, double upper, double tolerance,
                double first = 0.5) {
  for (int n = 0; n <= 1000; ++n) {
    const double e = lower + (upper - lower) * n / 1000.0, root = std::sqrt(1.0 + e);
    CHECK(std::abs(first * evaluate(law.G, e) * (1.0 + root) - 1.0) < tolerance);
    CHECK(std::abs(evaluate(law.R, e) * root - 1.0) < tolerance);
    CHECK(std::abs(first * evaluate(law.H, e) * root * (1.0 + root) - 1.0) < tolerance);
  }
}

Vec3 rotated(const Vec3& x, double angle) {
  return {std::cos(angle) * x.x() - std::sin(angle) * x.z(), x.y(),
          std::sin(angle) * x.x() + std::cos(angle) * x.z()};
}

// What a strain of 1e-3 would cause: the yardstick for "no force".
double elastic_acceleration(const IceBlock& b) {
  return 1e-3 * b.material.kappa / (826.6 * b.lattice.dx);
}

Material stretch_material(double s0) {
  IceMaterial ice = block_scenario(1, 1, 1).ice;
  ice.s0 = s0;
  return make_material(ice, 0.013, 3.0);
}

}  // namespace

TEST_CASE("the fitted bond law is the exact one") {
  for (double s0 : {0.0005, 0.0052, 0.04}) {
    const auto fp32 = make_bond_law<float>(stretch_material(s0));
    check_fits(fp32.wide, fp32.e_min, fp32.e_max, 2e-6);
    check_fits(fp32.small, -fp32.e_small, fp32.e_small, 2e-6);
    check_fits(fp32.calm, -fp32.e_calm, fp32.e_calm, 1e-6);  // 5/8 e^2 is the next term of H
    const auto fp64 = make_bond_law<double>(stretch_material(s0));
    check_fits(fp64.wide, fp64.e_min, fp64.e_max, 2e-11);
    check_fits(fp64.small, -fp64.e_small, fp64.e_small, 2e-11);
    check_fits(fp64.calm, -fp64.e_calm, fp64.e_calm, 1e-9);
  }
}

TEST_CASE("rigid motion and a quarter turn of a floe cause no force and break nothing") {
  IceBlock b(block_scenario(20, 9, 3));
  for (double angle : {0.0, 0.3, 1.5707963}) {
    b.displace([&](const Vec3& x) -> Vec3 { return rotated(x, angle) - x + Vec3(0.1, -0.05, 0.2); });
    CHECK(b.accelerate() == 0);
    CHECK(b.largest_acceleration() < 2e-2 * elastic_acceleration(b));  // found 4e-3: single precision
  }
}

TEST_CASE("uniform expansion has its trace as dilatation, at edges and corners too") {
  IceBlock b(block_scenario(20, 11, 3));
  const double strain = 1e-4;
  b.displace([&](const Vec3& x) -> Vec3 { return strain * x; });
  b.accelerate();
  double lowest = 1.0, highest = 0.0;
  b.for_each([&](int, int, int, std::size_t p) {
    lowest = std::min(lowest, double(b.sheet.theta[p]));
    highest = std::max(highest, double(b.sheet.theta[p]));
  });
  // The correction makes each axis exact for a particle whose neighbours are like itself; at a corner they
  // are not.
  CHECK(lowest > 0.75 * 3 * strain);
  CHECK(highest < 1.25 * 3 * strain);
}

TEST_CASE("uniaxial strain of a thick block carries the continuum's stress") {
  const int n = 22;
  IceBlock b(block_scenario(n, n, n));
  const double strain = 2e-4;
  b.displace([&](const Vec3& x) -> Vec3 { return Vec3(strain * x.x(), 0.0, 0.0); });
  b.accelerate();
  double force = 0.0;  // that the left half exerts on the right one: inner forces of the right half cancel
  const double mass = 826.6 * b.lattice.particle_volume();
  b.for_each([&](int i, int, int, std::size_t p) {
    if (i >= n / 2) force += mass * b.acceleration(p).x();
  });
  const double area = n * n * b.lattice.dx * b.lattice.dx;
  const double stress = strain * (b.material.kappa + 4.0 * b.material.mu / 3.0);
  CHECK(-force / area == Approx(stress).epsilon(0.03));  // the block's own faces
}

TEST_CASE("bond forces cancel: no net force, no net moment") {
  IceBlock b(block_scenario(33, 10, 3));
  std::mt19937 random(7);
  std::uniform_real_distribution<double> uniform(-1e-6, 1e-6);
  b.displace([&](const Vec3&) -> Vec3 { return Vec3(uniform(random), uniform(random), uniform(random)); });
  b.accelerate();
  Vec3 sum = Vec3::Zero();
  double magnitude = 0.0;
  b.for_each([&](int, int, int, std::size_t p) {
    sum += b.acceleration(p);
    magnitude += b.acceleration(p).norm();
  });
  CHECK(sum.norm() < 1e-7 * magnitude);  // found 5e-9: rounding of the sums
}

TEST_CASE("an overstretched bond breaks and never heals") {
  IceBlock b(block_scenario(40, 9, 2));
  const std::int64_t before = b.sheet.bits.count();
  const double cut = 20 * b.lattice.dx;
  b.displace([&](const Vec3& x) -> Vec3 { return Vec3(x.x() > cut ? 0.002 : 0.0, 0.0, 0.0); });
  const std::int64_t broken = b.accelerate();
  CHECK(broken > 0);
  CHECK(b.sheet.bits.count() == before - broken);
  CHECK(b.accelerate() == 0);
  b.displace([](const Vec3&) -> Vec3 { return Vec3::Zero(); });
  CHECK(b.accelerate() == 0);
  CHECK(b.sheet.bits.count() == before - broken);
}

TEST_CASE("a strongly compressed bond pushes back and does not break") {
  IceBlock b(block_scenario(20, 9, 2));
  b.displace([&](const Vec3& x) -> Vec3 { return Vec3(-0.3 * x.x(), 0.0, 0.0); });
  CHECK(b.accelerate() == 0);
  double first = 0.0, last = 0.0;
  b.for_each([&](int i, int j, int, std::size_t p) {
    if (j != 4) return;
    if (i == 0) first = b.acceleration(p).x();
    if (i == 19) last = b.acceleration(p).x();
  });
  CHECK(first < 0.0);
  CHECK(last > 0.0);
}

TEST_CASE("linear blocks: the force of a smooth small field is that of the full law") {
  // All layers, ends and sides of the sheet: each has weights of its own.
  for (int nz : {1, 2, 3, 4}) {
    Scenario s = block_scenario(70, 20, nz);
    IceBlock linear(s);
    s.numerics.linear_below = 0.0;
    IceBlock full(s);
    for (IceBlock* b : {&linear, &full}) {
      b->displace([&](const Vec3& x) -> Vec3 {
        return 1e-5 * Vec3(0.3 + std::sin(20 * x.y() + 3 * x.x()), std::cos(15 * x.x() - 30 * x.z()),
                           std::sin(12 * x.x()) * std::cos(20 * x.y()));
      });
      b->accelerate();
    }
    CHECK(linear.sheet.linear_share() == 1.0);
    CHECK(full.sheet.linear_share() == 0.0);
    const double largest = full.largest_acceleration();
    double error = 0.0, theta_error = 0.0;
    full.for_each([&](int, int, int, std::size_t p) {
      error = std::max(error, (linear.acceleration(p) - full.acceleration(p)).norm() / largest);
      theta_error = std::max(theta_error, std::abs(linear.sheet.theta[p] - full.sheet.theta[p]));
    });
    INFO(nz << " layers: force " << error << ", dilatation " << theta_error);
    CHECK(error < 1e-3);        // displacement gradients reach 3e-4
    CHECK(theta_error < 2e-7);  // found 9.5e-8: second order in those gradients
  }
}

TEST_CASE("linear blocks end where ice is bent, and next to a crack") {
  IceBlock b(block_scenario(160, 20, 3));
  const double bent = 40 * b.lattice.dx;
  b.displace([&](const Vec3& x) -> Vec3 { return {0.0, 0.0, x.x() < bent ? 1.1e-3 * (bent - x.x()) : 0.0}; });
  b.accelerate();
  // Blocks 0 to 2 are bent or within a bond's reach of it, 3 to 9 are not.
  CHECK(b.sheet.linear_share() == Approx(0.7));
  b.displace([](const Vec3&) -> Vec3 { return Vec3::Zero(); });
  b.accelerate();
  CHECK(b.sheet.linear_share() == 1.0);
  const double cut = 120 * b.lattice.dx;
  b.displace([&](const Vec3& x) -> Vec3 { return Vec3(x.x() > cut ? 0.002 : 0.0, 0.0, 0.0); });
  CHECK(b.accelerate() > 0);
  b.displace([](const Vec3&) -> Vec3 { return Vec3::Zero(); });
  b.accelerate();
  CHECK(b.sheet.linear_share() ==
        Approx(0.9));  // the cut runs through block 7, and no bond of others is broken
}

namespace {

// The widths that this processor runs.
std::vector<const Kernels*> all_kernels() {
  std::vector<const Kernels*> all;
  for (const char* name : {"avx512", "avx2", "baseline"}) {
    try {
      all.push_back(&kernels_named(name));
    } catch (const InputError&) {
    }
  }
  return all;
}

// Smooth ice, ice strained so that each law is somewhere, and ice with cracks and bonds about to break.
void load(IceBlock& b, double size) {
  b.displace([size](const Vec3& x) -> Vec3 {
    return {size * std::sin(40 * x.y()), 2 * size * std::sin(30 * x.x()), size * x.x() / 0.5};
  });
}

}  // namespace

TEST_CASE("every vector width computes the same, and breaks the same bonds") {
  for (const double strength : {0.0, 30e3}) {
    for (const double size : {1e-6, 1e-5, 1e-4}) {
      Scenario s = block_scenario(40, 9, 3);
      s.ice.tensile_strength = strength;
      IceBlock wide(s);
      load(wide, size);
      wide.accelerate();
      const double scale = wide.largest_acceleration();
      for (const Kernels* kernel : all_kernels()) {
        IceBlock narrow(s, Communicator::serial(), *kernel);
        load(narrow, size);
        narrow.accelerate();
        INFO(kernel->name << " " << strength << " Pa, " << size << " m");
        // A bond within rounding of its limit may go either way.
        CHECK(std::abs(narrow.sheet.bits.count() - wide.sheet.bits.count()) <= 2);
        if (narrow.sheet.bits.count() != wide.sheet.bits.count()) continue;
        double error = 0.0;
        wide.for_each([&](int, int, int, std::size_t p) {
          error = std::max(error, (wide.acceleration(p) - narrow.acceleration(p)).norm());
        });
        CHECK(error <
              1e-4 * scale);  // sums of some 100 terms in single precision, which cancel to a tenth or so
      }
    }
  }
}

namespace {

// A gradient of some `size`, with shear and a rotation; a few bonds cut at every block.
void strain_and_cut(IceBlock& b, double size) {
  b.displace([size](const Vec3& x) -> Vec3 {
    return size *
           Vec3(x.x() + std::sin(40.0 * x.y()) / 80.0, std::cos(50.0 * x.x()) / 60.0 - x.y(), 0.3 * x.x());
  });
  for (int jl = 0; jl < b.sheet.layout.columns; ++jl)
    for (int n = 0; n < b.sheet.layout.blocks * b.sheet.bits.per_block(); n += 11)
      b.sheet.bits.row(jl, 0)[n] &= 0xbdf7;
  b.sheet.find_cracks();
}

void follow(IceBlock& b, BlockLaw law) {
  const Layout& layout = b.sheet.layout;
  for (int jl = 0; jl < layout.columns; ++jl)
    for (int k = 0; k < layout.nz; ++k)
      for (int n = 0; n < layout.blocks; ++n) {
        std::uint8_t& state = b.sheet.state(jl, k)[n];
        state = static_cast<std::uint8_t>((state & cracked) | law);
      }
}

}  // namespace

TEST_CASE("ice summed for all layers at once is what it is row by row under the longest law") {
  // Largest e some 2.7 times the size: where the way back from the longest law is not yet open, and at less.
  const auto [law, back, size] = GENERATE(std::tuple(calm, bent, 3e-4), std::tuple(bent, wide, 3e-3));
  const Precision precision = GENERATE(Precision::fp32, Precision::fp64);
  const int layers = GENERATE(1, 2, 3, 4);
  Scenario s = block_scenario(50, 20, layers);
  s.numerics.precision = precision;
  s.numerics.linear_below = 0.0;
  IceBlock b(s);
  strain_and_cut(b, size);
  b.accelerate();
  std::vector<double> theta;
  std::vector<Vec3> acceleration;
  b.for_each([&](int, int, int, std::size_t p) {
    theta.push_back(b.sheet.theta[p]);
    acceleration.push_back(b.acceleration(p));
  });
  CHECK(law_of(b.sheet.state(2, 0)[1]) == law);
  follow(b, wide);
  b.accelerate();
  CHECK(law_of(b.sheet.state(2, 0)[1]) == back);
  double theta_error = 0.0, error = 0.0;
  std::size_t n = 0;
  b.for_each([&](int, int, int, std::size_t p) {
    theta_error = std::max(theta_error, std::abs(b.sheet.theta[p] - theta[n]));
    error = std::max(error, (b.acceleration(p) - acceleration[n]).norm());
    ++n;
  });
  INFO(layers << " layers, " << (precision == Precision::fp32 ? "fp32" : "fp64") << ", gradient " << size);
  // The law to 2e-6 or 1e-9 of a bond; sums of 100 bonds, which cancel to a tenth, in the fields'
  // precision.
  const double tolerance = precision == Precision::fp32 ? 1e-4 : 1e-7;
  CHECK(theta_error < tolerance * 3 * size);
  CHECK(error < tolerance * b.largest_acceleration());
}

TEST_CASE("a vector width that is not known or not to be had is refused with what there is") {
  CHECK_THROWS_WITH(kernels_named("sse9"), Catch::Contains("ICEBOW_KERNEL=sse9: no such vector width") &&
                                               Catch::Contains("allowed here:") &&
                                               Catch::Contains("baseline"));
  CHECK(kernels_named("baseline").vector_bytes == 16);
  CHECK(kernels_named("").vector_bytes == all_kernels().front()->vector_bytes);
}
