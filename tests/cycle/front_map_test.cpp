#include "cycle/front_map.h"

#include <catch2/catch.hpp>

#include "cycle/strips.h"
#include "tests/cycle/panels.h"

using namespace icebow;
using namespace icebow::cycle;

constexpr double rounding = 1e-12;  // of double, some ten operations

TEST_CASE("Front map: a plane is where it is, with its slopes") {
  const double stem = 0.5, angle = 0.4;
  const FrontMap map(sharp_stem(10.0, stem, angle, 3.0), {-4.0, 0.5, 7.0}, -2.0, 0.5, 9);
  for (int row = 0; row < map.rows(); ++row) {
    const double z = map.z(row);
    CHECK(map.x(0, row) == Approx(z / std::tan(stem) - 4.0 / std::tan(angle)).epsilon(rounding));
    CHECK(map.x(2, row) == Approx(z / std::tan(stem) - 7.0 / std::tan(angle)).epsilon(rounding));
    CHECK(map.slope_y(0, row) == Approx(-1.0 / std::tan(angle)).epsilon(rounding));
    CHECK(map.slope_y(1, row) == Approx(1.0 / std::tan(angle)).epsilon(rounding));
  }
}

TEST_CASE("Front map: the foremost of two surfaces, nothing beside the hull") {
  QuadMesh mesh = plate(10.0, 1.0, 3.0);
  add_panel(mesh, {5.0, -1.0, -1.0}, {5.0, 1.0, -1.0}, {5.0, 1.0, 1.0}, {5.0, -1.0, 1.0});
  const FrontMap map(mesh, {-6.0, -3.0, 0.0}, -2.0, 1.0, 5);
  CHECK_FALSE(map.reaches(0, 2));
  CHECK(map.x(1, 2) == Approx(0.0).margin(rounding));
  CHECK(map.x(2, 2) == 5.0);
  CHECK(map.x(2, 0) == Approx(-2.0 / std::tan(1.0)));  // below the second panel
}

TEST_CASE("Strips: mirrored, without gaps, as narrow as the raster along the waterline") {
  const double angle = 0.4, half_beam = 10.0, raster = 0.2;
  const Strips strips = make_strips(sharp_stem(half_beam, 0.5, angle, 3.0), -0.9, 0.1, raster, 3.0, false);
  CHECK(strips.half_beam == Approx(half_beam).epsilon(1e-3));  // found by 2001 samples
  CHECK(strips.length ==
        Approx(half_beam / std::tan(angle)).epsilon(5e-3));  // found by samples: 0.05 % is lost
  const int n = strips.count();
  double width = 0.0;
  for (int i = 0; i < n; ++i) {
    const auto k = static_cast<std::size_t>(i), mirrored = static_cast<std::size_t>(n - 1 - i);
    CHECK(strips.y[k] == -strips.y[mirrored]);
    width += strips.width[k];
    if (i > 0) CHECK(strips.y[k] - strips.y[k - 1] == Approx(0.5 * (strips.width[k] + strips.width[k - 1])));
    if (std::abs(strips.y[k]) < half_beam) CHECK(strips.width[k] / std::sin(angle) < 1.1 * raster);
  }
  CHECK(width == Approx(2.0 * (half_beam + 3.0)).epsilon(2e-3));  // the half-beam is found by samples
  const Strips port = make_strips(sharp_stem(half_beam, 0.5, angle, 3.0), -0.9, 0.1, raster, 3.0, true);
  CHECK(port.count() == n / 2);
  CHECK(port.y.front() > 0.0);
}

TEST_CASE("Strips: none where the hull is above or below the ice") {
  const QuadMesh high = mapped(plate(10.0, 1.0, 1.0), Vec3::Ones(), {0.0, 0.0, 3.0});
  CHECK(make_strips(high, -0.9, 0.1, 0.2, 3.0, false).count() == 0);
}
