// What a crack costs, against the fracture energy that the critical stretch stands for: see
// docs/verification.md.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "solver/ice/energy.h"
#include "solver/tank/tearing.h"
#include "tests/support/ice_block.h"

using namespace icebow;

namespace {

double fracture_energy(const Material& m) {  // G_c of eq. (8) [J/m^2]
  return (3.0 * m.mu + std::pow(0.75, 4) * (m.kappa - 5.0 * m.mu / 3.0)) * m.delta * m.s0 * m.s0;
}

// Energy (27) of all bonds through the plane x = middle, away from the edges of the sheet [J/m^2].
double cost_of_cut(double nu, int thickness, int thinner, bool corrected) {
  const auto energy = [&](int ny, int nz) {
    if (nz == 0) return 0.0;
    Scenario s = in_double_precision(block_scenario(32, ny, nz));
    s.ice.nu = nu;
    s.numerics.surface_correction = corrected;
    IceBlock b(s);
    const EnergyModel model(s, b.lattice, b.material, 1e-5);
    // A bond's lower end may be on either side.
    cut(b.sheet, [](int i, int, int, const Offset& o) { return (i < 16) != (i + o.di < 16); });
    return sheet_energy(b.sheet, model).fracture * model.quantum;
  };
  const double more =
      energy(28, thickness) - energy(20, thickness) - energy(28, thinner) + energy(20, thinner);
  return more / (8.0 * (thickness - thinner) * 0.013 * 0.013);
}

// Two arms of a sheet, half a sheet's width each, drawn apart by 1 N at their ends.
class DoubleCantilever {
 public:
  DoubleCantilever(int layers, int crack, double nu) : s_(scenario(layers, nu)), ice_(s_) {
    const int first = ny / 2;
    cut(ice_.ice.sheet,
        [&](int i, int j, int, const Offset& o) { return crosses(j, o) && i + 0.5 * o.di < crack - 0.5; });
    ice_.push([&](int i, int j, int) { return i == 0 && j < first; }, {0.0, -1.0, 0.0});
    ice_.push([&](int i, int j, int) { return i == 0 && j >= first; }, {0.0, 1.0, 0.0});
  }
  double settled_work() {
    ice_.settle(1e-4);
    return ice_.work();
  }
  // Where the forces act nothing is to break.
  Tear tear() {
    return icebow::tear(ice_, [](int i, int, int, const Offset& o) { return i >= 3 || i + o.di >= 6; });
  }
  // Area that bonds no longer cross, by their number [m^2].
  double opened() const {
    std::int64_t gone = 0, in_column = 0;
    const IceSheet& sheet = ice_.ice.sheet;
    for (int k = 0; k < sheet.layout.nz; ++k) {
      for (std::size_t slot = 0; slot < sheet.stencil.half[k].size(); ++slot) {
        const Offset& o = sheet.stencil.half[k][slot];
        for (int j = 0; j < ny; ++j) {
          if (!crosses(j, o)) continue;
          ++in_column;
          for (int i = 0; i < nx; ++i) {
            if (i + o.di < 0 || i + o.di >= nx) continue;
            const std::uint16_t* words =
                sheet.bits.row(j, k) + std::ptrdiff_t(i / block) * sheet.bits.per_block();
            gone += !(words[slot] >> i % block & 1);
          }
        }
      }
    }
    return double(gone) / double(in_column) * thickness() * s_.numerics.dx;
  }
  double thickness() const { return s_.ice.h; }
  const Material& material() const { return ice_.ice.material; }

  static constexpr int nx = 64, ny = 24;

 private:
  static Scenario scenario(int layers, double nu) {
    Scenario s = in_double_precision(block_scenario(nx, ny, layers));
    s.ice.nu = nu;
    return s;
  }
  static bool crosses(int j, const Offset& o) { return (j < ny / 2) != (j + o.dj < ny / 2); }

  Scenario s_;
  StillIce ice_;
};

// Work of the ends at 1 N as a function of the crack's length: a beam's, with the cube of the length from
// somewhere behind the tip. Found from two straight cracks.
class WorkOfLength {
 public:
  WorkOfLength(int layers, int from, int to, double nu)
      : from_(from),
        root_(std::cbrt(DoubleCantilever(layers, from, nu).settled_work())),
        slope_((std::cbrt(DoubleCantilever(layers, to, nu).settled_work()) - root_) / (to - from)) {}
  // By a spacing [J].
  double slope(double length) const {
    const double root = root_ + (length - from_) * slope_;
    return 3.0 * root * root * slope_;
  }

 private:
  double from_, root_, slope_;
};

}  // namespace

TEST_CASE("the bonds through a plane cost what the critical stretch was made from") {
  for (double nu : {0.25, 0.33}) {
    const Material m = make_material({1.0, 826.6, 52e6, nu, 0.0052, 0.0}, 0.013, 3.0);
    const double distortion = 3.0 * m.mu * m.delta * m.s0 * m.s0, G_c = fracture_energy(m);
    const double bulk = cost_of_cut(nu, 20, 14, true), bare = cost_of_cut(nu, 20, 14, false);
    INFO("nu " << nu << ": bulk " << bulk / G_c << " of G_c, " << bulk / distortion
               << " of its distortional part; without surface correction " << bare / G_c);
    CHECK(bulk == Approx(distortion).epsilon(0.02));  // a lattice sum for an integral
    CHECK(bare < bulk);
    double thinner = 0.5;  // of G_c: what a thin sheet is short of bonds
    for (int layers = 1; layers <= 5; ++layers) {
      const double ratio = cost_of_cut(nu, layers, 0, true) / G_c;
      INFO("nu " << nu << ", " << layers << " layers: " << ratio << " of G_c");
      CHECK(ratio > thinner);
      CHECK(ratio < bulk / G_c);
      thinner = ratio;
    }
  }
}

TEST_CASE("a pre-cut double cantilever tears at the load whose energy release rate is G_c") {
  const int layers = 3, crack = 28;
  for (double nu : {0.25, 0.33}) {
    const WorkOfLength work(layers, crack, crack + 9, nu);
    DoubleCantilever ice(layers, crack, nu);
    const double G_c = fracture_energy(ice.material()), dx = 0.013, column = ice.thickness() * dx;
    const double before = ice.opened();
    double first = 0.0, highest = 0.0, advance = 0.0, weighted = 0.0, last = 0.5;
    while (advance < 1.5) {
      const Tear next = ice.tear();
      // Work and energy at a fixed load: G = d(work)/da, both at `load` times 1 N.
      const double G = next.load * next.load * work.slope(crack + advance) / column;
      if (first == 0.0) first = G;
      if (advance >= 0.5) highest = std::max(highest, G);  // once the front has its own shape
      advance = (ice.opened() - before) / column;
      if (advance > 0.5) {
        weighted += G * (advance - last);
        last = advance;
      }
    }
    const double mean = weighted / (last - 0.5);
    INFO("nu " << nu << ": first bond at " << first / G_c << " of G_c; over the next spacing mean "
               << mean / G_c << ", highest " << highest / G_c);
    CHECK(first < G_c);
    CHECK(mean == Approx(G_c).epsilon(0.15));  // bonds hold a front at whole spacings
    // Bonds hold the front at whole spacings: more than G_c is wanted to move on.
    CHECK(highest > mean);
    CHECK(highest < 1.35 * G_c);
  }
}
