#include "hullgen/hydro/hydrostatics.h"

#include <catch2/catch.hpp>
#include <cmath>

#include "base/errors.h"
#include "base/units.h"
#include "geometry/mesh_slice.h"
#include "geometry/triangles.h"
#include "hullgen/bow/bow_mesh.h"
#include "hullgen/bow/family.h"

using namespace icebow;

namespace {

constexpr double rho = 1025.0;
constexpr double rounding = 1e-12;  // m: of double, of boxes some ten metres long

// A prism along x from -L to 0: its section, counter-clockwise seen from ahead, at both ends.
QuadMesh prism(double L, const std::vector<Vec3>& section) {
  QuadMesh mesh;
  const int n = static_cast<int>(section.size());
  for (double x : {-L, 0.0})
    for (const Vec3& p : section) mesh.points.push_back(Vec3(x, p.y(), p.z()));
  for (int k = 0; k < n; ++k) mesh.quads.push_back({k, (k + 1) % n, n + (k + 1) % n, n + k});
  for (int k = 1; k + 1 < n; ++k) {
    mesh.quads.push_back({n, n + k, n + k + 1, n + k + 1});
    mesh.quads.push_back({0, k + 1, k, k});
  }
  mesh.patch.assign(mesh.quads.size(), Patch::other);
  return mesh;
}

// Keel at z = 0.
QuadMesh box(double L, double B, double D) {
  return prism(L, {{0, -B / 2, 0}, {0, B / 2, 0}, {0, B / 2, D}, {0, -B / 2, D}});
}

QuadMesh ellipsoid(const Vec3& radii, int n) {
  QuadMesh mesh;
  const auto point = [&](int i, int j) -> Vec3 {  // row i of 2 n from the lowest point up, column j of 4 n
    const double a = pi * i / (2 * n) - pi / 2, b = 2 * pi * j / (4 * n);
    return Vec3(std::cos(a) * std::cos(b), std::cos(a) * std::sin(b), std::sin(a)).cwiseProduct(radii);
  };
  const auto id = [&](int i, int j) {
    return i == 0 ? 0 : i == 2 * n ? 1 : 2 + (i - 1) * 4 * n + j % (4 * n);
  };
  mesh.points = {Vec3(0, 0, -radii.z()), Vec3(0, 0, radii.z())};
  for (int i = 1; i < 2 * n; ++i)
    for (int j = 0; j < 4 * n; ++j) mesh.points.push_back(point(i, j));
  for (int i = 0; i < 2 * n; ++i)
    for (int j = 0; j < 4 * n; ++j) {
      if (i == 0)
        mesh.quads.push_back({0, id(1, j + 1), id(1, j), id(1, j)});
      else
        mesh.quads.push_back({id(i, j), id(i, j + 1), id(i + 1, j + 1), id(i + 1, j)});
    }
  mesh.patch.assign(mesh.quads.size(), Patch::other);
  return mesh;
}

QuadMesh moved(QuadMesh mesh, const Eigen::Affine3d& by) {
  for (Vec3& p : mesh.points) p = by * p;
  return mesh;
}

double loop_area(const Polyline& loop) {
  double twice = 0.0;
  for (std::size_t k = 1; k < loop.size(); ++k) twice += loop[k - 1].cross(loop[k]).z();
  return 0.5 * std::abs(twice);
}

QuadMesh coarse_hull(BowFamily family) {
  BowParameters bow = preset_bow(family);
  bow.panel = bow.B / 20.0;
  return bow_mesh(bow);
}

}  // namespace

TEST_CASE("a box at even keel") {
  const Hydrostatics h = hydrostatics(box(60, 12, 8), {5.0, -30.0, 0.0}, rho);
  CHECK(h.volume == Approx(60 * 12 * 5));
  CHECK(h.displacement == Approx(rho * 60 * 12 * 5));
  CHECK((h.buoyancy - Vec3(-30, 0, 2.5)).norm() == Approx(0.0).margin(rounding));
  CHECK(h.KB == Approx(2.5));
  CHECK(h.waterplane_area == Approx(60 * 12));
  CHECK((h.flotation - Vec3(-30, 0, 5)).norm() == Approx(0.0).margin(rounding));
  CHECK(h.I_T == Approx(60 * std::pow(12, 3) / 12));
  CHECK(h.I_L == Approx(12 * std::pow(60, 3) / 12));
  CHECK(h.wetted_area == Approx(60 * 12 + 2 * 5 * (60 + 12)));
  CHECK(h.length == Approx(60));
  CHECK(h.beam == Approx(12));
  CHECK(h.draft == Approx(5));
  CHECK(h.block_coefficient == Approx(1));
  CHECK(h.waterplane_coefficient == Approx(1));
  CHECK(h.BM_T == Approx(12.0 * 12.0 / (12 * 5)));
  CHECK(h.KM_T == Approx(2.5 + 12.0 * 12.0 / (12 * 5)));
}

TEST_CASE("a box trimmed by the stern") {
  const double L = 60, B = 12, T = 4, trim = radians(3.0), t = std::tan(trim), slant = L / std::cos(trim);
  const Flotation at{T, -L / 2, trim};
  const Hydrostatics h = hydrostatics(box(L, B, 8), at, rho);
  CHECK(h.volume == Approx(L * B * T));
  CHECK(h.buoyancy.x() == Approx(-L / 2 - t * L * L / (12 * T)));
  CHECK(h.buoyancy.y() == Approx(0.0).margin(rounding));
  CHECK(h.KB == Approx(T / 2 + t * t * L * L / (24 * T)));
  CHECK(h.waterplane_area == Approx(slant * B));
  CHECK((h.flotation - Vec3(-L / 2, 0, T)).norm() ==
        Approx(0.0).margin(1e-11));  // rounding, turned by the trim
  CHECK(h.I_T == Approx(slant * B * B * B / 12));
  CHECK(h.I_L == Approx(B * std::pow(slant, 3) / 12));
  CHECK(h.wetted_area == Approx(L * B + 2 * L * T + 2 * B * T));
  CHECK(h.length == Approx(slant));
  CHECK(h.fore_end == Approx(0.0).margin(rounding));
  CHECK(h.aft_end == Approx(-L));
  CHECK(h.block_coefficient == Approx(1));
  CHECK(h.KM_T == Approx(h.KB + h.I_T / h.volume * std::cos(trim)));
  for (const SectionArea& s : sectional_areas(box(L, B, 8), at, 7))
    CHECK(s.area == Approx(B * (T - (s.x + L / 2) * t)));
}

TEST_CASE("a box trimmed until the bow comes out of the water") {
  const double L = 60, B = 12, wet = 40, trim = radians(4.0), t = std::tan(trim);
  const Hydrostatics h = hydrostatics(box(L, B, 8), {wet * t / 2, -L + wet / 2, trim}, rho);
  CHECK(h.volume == Approx(B * wet * wet * t / 2));
  CHECK(h.buoyancy.x() == Approx(-L + wet / 3));
  CHECK(h.KB == Approx(wet * t / 3));
  CHECK(h.waterplane_area == Approx(B * wet / std::cos(trim)));
  CHECK(h.fore_end == Approx(-L + wet));
}

TEST_CASE("wedges: a section like a V, a plan like a bow") {
  const Hydrostatics v = hydrostatics(prism(60, {{0, 0, 0}, {0, 6, 8}, {0, -6, 8}}), {5.0, -30.0, 0.0}, rho);
  const double beam = 12.0 * 5 / 8;
  CHECK(v.beam == Approx(beam));
  CHECK(v.volume == Approx(60 * beam * 5 / 2));
  CHECK(v.KB == Approx(2.0 / 3 * 5));
  CHECK(v.wetted_area == Approx(2 * 60 * std::hypot(5, beam / 2) + beam * 5));
  CHECK(v.block_coefficient == Approx(0.5));

  // Extruded along x, then stood on its end: vertical sides that meet at the stem.
  Eigen::Affine3d upright(Eigen::AngleAxisd(pi / 2, Vec3::UnitY()));
  const QuadMesh bow = moved(prism(8, {{0, 0, 0}, {0, -6, -30}, {0, 6, -30}}), upright);
  const Box b = bounding_box(bow);
  const double fore = b.upper.x(), L = fore - b.lower.x();
  const Hydrostatics w = hydrostatics(bow, {b.lower.z() + 5.0, 0.0, 0.0}, rho);
  CHECK(L == Approx(30));
  CHECK(w.waterplane_area == Approx(L * 12 / 2));
  CHECK(w.waterplane_coefficient == Approx(0.5));
  const double apex = bow.points[0].x();
  CHECK(std::abs(w.buoyancy.x() - apex) == Approx(2.0 / 3 * L));
  CHECK(w.I_L == Approx(12 * L * L * L / 36));
  CHECK(w.I_T == Approx(L * 12 * 12 * 12 / 48));
}

TEST_CASE("an ellipsoid to its middle, converging as the square of the panel size") {
  const Vec3 r(30, 8, 5);
  std::vector<double> errors;
  for (int n : {8, 16, 32}) {
    const Hydrostatics h = hydrostatics(ellipsoid(r, n), {}, rho);
    const double volume = 2.0 / 3 * pi * r.prod(), I_T = pi / 4 * r.x() * std::pow(r.y(), 3);
    const double I_L = pi / 4 * r.y() * std::pow(r.x(), 3);
    double worst = std::abs(h.volume / volume - 1);
    worst = std::max(worst, std::abs(h.KB / (5.0 / 8 * r.z()) - 1));
    worst = std::max(worst, std::abs(h.waterplane_area / (pi * r.x() * r.y()) - 1));
    worst = std::max(worst, std::abs(h.I_T / I_T - 1));
    worst = std::max(worst, std::abs(h.I_L / I_L - 1));
    worst = std::max(worst, std::abs(h.KM_T - (5.0 / 8 * r.z() + I_T / volume)) / r.z());
    errors.push_back(worst);
    CHECK(hydrostatics(ellipsoid(Vec3(7, 7, 7), n), {}, rho).wetted_area / (2 * pi * 49) ==
          Approx(1.0).margin(1.0 / (n * n)));   // second order in the panel size
    CHECK(h.buoyancy.head<2>().norm() < 1e-9);  // symmetric: rounding of metres
  }
  CHECK(errors[2] < 0.005);
  constexpr double next_order = 0.1;  // of second-order errors, with panels of 11 degrees
  CHECK(errors[0] / errors[1] == Approx(4.0).epsilon(next_order));
  CHECK(errors[1] / errors[2] == Approx(4.0).epsilon(next_order));
}

TEST_CASE("every bow: waterplane, sections and what is left dry agree with the volume") {
  for (const BowFamily family : all_families()) {
    INFO(family_form(family).key);
    const QuadMesh mesh = coarse_hull(family);
    const double L = -bounding_box(mesh).lower.x();
    const Flotation at{0.3, -L / 2, radians(0.5)};
    const Hydrostatics h = hydrostatics(mesh, at, rho);
    CHECK(h.buoyancy.y() == Approx(0.0).margin(1e-9));  // rounding of a sum over panels
    CHECK(h.block_coefficient < 1.0);
    CHECK(h.block_coefficient > 0.5);

    double of_sections = 0.0;
    const std::vector<SectionArea> curve = sectional_areas(mesh, at, 401);
    for (std::size_t k = 1; k < curve.size(); ++k)
      of_sections += 0.5 * (curve[k].area + curve[k - 1].area) * (curve[k].x - curve[k - 1].x);
    CHECK(of_sections == Approx(h.volume).epsilon(1e-3));  // trapezoids between 401 sections
    CHECK(curve.front().area > 0.5 * h.beam * h.draft);    // the transom

    const double dz = 1e-4;
    const double more = hydrostatics(mesh, {at.level + dz, at.x_level, at.trim}, rho).volume;
    CHECK((more - h.volume) / dz ==
          Approx(h.waterplane_area * std::cos(at.trim)).epsilon(1e-3));  // a one-sided difference

    // Upside down, the dry part is the wet one.
    Eigen::Affine3d over(Eigen::AngleAxisd(pi, Vec3::UnitX()));
    const Hydrostatics dry = hydrostatics(moved(mesh, over), {-at.level, at.x_level, -at.trim}, rho);
    double six_volumes = 0.0;
    for (const auto& t : triangles(mesh))
      six_volumes += mesh.points[t[0]].dot(mesh.points[t[1]].cross(mesh.points[t[2]]));
    CHECK(dry.volume + h.volume == Approx(six_volumes / 6.0));
  }
}

TEST_CASE("the design waterplane has the area of its outline") {
  for (const BowFamily family : all_families()) {
    const QuadMesh mesh = coarse_hull(family);
    double area = 0.0;
    for (const Polyline& loop : slice(mesh, 2, 0.0)) area += loop_area(loop);
    CHECK(hydrostatics(mesh, {}, rho).waterplane_area == Approx(area).epsilon(1e-9));  // rounding of two sums
  }
}

TEST_CASE("trim is turning the hull: nothing that floats knows the difference") {
  const QuadMesh mesh = coarse_hull(BowFamily::concave);
  const double trim = radians(1.5);
  const Eigen::Affine3d level(Eigen::AngleAxisd(-trim, Vec3::UnitY()));
  const Hydrostatics a = hydrostatics(mesh, {0.2, 0.0, trim}, rho);
  const Hydrostatics b = hydrostatics(moved(mesh, level), {0.2 * std::cos(trim), 0.0, 0.0}, rho);
  CHECK(a.volume == Approx(b.volume));
  CHECK(a.wetted_area == Approx(b.wetted_area));
  CHECK(a.I_T == Approx(b.I_T));
  CHECK(a.I_L == Approx(b.I_L));
  CHECK((level * a.buoyancy - b.buoyancy).norm() < 1e-8);    // rounding of metres, through a turn
  CHECK((level * a.flotation - b.flotation).norm() < 1e-8);  // likewise
}

TEST_CASE("a surface that misses the hull is refused with the range") {
  for (double level : {-1.0, 0.0, 9.0})
    CHECK_THROWS_WITH(hydrostatics(box(60, 12, 8), {level, 0.0, 0.0}, rho),
                      Catch::Contains("does not cut the hull") && Catch::Contains("below 8 m"));
}
