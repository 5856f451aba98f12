// What contact looks at: nothing that touches is missed.
#include <algorithm>
#include <catch2/catch.hpp>
#include <random>
#include <set>
#include <tuple>

#include "solver/contact/contact.h"
#include "solver/contact/contact_pairs.h"
#include "solver/ice/bond_query.h"
#include "solver/ice/cut.h"
#include "tests/support/ice_block.h"
#include "tests/support/tiny_hull.h"

using namespace icebow;

namespace {

using Found =
    std::tuple<std::size_t, std::size_t, bool>;  // addresses, the lower first where both count; an image

std::set<Found> found_pairs(const IceSheet& sheet, ContactPairs& pairs) {
  pairs.find(sheet);
  std::set<Found> found;
  for (const ContactPairs::Pair& pair : pairs.all()) {
    std::size_t a = pairs.address(pair.first), b = pairs.address(pair.second);
    if (pair.kind == ContactPairs::both && a > b) std::swap(a, b);
    CHECK(found.insert({a, b, pair.kind == ContactPairs::mirrored}).second);  // each once
  }
  return found;
}

// Particle by particle.
std::set<Found> all_pairs(const IceBlock& ice, double within) {
  struct Place {
    BondQuery::Place at;
    std::size_t p;
    Vec3 x;
  };
  std::vector<Place> all;
  const IceSheet& sheet = ice.sheet;
  ice.for_each([&](int i, int j, int k, std::size_t p) {
    all.push_back({{i, j, k},
                   p,
                   Vec3(ice.lattice.x(i) + sheet.u[0][p], ice.lattice.y(j) + sheet.u[1][p],
                        ice.lattice.z(k) + sheet.u[2][p])});
  });
  const BondQuery bonds(sheet);
  std::set<Found> found;
  for (const Place& a : all) {
    for (const Place& b : all) {
      if (a.p < b.p && (b.x - a.x).norm() < within && !bonds.alive(a.at, b.at))
        found.insert({a.p, b.p, false});
      const BondQuery::Place image{b.at[0], -1 - b.at[1], b.at[2]};
      if (sheet.lattice.half && (Vec3(b.x.x(), -b.x.y(), b.x.z()) - a.x).norm() < within &&
          !bonds.alive(a.at, image))
        found.insert({a.p, b.p, true});
    }
  }
  return found;
}

// Two floes of which the second has been pushed over the first, all particles a little out of place.
void raft(IceBlock& ice) {
  cut(ice.sheet, [](int i, int, int, const Offset& o) { return (i < 20) != (i + o.di < 20); });
  std::mt19937 random(3);
  std::uniform_real_distribution<double> some(-0.1, 0.1);
  const double dx = ice.lattice.dx;
  ice.for_each([&](int i, int, int k, std::size_t p) {
    const bool second = i >= 20;
    const Vec3 u = dx * Vec3(some(random) - (second ? 12.3 : 0.0), some(random) + (second ? 0.4 : 0.0),
                             some(random) + (second ? 2.1 : 0.0) + 0.0 * k);
    for (int c = 0; c < 3; ++c) ice.sheet.u[c][p] = u[c];
  });
}

}  // namespace

TEST_CASE("pairs of ice that may touch are those near each other without a bond") {
  for (const bool half : {false, true}) {
    Scenario s = block_scenario(40, 6, 2);
    s.sheet.half_model = half;
    IceBlock ice(s);
    raft(ice);
    if (half) {  // cut along the plane of symmetry too: ice meets its image
      cut(ice.sheet, [](int, int j, int, const Offset& o) { return j < 0 && j + o.dj >= 0; });
    }
    INFO("half model " << half);
    const double within = 1.25 * ice.lattice.dx;
    ContactPairs pairs(Communicator::serial(), within);
    const std::set<Found> found = found_pairs(ice.sheet, pairs), all = all_pairs(ice, within);
    CHECK(found == all);
    CHECK(all.size() > 50);
    const auto images = std::count_if(all.begin(), all.end(), [](const Found& f) { return std::get<2>(f); });
    CHECK((images > 0) == half);
  }
}

// Pairs are looked for anew only where ice has moved or cracked.
TEST_CASE("pairs of ice that moves and breaks are the same whether they were looked for before or not") {
  for (const bool half : {false, true}) {
    Scenario s = block_scenario(64, 6, 2);
    s.sheet.half_model = half;
    IceBlock ice(s);
    raft(ice);
    INFO("half model " << half);
    const double dx = ice.lattice.dx, within = 1.25 * dx;
    ContactPairs pairs(Communicator::serial(), within);
    std::mt19937 random(7);
    std::uniform_real_distribution<double> some(-0.002, 0.002);
    for (int round = 0; round < 24; ++round) {
      INFO("round " << round);
      // One floe passes the other, which lies still but for its ends.
      ice.for_each([&](int i, int, int, std::size_t p) {
        const double part = i < 20 ? 0.0 : i < 48 ? 1.0 : 0.3;
        const Vec3 way = dx * Vec3(0.05 * part + some(random), -0.03 * part, -0.06 * part);
        for (int c = 0; c < 3; ++c) ice.sheet.u[c][p] = ice.sheet.u[c][p] + way[c];
      });
      // A crack at a place where nothing moves, or between two that move.
      if (round % 6 == 3) {
        const int at = 4 + 9 * (round / 6);
        cut(ice.sheet, [&](int i, int, int, const Offset& o) { return (i < at) != (i + o.di < at); });
      }
      REQUIRE(found_pairs(ice.sheet, pairs) == all_pairs(ice, within));
    }
    CHECK(all_pairs(ice, within).size() > 100);
  }
}

namespace {

// Loose ice that drifts at random beside and below a hull which passes.
struct Drifting {
  Drifting()
      : ice(block_scenario(48, 12, 2, 0.02)),
        contact(tiny_hull(), Box{Vec3::Constant(-10.0), Vec3::Constant(10.0)}, settings()),
        impulse(settings().particle_mass, 0.5, 0.02),
        ledger(EnergyModel(block_scenario(48, 12, 2, 0.02), ice.lattice, ice.material, settings().dt)) {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> some(-0.3, 0.3);
    ice.for_each([&](int, int, int, std::size_t p) {
      for (int c = 0; c < 3; ++c) ice.sheet.v[c][p] = some(random);
    });
    drift.dt = settings().dt;
    drift.inverse_dx = 1.0 / ice.lattice.dx;
    drift.V = settings().V;
  }
  static ContactSettings settings() {
    ContactSettings s;
    s.rule = ContactRule::relocation;
    s.V = 0.5;
    s.dt = 2e-4;  // a step's way is small beside the hull's cells, so that most is remembered
    s.particle_mass = 6.6e-3;
    return s;
  }
  int step(int n) {
    ice.sheet.drift(drift);
    const int found =
        contact.apply(ice.sheet, -0.3 + n * drift.dt * drift.V, 0, ice.sheet.layout.columns, impulse, ledger);
    ledger.close_step(ice.sheet);
    return found;
  }
  // What the energy balance and a checkpoint take from the last step: particles near the hull too.
  std::vector<double> record() const { return ledger.record(ice.sheet); }

  IceBlock ice;
  HullContact contact;
  ExactImpulse impulse;
  ContactLedger ledger;
  DriftSettings drift{};
};

}  // namespace

TEST_CASE("the hull finds the same ice whether it looks at all of it or only where some may have come near") {
  Drifting all, near;
  int contacts = 0;
  for (int n = 0; n < 5000; ++n) {
    all.contact.look_again();
    const int found = near.step(n);
    contacts += found;
    if (all.step(n) != found || all.record() != near.record()) FAIL("step " << n);
  }
  CHECK(contacts > 10000);
  CHECK(all.impulse.counts() == near.impulse.counts());
  CHECK(all.ledger.counts().gain == near.ledger.counts().gain);
}
