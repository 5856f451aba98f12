#include "geometry/hull_distance.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <random>

#include "base/errors.h"
#include "base/units.h"
#include "tests/support/shapes.h"

using namespace icebow;

namespace {

Box grown(Box box, double by) {
  return {box.lower - Vec3::Constant(by), box.upper + Vec3::Constant(by)};
}

std::vector<Vec3> random_points(const Box& box, int n, unsigned seed) {
  std::mt19937 engine(seed);
  std::uniform_real_distribution<double> u(0.0, 1.0);
  std::vector<Vec3> points;
  for (int i = 0; i < n; ++i) {
    const Vec3 r(u(engine), u(engine), u(engine));
    points.push_back(box.lower + r.cwiseProduct(box.upper - box.lower));
  }
  return points;
}

// Points on and close to corners, edges and faces of the mesh: where ties and signs go wrong.
std::vector<Vec3> critical_points(const QuadMesh& mesh, double offset, int n) {
  std::mt19937 engine(5);
  std::normal_distribution<double> gauss;
  std::vector<Vec3> points;
  const std::size_t stride = std::max<std::size_t>(1, mesh.quads.size() / n);
  for (std::size_t q = 0; q < mesh.quads.size(); q += stride) {
    const Vec3 &a = mesh.points[mesh.quads[q][0]], &b = mesh.points[mesh.quads[q][1]];
    const Vec3 &c = mesh.points[mesh.quads[q][2]], &d = mesh.points[mesh.quads[q][3]];
    for (const Vec3& on : {a, Vec3(0.5 * (a + b)), Vec3(0.3 * b + 0.7 * c), Vec3(0.25 * (a + b + c + d))}) {
      points.push_back(on);
      points.push_back(on + offset * Vec3(gauss(engine), gauss(engine), gauss(engine)));
    }
  }
  return points;
}

// Solid angle of the surface seen from p over 4 pi: 1 inside, 0 outside (van Oosterom and Strackee 1983).
double winding_number(const TriangleSurface& surface, const Vec3& p) {
  double angle = 0.0;
  for (std::size_t t = 0; t < surface.size(); ++t) {
    const auto [ca, cb, cc] = surface.corners(t);
    const Vec3 a = ca - p, b = cb - p, c = cc - p;
    const double la = a.norm(), lb = b.norm(), lc = c.norm();
    angle +=
        2.0 * std::atan2(a.dot(b.cross(c)), la * lb * lc + a.dot(b) * lc + a.dot(c) * lb + b.dot(c) * la);
  }
  return angle / (4.0 * pi);
}

bool same(const ClosestPoint& a, const ClosestPoint& b) {
  return a.signed_distance == b.signed_distance && a.point == b.point && a.normal == b.normal &&
         a.quad == b.quad;
}

// The filter never loses a point that is inside, and the fast search gives the bits of the slow one.
void compare_with_brute_force(const QuadMesh& mesh, const Box& region, const std::vector<Vec3>& points) {
  const HullDistance hull(mesh, region);
  int differ = 0, lost = 0, inside = 0, not_unit = 0;
  for (const Vec3& p : points) {
    const ClosestPoint slow = closest_brute_force(hull.surface(), p), fast = hull.closest(p);
    differ += !same(slow, fast);
    const bool asked = (p.array() >= region.lower.array()).all() && (p.array() <= region.upper.array()).all();
    lost += asked && slow.signed_distance < 0.0 && !hull.outlook(p).may_be_inside;
    inside += slow.signed_distance < 0.0;
    not_unit += std::abs(fast.normal.norm() - 1.0) > 1e-12;
  }
  CHECK(differ == 0);
  CHECK(lost == 0);
  CHECK(not_unit == 0);
  CHECK(inside > static_cast<int>(points.size()) / 50);
}

void compare_sign_with_winding_number(const QuadMesh& mesh, const std::vector<Vec3>& points) {
  const TriangleSurface surface(mesh);
  int wrong = 0;
  for (const Vec3& p : points) {
    const ClosestPoint at = closest_brute_force(surface, p);
    if (std::abs(at.signed_distance) < 1e-9) continue;  // on the surface: neither inside nor outside
    wrong += (winding_number(surface, p) > 0.5) != (at.signed_distance < 0.0);
  }
  CHECK(wrong == 0);
}

double box_distance(const Vec3& p) {  // of the box +-(1, 2, 3)
  const Vec3 q = p.cwiseAbs() - Vec3(1, 2, 3);
  return q.cwiseMax(0.0).norm() + std::min(q.maxCoeff(), 0.0);
}

const std::set<std::array<int, 3>> corner_of_cubes = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};

QuadMesh wedge(double sharpness, int n) {
  return shapes::mapped_cube({n, 2, n}, [=](const Vec3& p) -> Vec3 {
    return {p.x(), (p.y() - 0.5) * sharpness * (1.0 - p.x()), p.z()};
  });
}

}  // namespace

TEST_CASE("Hull distance: a box has its textbook distance") {
  const QuadMesh mesh = shapes::box({-1, -2, -3}, {1, 2, 3}, {2, 3, 4});
  const Box region = grown(bounding_box(mesh), 0.5);
  const HullDistance hull(mesh, region);
  for (const Vec3& p : random_points(region, 2000, 1))
    CHECK(hull.closest(p).signed_distance == Approx(box_distance(p)).margin(1e-13));  // rounding of metres
  const ClosestPoint at = hull.closest({0.9, 0.3, 0.4});
  CHECK(at.point.isApprox(Vec3(1, 0.3, 0.4)));
  CHECK(at.normal.isApprox(Vec3(1, 0, 0)));
  CHECK(mesh.points[mesh.quads[at.quad][0]].x() == 1.0);
}

TEST_CASE("Hull distance: equal to brute force") {
  SECTION("box") {
    for (const int n : {1, 4, 12}) {
      const QuadMesh mesh = shapes::box({-1, -2, -3}, {1, 2, 3}, {n, n, n});
      const Box region = grown(bounding_box(mesh), 0.2);
      compare_with_brute_force(mesh, region, random_points(region, 1500, 2));
      compare_with_brute_force(mesh, region, critical_points(mesh, 1e-3, 100));
    }
  }
  SECTION("wedge of 6 degrees with a sharp edge") {
    for (const int n : {1, 5, 20}) {
      const QuadMesh mesh = wedge(0.1, n);
      const Box region = grown(bounding_box(mesh), 0.02);
      compare_with_brute_force(mesh, region, random_points(region, 1500, 3));
      compare_with_brute_force(mesh, region, critical_points(mesh, 1e-3, 100));
    }
  }
  SECTION("ship-like hull cut to the ice") {
    for (const int quads : {200, 1500, 9000}) {
      const QuadMesh mesh = shapes::hull(6.0, 0.92, 0.54, quads);
      Box region = bounding_box(mesh);
      region.lower.z() = -0.3, region.upper.z() = 0.1;
      compare_with_brute_force(mesh, region, random_points(region, 600, 4));
      compare_with_brute_force(mesh, region, critical_points(mesh, 2e-3, 60));
    }
  }
  SECTION("strongly warped quads") {
    const auto wavy = [](const Vec3& p) -> Vec3 {
      return p + 0.08 * Vec3(std::sin(9 * p.y() + 4 * p.z()), std::sin(8 * p.z() + 5 * p.x()),
                             std::sin(7 * p.x() - 6 * p.y()));
    };
    for (const int n : {2, 5, 11}) {
      const QuadMesh mesh = shapes::mapped_cube({n, n, n}, wavy);
      const Box region = grown(bounding_box(mesh), 0.05);
      compare_with_brute_force(mesh, region, random_points(region, 1500, 6));
      compare_with_brute_force(mesh, region, critical_points(mesh, 1e-3, 100));
      compare_sign_with_winding_number(mesh, random_points(region, 300, 7));
    }
  }
  SECTION("quads given as triangles") {
    const QuadMesh mesh = shapes::triangulated(shapes::hull(6.0, 0.92, 0.54, 600));
    compare_with_brute_force(mesh, bounding_box(mesh), random_points(bounding_box(mesh), 500, 8));
    CHECK(mesh.is_triangle(0));
  }
}

TEST_CASE("Hull distance: the sign agrees with the winding number at edges and corners") {
  for (const QuadMesh& mesh :
       {shapes::cubes(corner_of_cubes), wedge(0.1, 3), shapes::hull(6.0, 0.92, 0.54, 300)}) {
    compare_sign_with_winding_number(mesh, random_points(grown(bounding_box(mesh), 0.1), 800, 9));
    compare_sign_with_winding_number(mesh, critical_points(mesh, 1e-4, 200));
  }
}

TEST_CASE("Hull distance: from inside a concave edge the way out is the diagonal") {
  const QuadMesh mesh = shapes::cubes(corner_of_cubes);
  const HullDistance hull(mesh, bounding_box(mesh));
  const ClosestPoint edge = hull.closest({0.9, 0.9, 0.2});
  CHECK(edge.signed_distance == Approx(-std::hypot(0.1, 0.1)));
  CHECK(edge.normal.isApprox(Vec3(1, 1, 0).normalized()));
  const ClosestPoint corner = hull.closest({0.95, 0.95, 0.95});  // three edges meet, each equally near
  CHECK(corner.signed_distance == Approx(-std::hypot(0.05, 0.05)));
  CHECK(hull.closest({1.05, 1.05, 0.2}).signed_distance == Approx(0.05));
}

TEST_CASE("Hull distance: a point that moves is told the same with and without what is known of it") {
  int searched = 0, competed = 0, asked = 0;
  for (const QuadMesh& mesh : {shapes::box({-1, -2, -3}, {1, 2, 3}, {2, 3, 4}),
                               shapes::hull(6.0, 0.92, 0.54, 2000), wedge(0.1, 5)}) {
    const Box region = grown(bounding_box(mesh), 0.05);
    const HullDistance hull(mesh, region);
    const std::vector<Vec3> from = random_points(region, 60, 13), to = random_points(region, 60, 14);
    for (std::size_t n = 0; n < from.size(); ++n) {
      HullDistance::Known known;
      Vec3 before = from[n];
      for (int step = 0; step <= 500; ++step) {
        const Vec3 p = from[n] + step / 500.0 * 0.003 * (to[n] - from[n]);
        known.moved(static_cast<float>(1.001 * (p - before).norm()));
        before = p;
        searched += known.rest <= 0.0F;
        competed += known.lead <= 0.0F;
        ++asked;
        const ClosestPoint found = hull.closest(p, known), exact = hull.closest(p);
        REQUIRE(found.signed_distance == exact.signed_distance);
        REQUIRE(found.point == exact.point);
        REQUIRE(found.normal == exact.normal);
        REQUIRE(found.quad == exact.quad);
      }
    }
  }
  CHECK(searched < asked / 10);  // or nothing would be gained
  CHECK(competed < asked / 2);
}

TEST_CASE("Hull distance: the filter is tight") {
  const QuadMesh mesh = shapes::hull(6.0, 0.92, 0.54, 2000);
  const HullDistance hull(mesh, bounding_box(mesh));
  int near = 0, mistaken = 0;
  for (const Vec3& p : random_points(bounding_box(mesh), 30000, 11)) {
    const bool maybe = hull.outlook(p).may_be_inside;
    const double distance = hull.closest(p).signed_distance;
    if (distance > 2.0 * hull.grid().size) CHECK_FALSE(maybe);
    if (distance < 0.0) CHECK(maybe);
    near += distance > 0.0 && distance < hull.grid().size;
    mistaken += distance > 0.0 && distance < hull.grid().size && maybe;
  }
  CHECK(near > 200);
  CHECK(mistaken < near / 20);  // the planes of the surface cells: without them it would be most
  CHECK_FALSE(hull.outlook({100, 0, 0}).may_be_inside);
  CHECK_FALSE(hull.outlook(Vec3::Constant(std::numeric_limits<double>::quiet_NaN())).may_be_inside);
}

TEST_CASE("Hull distance: nothing nearer than the clearance may be inside") {
  const QuadMesh mesh = shapes::hull(6.0, 0.92, 0.54, 2000);
  for (const Box& region : {bounding_box(mesh), Box{{-1, -0.3, -0.2}, {1, 0.3, 0.1}}}) {
    const HullDistance hull(mesh, region);
    const double cell = hull.grid().size;
    int far = 0, seen_far = 0, near = 0, seen_near = 0;
    for (const Vec3& p : random_points(grown(region, 0.2), 20000, 12)) {
      const HullDistance::Outlook outlook = hull.outlook(p);
      if (outlook.may_be_inside) CHECK(outlook.clearance == 0.0F);
      for (int c = 0; c < 3; ++c) {
        for (const double way : {-0.9999, 0.9999}) {
          Vec3 moved = p;
          moved[c] += way * double(outlook.clearance);
          if (outlook.clearance > 0.0F) CHECK_FALSE(hull.outlook(moved).may_be_inside);
        }
      }
      near += !outlook.may_be_inside;
      seen_near += outlook.clearance > 0.0F;
      const bool in_region =
          (p.array() > region.lower.array()).all() && (p.array() < region.upper.array()).all();
      if (!in_region || hull.closest(p).signed_distance < 6.0 * cell) continue;
      ++far;
      seen_far += outlook.clearance > 0.0F;
    }
    CHECK(far > 100);
    CHECK(seen_near > 0.9 * near);  // beside the surface too
    CHECK(seen_far > 0.99 * far);   // not just beyond the end of the grid
  }
}

TEST_CASE("Hull distance: the grid stays within its bound") {
  for (const int quads : {100, 20000}) {
    const QuadMesh mesh = shapes::hull(6.0, 0.92, 0.54, quads);
    const HullDistance hull(mesh, bounding_box(mesh));
    CHECK(hull.grid().cells() <= CellGrid::most_cells);
    CHECK(hull.grid().cells() >= CellGrid::most_cells / 5);
    CHECK(hull.bytes() < 50'000'000 + 500u * mesh.quads.size());
  }
  const QuadMesh mesh = shapes::hull(6.0, 0.92, 0.54, 100);
  const HullDistance apart(mesh, {{20, 0, 0}, {21, 1, 1}});  // a region the hull does not reach
  CHECK_FALSE(apart.outlook({-2, 0, 0}).may_be_inside);
  CHECK_FALSE(apart.outlook({20.5, 0.5, 0.5}).may_be_inside);
  CHECK(apart.closest({-2, 0, 0}).signed_distance < 0.0);
}

TEST_CASE("Hull distance: a surface that is not closed is refused") {
  QuadMesh open = shapes::box({0, 0, 0}, {1, 1, 1}, {2, 2, 2});
  open.quads.pop_back();
  CHECK_THROWS_AS(HullDistance(open, bounding_box(open)), InputError);
  CHECK_THROWS_WITH(TriangleSurface(open), Catch::Contains("not closed") && Catch::Contains("4 of"));
  QuadMesh flipped = shapes::box({0, 0, 0}, {1, 1, 1}, {1, 1, 1});
  std::swap(flipped.quads[0][1], flipped.quads[0][3]);
  CHECK_THROWS_AS(TriangleSurface(flipped), InputError);
}
