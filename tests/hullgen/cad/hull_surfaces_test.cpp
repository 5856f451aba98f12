// The hull as B-spline patches against the surface they stand for, without a CAD library.
#include "hullgen/cad/hull_surfaces.h"

#include <catch2/catch.hpp>
#include <cmath>

#include "hullgen/bow/bow_surface.h"
#include "hullgen/bow/family.h"
#include "tests/support/paper_bows.h"

using namespace icebow;

namespace {

// Farthest a patch of the bow lies off the surface (8), along x: its point has some y and z, hence eta, and x
// should be -S(eta, z). Where the surface stands steep over eta, in the fairing, the distance is less than
// that, so the smaller of it and the way along y counts.
double farthest(const BowSurface& bow, const SplineSurface& patch) {
  double worst = 0.0;
  constexpr int n = 67;
  const auto at = [](const std::vector<double>& knots, int k) {
    return knots.front() + (knots.back() - knots.front()) * k / n;
  };
  for (int i = 0; i <= n; ++i)
    for (int j = 0; j <= n; ++j) {
      const Vec3 p = patch.point(at(patch.u_knots, i), at(patch.v_knots, j));
      const double z = std::clamp(p.z(), -bow.T, bow.D - bow.T);
      const double eta = std::clamp(p.y() * bow.half_beam() / bow.half_breadth(z), 0.0, bow.half_beam());
      double off = std::abs(-p.x() - bow.s(eta, z));
      for (double shift : {-1e-5, 1e-5}) {
        const double moved = std::clamp(eta + shift * bow.half_beam(), 0.0, bow.half_beam());
        off = std::min(off, std::hypot(-p.x() - bow.s(moved, z), moved - eta));
      }
      worst = std::max(worst, off);
    }
  return worst;
}

bool same_poles(const SplineCurve& a, const SplineCurve& b, double tolerance) {
  if (a.knots != b.knots || a.poles.size() != b.poles.size()) return false;
  for (std::size_t k = 0; k < a.poles.size(); ++k)
    if ((a.poles[k] - b.poles[k]).norm() > tolerance) return false;
  return true;
}

}  // namespace

TEST_CASE("rounded stem and ice knife are on the patches, and the skeg below the bottom") {
  for (const BowFamily family : all_families()) {
    CAPTURE(family_form(family).key);
    BowParameters bow = preset_bow(family);
    bow.centre.stem_radius = 0.4 / std::cos(bow.angles.waterline);
    bow.centre.knife_height = 0.4 * bow.T;
    bow.centre.skeg_height = 0.8;
    bow.centre.skeg_length = 20.0;
    const BowSurface surface = bow_surface(bow);
    const HullSurfaces hull = hull_surfaces(bow);
    const std::size_t strips =
        family_form(family).chines ? 3 : 2;  // knife and skeg end where the rounding does
    REQUIRE(hull.port.size() == strips + (bow.reamer_step > 0.0 ? 2 + 5 : 1 + 4));
    for (std::size_t k = 0; k < strips; ++k) {
      const double off = farthest(surface, hull.port[k]);
      CAPTURE(k, off);
      CHECK(off < 1e-5 * bow.B);  // circle and square roots are no polynomials
    }
    double lowest = 0.0;
    for (const SplineSurface& patch : hull.port)
      for (const auto& row : patch.poles)
        for (const Vec3& pole : row) lowest = std::min(lowest, pole.z());
    CHECK(lowest == Approx(-bow.T - 0.8));
  }
}

TEST_CASE("a polynomial of degree 4 with a break is its own spline") {
  const auto bent = [](double u, double v) {
    const double kink = std::max(u - 0.4, 0.0);
    return Vec3(u, v, u * u * u * u - 3.0 * u * v * v * v + kink * kink);
  };
  const SplineSurface s = fitted_surface(bent, clamped_knots(0.0, {{0.4, 1, 3}, {2.0, 3, 1}}),
                                         clamped_knots(-1.0, {{1.0, 1, 1}}));
  for (double u : {0.0, 0.1, 0.4, 0.41, 1.3, 2.0})
    for (double v : {-1.0, 0.2, 1.0})
      CHECK((s.point(u, v) - bent(u, v)).norm() < 1e-12);  // a curve of the spline's own kind: rounding
}

TEST_CASE("the patches of every family are the bow's surface, and meet in common curves") {
  for (const BowFamily family : all_families()) {
    CAPTURE(family_form(family).key);
    const BowParameters bow = preset_bow(family);
    const BowSurface surface = bow_surface(bow);
    const HullSurfaces hull = hull_surfaces(bow);
    const std::size_t strips = family_form(family).chines ? 2 : 1;
    REQUIRE(hull.port.size() == strips + (bow.reamer_step > 0.0 ? 2 : 1));
    REQUIRE(hull.flat.size() == 3);
    for (std::size_t k = 0; k < strips; ++k) {
      const double off = farthest(surface, hull.port[k]);
      CAPTURE(off);
      CHECK(off < 1e-6 * bow.B);  // found 2.6e-7: the fairing's superellipse is no polynomial
    }
    for (std::size_t k = 1; k < hull.port.size(); ++k) {
      const SplineCurve shared = k < strips ? hull.port[k].edge_at_u(false) : hull.port[k].edge_at_v(false);
      const SplineCurve& before =
          k <= strips ? hull.port[k - 1].edge_at_u(true) : hull.port[k - 1].edge_at_v(true);
      CHECK(same_poles(before, shared, 1e-9 * bow.B));
    }
    for (const FlatFace& flat : hull.flat) {  // a closed ring
      double gaps = 0.0;
      Vec3 at = flat.ring.back().poles.back(), other = flat.ring.back().poles.front();
      for (const SplineCurve& curve : flat.ring) {
        const Vec3 &a = curve.poles.front(), &b = curve.poles.back();
        const double forward = std::min((a - at).norm(), (a - other).norm());
        const double backward = std::min((b - at).norm(), (b - other).norm());
        gaps = std::max(gaps, std::min(forward, backward));
        at = a;
        other = b;
      }
      CHECK(gaps < 1e-9 * bow.B);  // neighbours share a curve: rounding
    }
  }
}
