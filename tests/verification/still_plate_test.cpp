// Calibrated ice pressed slowly at a corner, at an edge and inside, against the thin plate: the load at which
// the worst bond reaches its strength, and where. See docs/verification.md.
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdio>

#include "solver/tank/tearing.h"
#include "tests/support/calibrated_ice.h"

using namespace icebow;

namespace {

enum class Where { corner, edge, inside };

struct Rung {
  Where where;
  int layers;
  int width;  // of the pressed patch, over h; at the edge it is 1 h deep, else a square
};

// Loads over strength h^2: at which the first place anywhere, and on the upper face along the normal or the
// diagonal, is at its strength; that place's distance from the edge or the corner, over l.
struct Found {
  double first = 0.0, upper = 0.0, at = 0.0;
};

// Stress along the normal or the diagonal, by distance. It is so flat about its highest that the place is the
// middle of what has 0.98 of that.
struct Line {
  std::vector<std::array<double, 2>> points;

  void add(double at, double stress) { points.push_back({at, stress}); }
  double highest() const {
    double found = 0.0;
    for (const auto& [at, stress] : points) found = std::max(found, stress);
    return found;
  }
  double place() const {
    double from = 1e300, to = 0.0;
    for (const auto& [at, stress] : points) {
      if (stress < 0.98 * highest()) continue;
      from = std::min(from, at);
      to = std::max(to, at);
    }
    return 0.5 * (from + to);
  }
};

constexpr double reach_l = 4.5;  // of the sheet from the corner, edge or middle on, over l

int columns_of(const Rung& r) {
  const TankIce ice;
  return static_cast<int>(std::lround(reach_l * ice.characteristic_length() / ice.h)) * r.layers;
}

// Of whole patches: corners are whole, edges halved by the line y = 0, the inside is quartered in theory and
// halved on the lattice.
Found theory(const Rung& r) {
  const TankIce ice;
  const double end = columns_of(r) * ice.h / r.layers, h = ice.h, b = r.width * h;
  const bool inside = r.where == Where::inside, corner = r.where == Where::corner;
  const std::vector<double> lines = graded_lines(0.25 * h, std::min(b + 12.0 * h, end), end);
  PlateMesh mesh{lines, lines};
  if (!corner) mesh.at_y0 = PlateEdge::mirror;
  if (inside) mesh.at_x0 = PlateEdge::mirror;
  const PlateElements plate(ice.plate(), mesh);
  const double share = corner ? 1.0 : inside ? 0.25 : 0.5;
  const LoadedPatch patch{0.0, corner ? b : inside ? 0.5 * b : h, 0.0, corner ? b : 0.5 * b};
  const Eigen::VectorXd u = plate.settle(share * plate.pressed(patch));
  double worst = 0.0;
  Line line;
  for (int ix = 0; ix < plate.nx(); ++ix) {
    for (int iy = 0; iy < plate.ny(); ++iy) {
      const FaceStress face = plate.upper_face(u, ix, iy);
      worst = std::max({worst, face.largest(), -face.smallest()});
      if (iy == (corner ? ix : 0)) line.add(lines[ix] * (corner ? std::sqrt(2.0) : 1.0), face.largest());
    }
  }
  const double unit = 1.0 / (h * h);
  return {unit / worst, unit / line.highest(), line.place() / ice.characteristic_length()};
}

Scenario sheet(const Rung& r) {
  const int n = columns_of(r);
  Scenario s =
      calibrated_sheet(r.layers, r.where == Where::inside ? 2 * n : n, r.where == Where::corner ? n : 2 * n);
  s.sheet.half_model = r.where != Where::corner;
  return s;
}

void press(StillIce& ice, const Rung& r) {
  const int b = r.width * r.layers, first = r.where == Where::inside ? columns_of(r) - b / 2 : 0;
  const bool corner = r.where == Where::corner;
  const int deep = r.where == Where::edge ? r.layers : b;
  ice.push([&](int i, int j, int) { return i >= first && i < first + deep && (corner ? j < b : 2 * j < b); },
           {0.0, 0.0, -1.0 / ice.ice.lattice.copies()});
  ice.settle(1e-5);
}

Found lattice(const Rung& r) {
  StillIce ice(sheet(r), Surroundings::water);
  press(ice, r);
  const Lattice& l = ice.ice.lattice;
  const double origin = r.where == Where::inside ? 0.5 * l.nx : 0.0;
  const bool corner = r.where == Where::corner;
  double worst = 0.0;
  Line line;
  cut(ice.ice.sheet, [&](int i, int j, int k, const Offset& o) {
    const double d = demand(ice, i, j, k, o);
    worst = std::max(worst, d);
    const int across =
        corner ? 2 * (j - i) + o.dj - o.di : 2 * j + 1 + o.dj;  // of its middle, in half spacings
    if (k != l.nz - 1 || o.dk != 0 || std::abs(across) > 2) return false;
    const double x = i + 0.5 + 0.5 * o.di - origin, y = j + 0.5 + 0.5 * o.dj;
    line.add((corner ? (x + y) / std::sqrt(2.0) : std::abs(x)) * l.dx, d);
    return false;
  });
  const TankIce tank;
  const double unit = 1.0 / tank.unit_load();
  return {unit / worst, unit / line.highest(), line.place() / tank.characteristic_length()};
}

const char* name(Where where) {
  return where == Where::corner ? "corner" : where == Where::edge ? "edge" : "inside";
}

void print(const Rung& r) {
  const Found t = theory(r), f = lattice(r);
  std::printf(
      "%s, %d layers, %d h: first %.3f (%.3f of theory), upper face %.3f (%.3f), at %.2f l (theory %.2f)\n",
      name(r.where), r.layers, r.width, f.first, f.first / t.first, f.upper, f.upper / t.upper, f.at, t.at);
}

}  // namespace

TEST_CASE("calibrated ice pressed slowly: the table", "[.long]") {
  for (const int layers : {2, 3, 4}) {
    for (const int width : {1, 2, 4}) print({Where::corner, layers, width});
    for (const int width : {1, 2, 4, 8}) print({Where::edge, layers, width});
    if (layers < 4) print({Where::inside, layers, 4});
  }
}

TEST_CASE("calibrated ice pressed slowly bears the thin plate's load, and breaks nearly as far away") {
  for (const Rung& r : {Rung{Where::corner, 2, 2}, Rung{Where::edge, 2, 1}, Rung{Where::edge, 2, 8}}) {
    const Found t = theory(r), f = lattice(r);
    INFO(name(r.where) << ", " << r.width << " h: first place " << f.first / t.first << ", upper face "
                       << f.upper / t.upper << ", distance " << f.at / t.at << " of theory's");
    CHECK(f.first ==
          Approx(t.first).epsilon(0.07));  // strength is the beam's at its peak, this a first bond's
    CHECK(f.upper == Approx(t.upper).epsilon(0.10));  // likewise
    CHECK(f.at == Approx(t.at).epsilon(0.16));        // two layers: 11 to 13 % nearer
  }
}
