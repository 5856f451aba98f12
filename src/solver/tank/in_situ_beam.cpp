#include <algorithm>
#include <cmath>

#include "solver/tank/cantilever.h"
#include "solver/tank/specimen.h"
#include "solver/tank/virtual_tests.h"

namespace icebow {
namespace {

// The port half of the sheet with the beam in it; lengths in particles.
struct Place {
  Place(int layers, const SheetAround& around)
      : root(around.behind * layers),
        last(root + beam_length * layers - 1),
        half_width(beam_width * layers / 2),
        nx(last + 1 + around.ahead * layers),
        ny(half_width + around.beside * layers),
        held(around.edges == SheetEdges::held) {}

  const int root, last, half_width, nx, ny;
  const bool held;

  bool tip(int i, int j) const { return i == last && j < half_width; }
  bool edge(int i, int j) const { return held && (i < reach || j >= ny - reach); }
  // Whether the cuts take the bond away: along both sides of the beam from the root on, and across its tip.
  // The root's corners belong to them. j < 0: the starboard half.
  bool severed(int i, int j, const Offset& o) const {
    return crosses_side(i, j - half_width + 0.5, o) || crosses_side(i, j + half_width + 0.5, o) ||
           crosses_tip(i, j + 0.5, o);
  }

 private:
  static constexpr double rounding = 1e-9;

  // y: of the bond's lower end, from the cut.
  bool crosses_side(int i, double y, const Offset& o) const {
    if ((y < 0.0) == (y + o.dj < 0.0)) return false;
    const double x = i - o.di * y / o.dj;
    return x > root - 0.5 - rounding && x < last + 0.5 + rounding;
  }
  bool crosses_tip(int i, double y, const Offset& o) const {
    if ((i <= last) == (i + o.di <= last)) return false;
    return std::abs(y + o.dj * (last + 0.5 - i) / o.di) < half_width + rounding;
  }
};

Scenario sheet_of(const Scenario& scenario, const Place& place, int layers) {
  Scenario s = specimen(scenario, place.nx, 2 * place.ny, layers);
  s.sheet.half_model = true;
  s.numerics.linear_below = scenario.numerics.linear_below;  // most of the sheet is far from the cuts
  return s;
}

class InSituBeam {
 public:
  InSituBeam(const Scenario& scenario, const SheetAround& around, Push push)
      : layers_(tested_layers(scenario)),
        place_(layers_, around),
        s_(sheet_of(scenario, place_, layers_)),
        deflection_((push == Push::up ? 1.0 : -1.0) * s_.numerics.dx),
        ice_(s_, Surroundings::water) {
    cut(ice_.ice.sheet, [&](int i, int j, int, const Offset& o) { return place_.severed(i, j, o); });
    ice_.hold([&](int i, int j, int) { return place_.edge(i, j); });
    ice_.hold_along(tip(), 2, deflection_);
  }

  BeamTest break_off() {
    // What the tip's grip tears off is not the beam's strength.
    const auto away_from_tip = [&](int i, int, int, const Offset& o) {
      return std::max(i, i + o.di) < place_.last - 2;
    };
    return measured(tear_until_it_fails(ice_, away_from_tip, [&] { return force(); }));
  }
  double modulus() {  // without breaking it
    ice_.settle(1e-6);
    return measured({force(), 0.0, 0}).elastic_modulus;
  }

 private:
  StillIce::Where tip() const {
    return [this](int i, int j, int) { return place_.tip(i, j); };
  }
  // Along the deflection; both halves'.
  double force() { return std::copysign(2.0, deflection_) * ice_.support(tip()).z(); }
  BeamTest measured(const Failure& failure) const {
    const double dx = s_.numerics.dx;
    const Cantilever beam{(beam_length * layers_ - 0.5) * dx, 2 * place_.half_width * dx, s_.ice.h,
                          s_.ice.nu};
    return beam_test(beam, failure.first / dx, failure);
  }

  const int layers_;
  const Place place_;
  const Scenario s_;
  const double deflection_;
  StillIce ice_;
};

}  // namespace

BeamTest virtual_in_situ_test(const Scenario& scenario, Push push, const SheetAround& around) {
  return InSituBeam(scenario, around, push).break_off();
}

double in_situ_modulus(const Scenario& scenario, const SheetAround& around) {
  return InSituBeam(scenario, around, Push::up).modulus();
}

}  // namespace icebow
