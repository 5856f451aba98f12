#include <catch2/catch.hpp>
#include <functional>
#include <set>

#include "base/sha256.h"
#include "study/evaluate/evaluate.h"
#include "tests/support/fake_study.h"

using namespace icebow;

TEST_CASE("SHA-256 of the standard's examples") {
  CHECK(sha256("") == "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
  CHECK(sha256("abc") == "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  CHECK(sha256("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq") ==
        "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1");
  CHECK(sha256(std::string(1000000, 'a')) ==
        "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
}

TEST_CASE("a key hangs on every field, to the last bit") {
  const Case base = fake_study().baseline;
  const auto bit = [](double& value) { value = std::nextafter(value, 1e300); };
  const std::vector<std::function<void(Case&)>> changes = {
      [&](Case& c) { bit(c.lambda); },
      [&](Case& c) { c.bow.family = BowFamily::thyssen_waas; },
      [&](Case& c) { bit(c.bow.angles.stem); },
      [&](Case& c) { bit(c.bow.angles.waterline); },
      [&](Case& c) { bit(c.bow.angles.buttock); },
      [&](Case& c) { bit(c.bow.angles.flare); },
      [&](Case& c) { bit(c.bow.L); },
      [&](Case& c) { bit(c.bow.B); },
      [&](Case& c) { bit(c.bow.T); },
      [&](Case& c) { bit(c.bow.D); },
      [&](Case& c) { bit(c.bow.Lf); },
      [&](Case& c) { bit(c.bow.panel); },
      [&](Case& c) { bit(c.bow.belt_below); },
      [&](Case& c) { bit(c.bow.belt_above); },
      [&](Case& c) { bit(c.bow.reamer_step); },
      [&](Case& c) { bit(c.bow.chine); },
      [&](Case& c) { bit(c.bow.centre.stem_radius); },
      [&](Case& c) { bit(c.bow.centre.knife_height); },
      [&](Case& c) { bit(c.bow.centre.skeg_height); },
      [&](Case& c) { bit(c.ice.h); },
      [&](Case& c) { bit(c.ice.rho); },
      [&](Case& c) { bit(c.ice.E); },
      [&](Case& c) { bit(c.ice.nu); },
      [&](Case& c) { bit(c.ice.s0); },
      [&](Case& c) { bit(c.ice.K_I); },
      [&](Case& c) { c.ice_model = IceModel::calibrated; },
      [&](Case& c) { bit(c.flexural_strength); },
      [&](Case& c) { bit(c.water.rho); },
      [&](Case& c) { c.water.buoyancy_and_gravity ^= true; },
      [&](Case& c) { bit(c.sheet.length); },
      [&](Case& c) { bit(c.sheet.width); },
      [&](Case& c) { c.sheet.fixed = FixedEdges::none; },
      [&](Case& c) { c.sheet.half_model = true; },
      [&](Case& c) { bit(c.numerics.dx); },
      [&](Case& c) { bit(c.numerics.horizon_ratio); },
      [&](Case& c) { bit(c.numerics.dt); },
      [&](Case& c) { bit(c.numerics.dt_fraction); },
      [&](Case& c) { c.numerics.surface_correction ^= true; },
      [&](Case& c) { c.numerics.contact = ContactRule::penalty; },
      [&](Case& c) { bit(c.numerics.friction); },
      [&](Case& c) { c.seed = 1; },
      [&](Case& c) { bit(c.V); },
      [&](Case& c) { bit(c.advance); },
      [&](Case& c) { bit(c.steady_from); },
      [&](Case& c) { bit(c.stop_when_ci95_below); },
      [&](Case& c) { ++c.snapshots; },
      [&](Case& c) { ++c.pictures; },
      [&](Case& c) { c.snapshot_format = SnapshotFormat::vtkhdf; }};
  std::set<std::string> keys = {evaluation_key(base, {true, true}), evaluation_key(base, {false, true}),
                                evaluation_key(base, {true, false})};
  for (const auto& change : changes) {
    Case c = base;
    change(c);
    keys.insert(evaluation_key(c, {true, true}));
  }
  CHECK(keys.size() == changes.size() + 3);
}

TEST_CASE("a key is of the ship, not of how it is written") {
  const auto key = [](const char* patch) { return evaluation_key(fake_study(patch).baseline, {true, true}); };
  CHECK(key("{}") == key(R"({"name": "other", "bow": {"stem_deg": 25.0}})"));
  CHECK(key("{}") ==
        key(R"({"method": {"type": "grid", "variables": {"/bow/stem_deg": {"values": [20, 30]}}}})"));
}

TEST_CASE("evaluators of a document: both unless it says") {
  CHECK(evaluators_of(fake_document()).lindqvist);
  CHECK(evaluators_of(fake_document()).peridynamics);
  CHECK_FALSE(evaluators_of(fake_document(R"({"evaluators": ["lindqvist"]})")).peridynamics);
}

TEST_CASE("a design is read once, and its mistake is its own") {
  const Design good = read_design("one", fake_document());
  REQUIRE(good.given.has_value());
  CHECK(good.mistake.empty());
  CHECK(evaluation_key(*good.given, good.asked) == evaluation_key(fake_study().baseline, {true, true}));
  const Design sunk = read_design("two", fake_document(R"({"bow": {"draft_m": 20}})"));
  CHECK_FALSE(sunk.given.has_value());
  CHECK(sunk.mistake.find("/bow/draft") != std::string::npos);
  const Design there = design_from_json(Json::parse(to_json(good).dump()));
  CHECK(evaluation_key(there.given.value(), there.asked) == evaluation_key(*good.given, good.asked));
}

TEST_CASE("a key holds only what its evaluators read") {
  const Case base = fake_study().baseline;
  const Evaluators formula{true, false, false}, cycle{true, false, true}, both{true, true, false};
  const std::vector<std::function<void(Case&)>> of_the_simulation = {
      [](Case& c) { c.seed = 7; },           [](Case& c) { c.numerics.dx *= 2.0; },
      [](Case& c) { c.sheet.width *= 2.0; }, [](Case& c) { c.advance *= 2.0; },
      [](Case& c) { c.pictures = 9; },       [](Case& c) { c.lambda = 10.0; },
      [](Case& c) { c.water.drag = 1.0; },   [](Case& c) { c.ice.K_I *= 2.0; }};
  for (const auto& change : of_the_simulation) {
    Case c = base;
    change(c);
    CHECK(evaluation_key(c, formula) == evaluation_key(base, formula));
    CHECK(evaluation_key(c, cycle) == evaluation_key(base, cycle));
    CHECK(evaluation_key(c, both) != evaluation_key(base, both));
    c.cycle.rule.type = cycle::Breaking::calibrated;  // by patch tests of the lattice
    Case calibrated = base;
    calibrated.cycle.rule.type = cycle::Breaking::calibrated;
    CHECK(evaluation_key(c, cycle) != evaluation_key(calibrated, cycle));
  }
  // Everything of lindqvist_inputs().
  const std::vector<std::function<void(Case&)>> of_the_formula = {[](Case& c) { c.bow.L *= 1.1; },
                                                                  [](Case& c) { c.bow.B *= 1.1; },
                                                                  [](Case& c) { c.bow.T *= 1.1; },
                                                                  [](Case& c) { c.bow.angles.stem *= 1.1; },
                                                                  [](Case& c) { c.bow.angles.flare *= 1.1; },
                                                                  [](Case& c) { c.ice.h *= 1.1; },
                                                                  [](Case& c) { c.V *= 1.1; },
                                                                  [](Case& c) { c.flexural_strength *= 1.1; },
                                                                  [](Case& c) { c.ice.E *= 1.1; },
                                                                  [](Case& c) { c.ice.nu *= 1.1; },
                                                                  [](Case& c) { c.numerics.friction *= 1.1; },
                                                                  [](Case& c) { c.water.rho *= 1.1; },
                                                                  [](Case& c) { c.ice.rho *= 1.1; }};
  for (const auto& change : of_the_formula) {
    Case c = base;
    change(c);
    CHECK(evaluation_key(c, formula) != evaluation_key(base, formula));
  }
}
