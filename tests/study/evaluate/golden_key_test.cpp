// Keys that stored results are found by. The golden file was written by the program of result version 7, that
// of the formula alone since its key holds what the formula reads; a key may change only where the case means
// something else, and then every stored result of it is lost.
#include <catch2/catch.hpp>
#include <fstream>
#include <functional>
#include <memory>
#include <utility>
#include <vector>

#include "base/sha256.h"
#include "study/evaluate/evaluation_key.h"

using namespace icebow;

namespace {

// Every number is written here, none comes from a default: another default must not look like another key.
Case plain_case() {
  Case c;
  c.lambda = 25.0;
  c.bow.family = BowFamily::straight_parallel_buttocks;
  c.bow.angles = {0.425, 0.384, 0.489, 0.576};
  c.bow.L = 147.2;
  c.bow.B = 23.0;
  c.bow.T = 8.0;
  c.bow.D = 13.5;
  c.bow.Lf = 32.5;
  c.bow.panel = 0.0;
  c.bow.belt_below = 1.5;
  c.bow.belt_above = 1.0;
  c.ice = {1.0, 826.6, 1.3e9, 0.25, 0.0, 1.0e5, 0.0, 0.0};
  c.flexural_strength = 875e3;
  c.water = {1000.0, true, WaterInertia::layer, 0.0, 0.0};
  c.sheet = {118.0, 80.5, FixedEdges::sides, 0.0, 0.0, false};
  c.numerics.dx = 1.0 / 3.0;
  c.numerics.horizon_ratio = 3.0;
  c.numerics.dt = 0.0;
  c.numerics.dt_fraction = 0.8;
  c.numerics.linear_below = 1e-3;
  c.numerics.surface_correction = true;
  c.numerics.precision = Precision::fp32;
  c.numerics.contact = ContactRule::relocation;
  c.numerics.floe_contact = false;
  c.numerics.friction = 0.05;
  c.V = 2.0578;
  c.advance = 63.25;
  c.steady_from = 12.65;
  c.pictures = 3;
  return c;
}

void have_own_hull(Case& c) {
  c.own.file = "hull.obj";
  c.own.sha256 = sha256("a hull");
  c.own.frame.unit = 1e-3;
  c.own.frame.waterline = 7.5;
  c.own.mirror = true;
  auto imported = std::make_shared<ImportedHull>();
  imported->measured.angles = c.bow.angles;
  c.own.imported = imported;
}

struct GoldenCase {
  const char* name;
  std::function<void(Case&)> change;
  Evaluators asked = {};
};

const std::vector<GoldenCase> golden_cases = {
    {"plain", [](Case&) {}},
    {"formula alone", [](Case&) {}, {true, false}},
    {"simulation alone", [](Case&) {}, {false, true}},
    {"full scale", [](Case& c) { c.lambda = 1.0; }},
    {"another stem", [](Case& c) { c.bow.angles.stem = 0.35; }},
    {"reamers",
     [](Case& c) {
       c.bow.family = BowFamily::spoon_reamers;
       c.bow.reamer_step = 0.575;
     }},
    {"chines",
     [](Case& c) {
       c.bow.family = BowFamily::semi_spoon_chines;
       c.bow.chine = 0.7;
     }},
    {"own hull", have_own_hull},
    {"own hull of another stem",
     [](Case& c) {
       have_own_hull(c);
       c.bow.angles.stem = 0.35;
     }},
    {"ice of a critical stretch",
     [](Case& c) {
       c.ice.K_I = 0.0;
       c.ice.s0 = 1e-3;
     }},
    {"calibrated and crushed",
     [](Case& c) {
       c.ice_model = IceModel::calibrated;
       c.ice.K_I = 0.0;
       c.ice.crushing_pressure = 2.6e6;
       c.numerics.contact = ContactRule::crushing;
     }},
    {"a half model of seed 7",
     [](Case& c) {
       c.sheet.half_model = true;
       c.seed = 7;
     }},
    {"a window", [](Case& c) { c.sheet.window_ahead = 46.0; }},
    {"no water", [](Case& c) { c.water.buoyancy_and_gravity = false; }},
    {"a layer of water", [](Case& c) { c.water.added_mass = 2.0; }},
    {"water as a plane, with drag",
     [](Case& c) {
       c.water.inertia = WaterInertia::plane;
       c.water.drag = 1.1;
     }},
    {"absorbing edges all round",
     [](Case& c) {
       c.sheet.absorbing = 5.0;
       c.sheet.fixed = FixedEdges::sides_and_far;
     }},
    {"floes that touch, in fp64",
     [](Case& c) {
       c.numerics.floe_contact = true;
       c.numerics.precision = Precision::fp64;
     }},
    {"the paper's contact, a given step, a run that ends itself",
     [](Case& c) {
       c.numerics.contact = ContactRule::paper;
       c.numerics.dt = 1e-4;
       c.stop_when_ci95_below = 0.1;
     }},
    {"files of another format",
     [](Case& c) {
       c.snapshots = 4;
       c.snapshot_format = SnapshotFormat::vtkhdf;
     }},
};

std::string key_at_version_7(const GoldenCase& golden) {
  Case c = plain_case();
  golden.change(c);
  const std::string text = evaluation_text(c, golden.asked);
  CHECK(evaluation_key(c, golden.asked) == sha256(text));
  return sha256("icebow.result_version=7" + text.substr(text.find('\n')));
}

}  // namespace

TEST_CASE("twenty keys are those of the golden file") {
  std::ifstream file(GOLDEN_KEYS);
  const Json golden = Json::parse(file);
  REQUIRE(golden.size() == golden_cases.size());
  for (const GoldenCase& one : golden_cases) {
    INFO(one.name);
    CHECK(key_at_version_7(one) == golden.at(one.name).get<std::string>());
  }
}
