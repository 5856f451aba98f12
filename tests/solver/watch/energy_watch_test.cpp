// The energy of ice with a ship: the hull's work is all accounted for, and energy from nowhere ends a run.
#include "solver/watch/energy_watch.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <random>
#include <string>

#include "solver/lattice/stability.h"
#include "solver/watch/recorder.h"
#include "solver/watch/runaway.h"
#include "tests/support/main.h"
#include "tests/support/tiny_hull.h"

using namespace icebow;

namespace {

Scenario small_run() {
  return tiny_run(1.0, 0.12);
}

// A ship (its hull starting at hull_x) in ice without the checks of simulate().
struct Sailed {
  Sailed(const Scenario& s, double hull_x, double dt_over_limit)
      : lattice(make_lattice(s)),
        material(make_material(s.ice, s.numerics.dx, s.numerics.horizon_ratio)),
        limit(stable_time_step(make_stencil(lattice.nz, lattice.dx, material.delta), material, lattice.dx,
                               s.ice.rho, true)),
        stepper(test_world(), tiny_hull(), s, lattice, dt_over_limit * limit, hull_x),
        scenario(s) {}

  // Until the record stops the run, or for so many steps.
  std::string run(std::int64_t steps) {
    Recorder recorder(test_world(), stepper, scenario, limit);
    std::string reason;
    while (stepper.steps() < steps && reason.empty()) {
      stepper.step();
      if (stepper.steps() % recorder.steps_per_sample() == 0) recorder.sample(stepper, reason);
    }
    history = recorder.history();
    return reason;
  }
  // The worst balance over the hull's work at the end.
  double worst_balance() const {
    double worst = 0.0;
    for (const HistoryRow& row : history.rows) {
      if (!std::isnan(row.balance_error)) worst = std::max(worst, std::abs(row.balance_error));
    }
    return worst / history.rows.back().hull_work;
  }
  double fastest() const {
    double fastest = 0.0;
    const IceSheet& sheet = stepper.sheet();
    for (std::size_t p = 0; p < sheet.layout.size; ++p)
      fastest = std::max(fastest, double(std::hypot(sheet.v[0][p], sheet.v[1][p], sheet.v[2][p])));
    return test_world().max(fastest);
  }

  Lattice lattice;
  Material material;
  double limit;
  Stepper stepper;
  Scenario scenario;
  History history;
};

constexpr double far_away = -50.0;

}  // namespace

TEST_CASE("the hull's work is what the ice gained and what contact lost, while nothing breaks") {
  for (const ContactRule rule : {ContactRule::relocation, ContactRule::penalty, ContactRule::paper}) {
    Scenario s = small_run();
    s.ice.s0 = 0.049;  // too tough to break so soon
    s.numerics.contact = rule;
    Sailed ship(s, first_touch_x(tiny_hull(), make_lattice(s)), 0.8);
    CHECK(ship.run(1860) == "");
    const HistoryRow& last = ship.history.rows.back();
    REQUIRE(last.broken_bonds == 0);
    CHECK(last.hull_work > 0.5);
    INFO("contact rule " << static_cast<int>(rule) << ": balance error over the hull's work "
                         << ship.worst_balance());
    CHECK(ship.worst_balance() < 5e-4);  // found: 8e-5
  }
}

TEST_CASE("breaking ice is not taken for a blow-up, and its balance closes to the fracture energy's error") {
  Scenario s = small_run();
  Sailed ship(s, first_touch_x(tiny_hull(), make_lattice(s)), 0.8);
  CHECK(ship.run(12000) == "");
  const HistoryRow& last = ship.history.rows.back();
  CHECK(last.broken_bonds > 5000);
  CHECK(last.contact_loss > 0.0);
  INFO("balance error over the hull's work " << ship.worst_balance());
  CHECK(ship.worst_balance() < 0.05);  // found: 0.021
}

TEST_CASE("a time step above the limit is found out long before values overflow") {
  for (const double over : {1.03, 1.1, 1.5}) {
    Scenario s = small_run();
    s.sheet.fixed = FixedEdges::none;
    Sailed ice(s, far_away, over);
    std::mt19937 random(3);
    std::uniform_real_distribution<float> uniform(-0.01f, 0.01f);
    IceSheet& sheet = ice.stepper.sheet();
    for (int jl = 0; jl < sheet.layout.columns; ++jl) {
      for (int k = 0; k < sheet.layout.nz; ++k) {
        for (int l = 0; l < sheet.layout.blocks * icebow::block; ++l) {
          if (!sheet.mobile(jl, l)) continue;
          for (Field& v : sheet.v) v[sheet.layout.row(jl, k) + l] = uniform(random);
        }
      }
    }
    const std::string reason = ice.run(20000);
    INFO(reason);
    CHECK(reason.find("unstable at step " + std::to_string(ice.stepper.steps())) == 0);
    CHECK(reason.find("first at x = ") != std::string::npos);
    CHECK(reason.find("times the stability limit") != std::string::npos);
    CHECK(ice.stepper.steps() < 5000);
    CHECK(ice.fastest() < 1000.0);
  }
}

TEST_CASE("what goes wrong beside the hull is put down to contact, squeezed ice to itself") {
  Scenario s = small_run();
  Sailed ship(s, first_touch_x(tiny_hull(), make_lattice(s)), 0.8);
  ship.run(700);
  IceSheet& sheet = ship.stepper.sheet();
  const std::size_t far = sheet.layout.row(0, 0) + 20;
  CHECK(likely_cause(ship.stepper, far, ship.limit).find("not known") == 0);
  CHECK(likely_cause(ship.stepper, far, 0.5 * ship.stepper.dt()).find("the time step is 2 times") == 0);
  const double at_rest = sheet.u[0][far];
  sheet.u[0][far] = at_rest + 0.1 * s.numerics.dx;
  CHECK(likely_cause(ship.stepper, far, ship.limit).find("the ice there is strained") == 0);
  sheet.u[0][far] = at_rest;

  ship.run(1860);
  bool touched = false;
  const int top = ship.lattice.nz - 1;  // where the sloping stem leans on the edge
  for (int jl = 0; jl < sheet.layout.columns; ++jl) {
    for (int l = 0; l < 10; ++l) {
      const std::size_t p = sheet.layout.row(jl, top) + l;
      const Vec3 reference(ship.lattice.x(sheet.layout.i0 + l), ship.lattice.y(sheet.layout.j0 + jl),
                           ship.lattice.z(top));
      const Vec3 position = reference + Vec3(sheet.u[0][p], sheet.u[1][p], sheet.u[2][p]);
      if (!ship.stepper.ledger().beside_hull(sheet, position, 0.5 * ship.lattice.dx)) continue;
      touched = true;
      CHECK(likely_cause(ship.stepper, p, ship.limit).find("contact") == 0);
    }
  }
  CHECK(test_world().any(touched));
}

TEST_CASE("a floe afloat without a ship is left in peace") {
  Scenario s = small_run();
  s.sheet.fixed = FixedEdges::none;
  Sailed floe(s, far_away, 0.8);
  CHECK(floe.run(6000) == "");
  CHECK(std::abs(floe.history.rows.back().hull_work) == 0.0);
}
