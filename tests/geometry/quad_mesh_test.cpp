#include "geometry/quad_mesh.h"

#include <catch2/catch.hpp>

using namespace icebow;

namespace {

// A box [0, a] x [0, b] x [0, c] shifted by `at`, outward.
QuadMesh box_mesh(double a, double b, double c, const Vec3& at) {
  QuadMesh mesh;
  for (int k = 0; k < 8; ++k) mesh.points.push_back(at + Vec3(a * (k & 1), b * (k >> 1 & 1), c * (k >> 2)));
  mesh.quads = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
  mesh.patch.assign(6, Patch::other);
  return mesh;
}

// Corner of the axes cut by x + y + z = 1.
QuadMesh tetrahedron() {
  QuadMesh mesh;
  mesh.points = {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1)};
  mesh.quads = {{0, 2, 1, 1}, {0, 1, 3, 3}, {0, 3, 2, 2}, {1, 2, 3, 3}};
  mesh.patch.assign(4, Patch::other);
  return mesh;
}

}  // namespace

TEST_CASE("bounding box of a shifted box") {
  const Box box = bounding_box(box_mesh(2.0, 3.0, 4.0, Vec3(-1.0, 5.0, -7.0)));
  CHECK(box.lower == Vec3(-1.0, 5.0, -7.0));
  CHECK(box.upper == Vec3(1.0, 8.0, -3.0));
}

TEST_CASE("enclosed volume does not depend on where the box stands, and its sign on the orientation") {
  for (const Vec3& at : {Vec3(0, 0, 0), Vec3(100.0, -20.0, 3.0)})
    CHECK(enclosed_volume(box_mesh(2.0, 3.0, 4.0, at)) == Approx(24.0));
  QuadMesh inward = box_mesh(2.0, 3.0, 4.0, Vec3::Zero());
  for (auto& q : inward.quads) std::swap(q[1], q[3]);
  CHECK(enclosed_volume(inward) == Approx(-24.0));
}

TEST_CASE("what has no mirror image in the plane y = 0 is found") {
  QuadMesh mesh = box_mesh(2.0, 3.0, 4.0, Vec3(0.0, -1.5, 0.0));
  CHECK_FALSE(place_without_mirror_image(mesh, 1e-3));
  mesh.points[2].z() += 1e-4;
  CHECK_FALSE(place_without_mirror_image(mesh, 1e-3));
  mesh.points[2].z() += 0.1;
  REQUIRE(place_without_mirror_image(mesh, 1e-3));
  CHECK(place_without_mirror_image(mesh, 1e-3)->x() == 0.0);
  CHECK(place_without_mirror_image(box_mesh(2.0, 3.0, 4.0, Vec3::Zero()), 1e-3));

  // All points have images, but a side is cut into triangles on port alone.
  QuadMesh cut = box_mesh(2.0, 3.0, 4.0, Vec3(0.0, -1.5, 0.0));
  const std::array<int, 4> side = cut.quads[3];
  cut.quads[3] = {side[0], side[1], side[2], side[2]};
  cut.quads.push_back({side[0], side[2], side[3], side[3]});
  CHECK(place_without_mirror_image(cut, 1e-3));
  const std::array<int, 4> other = cut.quads[2];  // its corners in mirrored order, repeating another corner
  cut.quads[2] = {other[0], other[0], other[1], other[2]};
  cut.quads.push_back({other[0], other[2], other[3], other[3]});
  CHECK_FALSE(place_without_mirror_image(cut, 1e-3));
}

TEST_CASE("triangles count once") {
  const QuadMesh mesh = tetrahedron();
  CHECK(mesh.is_triangle(0));
  CHECK_FALSE(box_mesh(1, 1, 1, Vec3::Zero()).is_triangle(0));
  CHECK(enclosed_volume(mesh) == Approx(1.0 / 6.0));
}

TEST_CASE("scaling multiplies points and leaves panels and patches alone") {
  const QuadMesh full = box_mesh(2.0, 3.0, 4.0, Vec3(1.0, 2.0, 3.0));
  const QuadMesh model = scaled(full, 1.0 / 25.0);
  CHECK((model.points[7] - full.points[7] / 25.0).norm() < 1e-15);  // rounding of 1/25
  CHECK(model.quads == full.quads);
  CHECK(model.patch == full.patch);
  CHECK(enclosed_volume(model) == Approx(24.0 / (25.0 * 25.0 * 25.0)));
}
