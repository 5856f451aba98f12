#include "geometry/clip_triangle.h"

#include <catch2/catch.hpp>

using namespace icebow;

namespace {

const Corners triangle{{0.1, 0.2, 0.3}, {2.7, 0.4, 1.9}, {0.6, 2.8, 0.9}};

}  // namespace

TEST_CASE("Clip: the parts of a triangle in unit cells add up to it") {
  double sum = 0.0;
  int most = 0;
  for (int x = 0; x < 3; ++x)
    for (int y = 0; y < 3; ++y)
      for (int z = 0; z < 3; ++z) {
        Polygon part(triangle);
        clip(part, 2, z, z + 1);
        clip(part, 0, x, x + 1);
        clip(part, 1, y, y + 1);
        sum += area(part);
        most = std::max(most, part.size);
        for (int k = 0; k < part.size; ++k) {
          CHECK(part.corner[k].x() >= x - 1e-12);
          CHECK(part.corner[k].y() <= y + 1 + 1e-12);
        }
      }
  CHECK(sum == Approx(area(Polygon(triangle))));
  CHECK(most > 4);
}

TEST_CASE("Clip: whole, touching and missing triangles") {
  Polygon whole(triangle);
  clip(whole, 0, -1.0, 5.0);
  CHECK(whole.size == 3);
  CHECK(whole.upper(0) == 2.7);
  CHECK(whole.lower(1) == 0.2);
  Polygon touching(triangle);
  clip(touching, 0, 2.7, 5.0);
  CHECK(touching.size >= 1);
  CHECK(area(touching) == 0.0);
  Polygon gone(triangle);
  clip(gone, 0, 3.0, 5.0);
  CHECK(gone.size == 0);
  clip(gone, 1, 0.0, 1.0);
  CHECK(area(gone) == 0.0);
}
