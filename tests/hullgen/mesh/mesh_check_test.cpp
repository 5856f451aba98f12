#include "hullgen/mesh/mesh_check.h"

#include <catch2/catch.hpp>
#include <limits>

#include "geometry/mesh_slice.h"

using namespace icebow;

namespace {

// Unit cube, z up, outward.
QuadMesh cube() {
  QuadMesh mesh;
  for (int k = 0; k < 8; ++k) mesh.points.push_back(Vec3(k & 1, k >> 1 & 1, k >> 2));
  mesh.quads = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
  mesh.patch.assign(6, Patch::other);
  return mesh;
}

void turn_over(QuadMesh& mesh, std::size_t quad) {
  std::swap(mesh.quads[quad][1], mesh.quads[quad][3]);
}

}  // namespace

TEST_CASE("a cube passes") {
  const MeshCheck check = check_mesh(cube());
  CHECK(check.ok());
  CHECK(check.reason() == "");
  CHECK(check.quads == 6);
  CHECK(check.triangles == 0);
  CHECK(check.points == 8);
  CHECK(check.volume == Approx(1.0));
  CHECK(check.max_warp == Approx(0.0));
  CHECK(check.max_aspect == Approx(1.0));
}

TEST_CASE("a lid left open, a panel turned over, a third panel on an edge") {
  QuadMesh open = cube();
  open.quads.pop_back();
  open.patch.pop_back();
  CHECK(check_mesh(open).reason() == "the mesh is not closed");

  QuadMesh turned = cube();
  turn_over(turned, 2);
  CHECK_FALSE(check_mesh(turned).valid_polygon_mesh);
  // Its four edges run twice the same way; the first of them by its points is that of the points 0 and 1.
  CHECK(
      check_mesh(turned).reason() ==
      "the mesh is not an oriented manifold surface: neighbouring panels that face opposite ways: 4, one at "
      "(0.5, 0, 0) m");

  QuadMesh fin = cube();
  fin.points.push_back(Vec3(2.0, 0.0, 0.0));
  fin.quads.push_back({0, 1, 8, 8});
  fin.patch.push_back(Patch::other);
  CHECK_FALSE(check_mesh(fin).valid_polygon_mesh);
  CHECK(check_mesh(fin).triangles == 1);
  CHECK_THAT(check_mesh(fin).reason(),
             Catch::Contains("edges of three panels or more: 1, one at (0.5, 0, 0) m"));
}

TEST_CASE("cubes that touch in a point, a diagonal along another panel's edge") {
  QuadMesh two = cube();
  for (int k = 1; k < 8; ++k) two.points.push_back(-two.points[static_cast<std::size_t>(k)]);
  const auto mirrored = [](int corner) { return corner == 0 ? 0 : 7 + corner; };
  for (int q = 0; q < 6; ++q) {
    const auto [a, b, c, d] = two.quads[static_cast<std::size_t>(q)];
    two.quads.push_back({mirrored(a), mirrored(d), mirrored(c), mirrored(b)});
    two.patch.push_back(Patch::other);
  }
  CHECK(
      check_mesh(two).reason() ==
      "the mesh is not an oriented manifold surface: points in which surfaces touch: 1, one at (0, 0, 0) m");

  // A flat rhomb, one side a quad that is split along the diagonal where the two triangles of the other side
  // meet.
  QuadMesh rhomb;
  rhomb.points = {Vec3(0, 0, 0), Vec3(0.5, -1, 0), Vec3(1, 0, 0), Vec3(0.5, 1, 0)};
  rhomb.quads = {{0, 1, 2, 3}, {0, 2, 1, 1}, {0, 3, 2, 2}};
  rhomb.patch.assign(3, Patch::other);
  CHECK_THAT(check_mesh(rhomb).reason(),
             Catch::Contains("edges of three panels or more: 1, one at (0.5, 0, 0) m"));
}

TEST_CASE("normals inward") {
  QuadMesh mesh = cube();
  for (std::size_t q = 0; q < 6; ++q) turn_over(mesh, q);
  const MeshCheck check = check_mesh(mesh);
  CHECK(check.closed);
  CHECK_FALSE(check.outward);
  CHECK_FALSE(check.ok());
}

TEST_CASE("a corner pushed through the opposite face intersects") {
  QuadMesh mesh = cube();
  mesh.points[7] = Vec3(0.4, 0.4, -0.5);
  const MeshCheck check = check_mesh(mesh);
  CHECK(check.valid_polygon_mesh);
  CHECK(check.self_intersecting);
  CHECK_THAT(check.reason(), Catch::Contains("the mesh intersects itself") && Catch::Contains("one at ("));
}

TEST_CASE("broken input is reported, not a crash") {
  QuadMesh index = cube();
  index.quads[0][0] = 99;
  CHECK_THAT(check_mesh(index).reason(), Catch::Contains("a corner beyond the last point"));
  QuadMesh nan = cube();
  nan.points[0].x() = std::numeric_limits<double>::quiet_NaN();
  CHECK_THAT(check_mesh(nan).reason(), Catch::Contains("no finite number"));
  QuadMesh repeated = cube();
  repeated.quads[0] = {0, 2, 0, 1};
  CHECK_THAT(check_mesh(repeated).reason(),
             Catch::Contains("panels with a corner twice: 1, one at (0, 0, 0) m"));
  CHECK_THAT(check_mesh(QuadMesh()).reason(), Catch::Contains("it has no panels"));
}

TEST_CASE("warp of a quad with one corner lifted") {
  QuadMesh mesh = cube();
  mesh.points[7].z() = 1.4;  // corners alternate 0.1 above and below the mean plane
  CHECK(check_mesh(mesh).max_warp > 0.08);
  CHECK(check_mesh(mesh).max_warp < 0.1);
}

TEST_CASE("slices of a cube are closed squares") {
  for (int axis : {0, 1, 2}) {
    const auto loops = slice(cube(), axis, 0.25);
    REQUIRE(loops.size() == 1);
    CHECK((loops[0].front() - loops[0].back()).norm() < 1e-12);  // ends where it begins: rounding
    double length = 0.0;
    for (std::size_t k = 1; k < loops[0].size(); ++k) {
      CHECK(loops[0][k][axis] == 0.25);
      length += (loops[0][k] - loops[0][k - 1]).norm();
    }
    CHECK(length == Approx(4.0));
  }
  CHECK(slice(cube(), 2, 1.5).empty());
}

TEST_CASE("clipping joins the piece around the start of a loop") {
  const auto loop = slice(cube(), 2, 0.5).front();
  const auto parts = clipped(loop, 0, 0.5);
  REQUIRE(parts.size() == 1);
  double length = 0.0;
  for (std::size_t k = 1; k < parts[0].size(); ++k) length += (parts[0][k] - parts[0][k - 1]).norm();
  CHECK(length == Approx(2.0));
  CHECK(clipped(loop, 0, 2.0).empty());
}
