// What is mended in a mesh, and what is refused.
#include "hullgen/mesh/mesh_repair.h"

#include <catch2/catch.hpp>

#include "base/errors.h"
#include "geometry/triangles.h"
#include "hullgen/bow/bow_mesh.h"
#include "hullgen/bow/family.h"
#include "hullgen/mesh/mesh_check.h"
#include "hullgen/mesh/mesh_edges.h"

using namespace icebow;

namespace {

const QuadMesh& whole() {
  static const QuadMesh mesh = [] {
    BowParameters bow = preset_bow(BowFamily::concave);
    bow.panel = bow.B / 10.0;
    return bow_mesh(bow);
  }();
  return mesh;
}

// Each panel with points of its own, moved by up to `noise` [m], as a file of poor precision has them.
QuadMesh torn(const QuadMesh& mesh, double noise) {
  QuadMesh result;
  result.patch = mesh.patch;
  for (const auto& q : mesh.quads) {
    std::array<int, 4> own;
    for (int k = 0; k < 4; ++k) {
      own[k] = static_cast<int>(result.points.size());
      if (k == 3 && q[3] == q[2]) {
        own[3] = own[2];
        continue;
      }
      const double sign = result.points.size() % 2 == 0 ? 1.0 : -1.0;
      result.points.push_back(mesh.points[q[k]] + sign * noise * Vec3(0.5, -0.5, 0.5));
    }
    result.quads.push_back(own);
  }
  return result;
}

void turn_over(std::array<int, 4>& q) {
  q = q[2] == q[3] ? std::array<int, 4>{q[0], q[2], q[1], q[1]} : std::array<int, 4>{q[0], q[3], q[2], q[1]};
}

QuadMesh port_half(const QuadMesh& mesh) {
  QuadMesh half;
  half.points = mesh.points;
  for (std::size_t k = 0; k < mesh.quads.size(); ++k) {
    double y = 0.0;
    for (const int corner : mesh.quads[k]) y += mesh.points[corner].y();
    if (y <= 0.0) continue;
    half.quads.push_back(mesh.quads[k]);
    half.patch.push_back(mesh.patch[k]);
  }
  return without_unused_points(half);
}

QuadMesh mended(const QuadMesh& mesh, MeshRepairs& repairs) {
  repairs = {};
  const QuadMesh result = repaired(mesh, "hull.obj", repairs);
  CHECK(check_mesh(result).reason() == "");
  CHECK(enclosed_volume(result) ==
        Approx(enclosed_volume(whole())).epsilon(1e-5));  // found 7e-6: a hole closed flat
  return result;
}

}  // namespace

TEST_CASE("a sound mesh is left as it is") {
  MeshRepairs repairs;
  const QuadMesh same = mended(whole(), repairs);
  CHECK(same.quads.size() == whole().quads.size());
  CHECK(in_words(repairs).empty());
  CHECK(repairs.components == 1);
}

TEST_CASE("points that are nearly the same become one") {
  MeshRepairs repairs;
  const QuadMesh mesh = torn(whole(), 0.2 * joining_distance(whole()));
  const QuadMesh joined = mended(mesh, repairs);
  CHECK(joined.points.size() == whole().points.size());
  CHECK(repairs.joined == static_cast<int>(mesh.points.size() - whole().points.size()));
}

TEST_CASE("panels that face inward are turned, one by one or all") {
  MeshRepairs repairs;
  QuadMesh mesh = whole();
  for (std::size_t k = 0; k < mesh.quads.size(); k += 3) turn_over(mesh.quads[k]);
  mended(mesh, repairs);
  CHECK(repairs.turned == static_cast<int>((mesh.quads.size() + 2) / 3));
  mesh = whole();
  for (auto& q : mesh.quads) turn_over(q);
  mended(mesh, repairs);
  CHECK(repairs.turned == static_cast<int>(mesh.quads.size()));
}

TEST_CASE("panels without area and panels given twice are dropped") {
  MeshRepairs repairs;
  QuadMesh mesh = whole();
  mesh.quads.push_back(mesh.quads[7]);
  const int a = mesh.quads[9][0], b = mesh.quads[9][1];
  mesh.quads.push_back({a, b, a, a});
  mesh.patch.insert(mesh.patch.end(), 2, Patch::other);
  CHECK(mended(mesh, repairs).quads.size() == whole().quads.size());
  CHECK(repairs.repeated == 1);
  CHECK(repairs.collapsed == 1);
}

TEST_CASE("one side and its image are the whole hull") {
  MeshRepairs repairs;
  const QuadMesh half = port_half(whole());
  const QuadMesh both = with_mirror_image(half, "hull.obj", repairs);
  CHECK(repairs.mirrored == static_cast<int>(half.quads.size()));
  CHECK(mended(both, repairs).quads.size() == whole().quads.size());
  CHECK_THROWS_WITH(with_mirror_image(whole(), "hull.obj", repairs),
                    Catch::Contains("both sides already") && Catch::Contains("hull.obj"));
  CHECK_THROWS_WITH(repaired(half, "hull.obj", repairs),
                    Catch::Contains("not closed") && Catch::Contains("mirror"));
}

TEST_CASE("a half hull's lid in the centre plane is left out") {
  // A unit cube from y = 0 to 1.
  QuadMesh cube;
  for (int k = 0; k < 8; ++k) cube.points.push_back(Vec3(k & 1, k >> 1 & 1, k >> 2));
  cube.quads = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
  cube.patch.assign(6, Patch::other);
  MeshRepairs repairs;
  const QuadMesh both = repaired(with_mirror_image(cube, "cube.obj", repairs), "cube.obj", repairs);
  CHECK(check_mesh(both).ok());
  CHECK(both.quads.size() == 10);
  CHECK(enclosed_volume(both) == Approx(2.0));
}

TEST_CASE("a quad folded along its shorter diagonal is split along the other") {
  // A prism over a dart: its lid and floor have a reflex corner at D, nearer to B than A is to C.
  QuadMesh prism;
  for (const double z : {0.0, 1.0})
    for (const Eigen::Vector2d& p :
         {Eigen::Vector2d(-2, 0), Eigen::Vector2d(0, 3), Eigen::Vector2d(2, 0), Eigen::Vector2d(0, 1)})
      prism.points.emplace_back(p.x(), p.y(), z);
  prism.quads = {{0, 1, 2, 3}, {4, 7, 6, 5}, {0, 4, 5, 1}, {1, 5, 6, 2}, {2, 6, 7, 3}, {3, 7, 4, 0}};
  prism.patch.assign(6, Patch::other);
  MeshRepairs repairs;
  const QuadMesh mesh = repaired(prism, "dart.obj", repairs);
  CHECK(check_mesh(mesh).ok());
  CHECK(enclosed_volume(mesh) == Approx(4.0));
  // The shorter diagonal B-D is inside already; with B farther off it is A-C, outside.
  for (Vec3& p : prism.points)
    if (p.y() == 3.0) p.y() = 9.0;
  repairs = {};
  const QuadMesh split = repaired(prism, "dart.obj", repairs);
  CHECK(repairs.split == 2);
  CHECK(check_mesh(split).ok());
  CHECK(enclosed_volume(split) == Approx(16.0));
}

TEST_CASE("a wall on an edge is left out, a hole in the bow is refused with its place") {
  MeshRepairs repairs;
  QuadMesh wall = whole();
  const auto& q = wall.quads[5];
  wall.points.push_back(wall.points[q[0]] + Vec3(-5.0, 0.0, 0.0));
  const int tip = static_cast<int>(wall.points.size()) - 1;
  wall.quads.push_back({q[0], q[1], tip, tip});
  wall.patch.push_back(Patch::other);
  CHECK(mended(wall, repairs).quads.size() == whole().quads.size());
  CHECK_THAT(repairs.notes.at(0), Catch::Contains("1 panel that hangs on an edge"));
  QuadMesh open = whole();
  std::size_t kept = 0;
  for (std::size_t k = 0; k < open.quads.size(); ++k) {
    const bool bow = open.patch[k] == Patch::bow && open.points[open.quads[k][0]].y() > 0.0;
    if (!bow) open.quads[kept] = open.quads[k], open.patch[kept++] = open.patch[k];
  }
  open.quads.resize(kept);
  open.patch.resize(kept);
  CHECK_THROWS_WITH(
      repaired(open, "hull.obj", repairs),
      Catch::Contains("hull.obj: the mesh is not closed") && Catch::Contains("m across, one at ("));
}
