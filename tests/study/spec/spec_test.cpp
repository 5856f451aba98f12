// What a study file says of the ship, the ice and the run.
#include <catch2/catch.hpp>
#include <cmath>

#include "base/units.h"
#include "hullgen/bow/family.h"
#include "study/evaluate/evaluator_inputs.h"
#include "study/plan/model_notes.h"
#include "study/spec/spec_case.h"
#include "study/spec/study_spec.h"
#include "tests/support/study_documents.h"

using namespace icebow;

TEST_CASE("a minimal study has documented defaults in SI, radians, full scale") {
  const StudySpec spec = read_study(minimal(), "dir/small.json");
  const Case& c = spec.baseline;
  CHECK(spec.name == "small");
  CHECK(c.lambda == 25);
  check_ulps(c.bow.angles.stem, 24.35 * pi / 180);
  check_ulps(c.V, 4.0 * 1852 / 3600);
  CHECK(c.ice.E == 1.3e9);
  CHECK(c.ice_model == IceModel::calibrated);
  CHECK(c.numerics.floe_contact);
  CHECK(c.numerics.floe_friction == 0.3);
  CHECK(c.water.added_mass == 4.0 * c.ice.h);
  CHECK(c.water.drag == 1.2);
  CHECK(c.ice.s0 == 0);
  CHECK(c.numerics.friction == 0.1);
  CHECK(c.water.rho == 1025);
  CHECK(c.water.buoyancy_and_gravity);
  CHECK(c.advance == Approx(32.5 + 2.2 * 23));
  CHECK(c.steady_from == Approx(32.5));
  CHECK(c.sheet.width == Approx(3.5 * 23));
  CHECK(c.sheet.length == Approx(2.2 * 23 + 2 * 32.5 + 23));
  CHECK(c.sheet.half_model);
  CHECK(c.numerics.dx == Approx(1.0 / 3));
  CHECK(c.numerics.dt == 0);
  CHECK(c.bow.belt_below == 1.5);
  CHECK(spec.rank_by == "mean_load");
  CHECK(spec.method.type == MethodType::list);
  CHECK(spec.include_baseline);
}

TEST_CASE("a load counted while the bow enters the ice is told") {
  Case c;
  c.bow.Lf = 38.0;
  c.steady_from = 8.0;
  const std::vector<std::string> notes = model_notes(c);
  REQUIRE(notes.size() == 1);
  CHECK_THAT(notes[0],
             Catch::StartsWith("operation.steady_from_m is 8 m") && Catch::Contains("from 38 m on"));
  CHECK(model_notes(c, true).empty());  // compared over the same way
  c.steady_from = 38.0;
  CHECK(model_notes(c).empty());
}

TEST_CASE("the shipped study of every family is its preset") {
  for (const BowFamily family : all_families()) {
    const std::string file = std::string(STUDIES) + "/families/" + family_form(family).key + ".json";
    const BowParameters bow = read_study(file).baseline.bow, preset = preset_bow(family);
    CAPTURE(file);
    CHECK(bow.family == family);
    check_ulps(bow.angles.stem, preset.angles.stem);
    check_ulps(bow.angles.waterline, preset.angles.waterline);
    check_ulps(bow.angles.buttock, preset.angles.buttock);
    check_ulps(bow.angles.flare, preset.angles.flare);
    CHECK(bow.L == preset.L);
    CHECK(bow.B == preset.B);
    CHECK(bow.T == preset.T);
    CHECK(bow.D == preset.D);
    CHECK(bow.Lf == preset.Lf);
    check_ulps(bow.reamer_step, preset.reamer_step);
    CHECK(bow.chine == preset.chine);
  }
}

TEST_CASE("reamers and chines have defaults, and belong to their families") {
  const auto bow = [](const std::string& patch) {
    return read_case(with(R"({"bow": )" + patch + "}"), "t.json").bow;
  };
  CHECK(bow(R"({"family": "spoon_reamers"})").reamer_step == Approx(0.03 * 23));
  CHECK(bow(R"({"family": "spoon_reamers", "reamer_step_cm": 50})").reamer_step == Approx(0.5));
  CHECK(bow(R"({"family": "semi_spoon_chines"})").chine == 0.8);
  CHECK(bow(R"({"family": "flat"})").reamer_step == 0.0);
  const Mistake m = only_mistake(with(R"({"bow": {"family": "flat", "reamer_step_m": 0.5}})"));
  CHECK(m.pointer == "/bow/reamer_step_m");
  CHECK(m.message.find("choose spoon_reamers") != std::string::npos);
  CHECK(only_mistake(with(R"({"bow": {"family": "spoon", "reamer_step_m": 0.5}})")).pointer == "/bow/family");
}

TEST_CASE("the formula's beam is that of the channel, reamers included") {
  const Case c = read_case(with(R"({"bow": {"family": "spoon_reamers", "reamer_step_m": 0.5}})"), "t.json");
  CHECK(lindqvist_inputs(c).B == Approx(24.0));
  CHECK(only_mistake(
            with(R"({"bow": {"family": "spoon_reamers", "reamer_step_m": 1}, "sheet": {"width_m": 24}})"))
            .pointer == "/sheet/width_m");
}

TEST_CASE("the published ice is asked for by name, and is alone with its water and its pieces") {
  const Case c = read_case(with(R"({"ice": {"model": "paper"}})"), "t.json");
  CHECK(c.ice_model == IceModel::paper);
  CHECK(c.ice.K_I == 7.5e6);
  CHECK_FALSE(c.numerics.floe_contact);
  CHECK_FALSE(c.sheet.half_model);
  CHECK(c.water.added_mass == 0.0);
  CHECK(c.water.drag == 0.0);
  const Mistake toughness = only_mistake(with(R"({"ice": {"fracture_toughness_MPa_sqrt_m": 7.5}})"));
  CHECK(toughness.pointer == "/ice/fracture_toughness_MPa_sqrt_m");
  CHECK(toughness.message.find("\"model\": \"paper\"") != std::string::npos);
}

TEST_CASE("calibrated ice without water under it has no added mass") {
  const Case c = read_case(with(R"({"water": {"buoyancy_and_gravity": false}})"), "t.json");
  CHECK(c.water.added_mass == 0.0);
  CHECK(c.water.drag == 0.0);
}

TEST_CASE("angles given at B/4: the flare is derived, the entrance is the same unless given") {
  const auto angles = [](const std::string& more) {
    return read_case(with(R"({"bow": {"angles_at": "quarter_beam", "waterline_deg": 20, "flare_deg": null)" +
                          more + "}}"),
                     "t.json")
        .bow.angles;
  };
  const BowAngles straight = angles(""), curved = angles(R"(, "entrance_deg": 24)");
  CHECK(degrees(straight.waterline) == Approx(20));
  CHECK(degrees(curved.waterline) == Approx(24));
  CHECK(curved.flare == straight.flare);
  CHECK(std::tan(straight.flare) * std::tan(straight.buttock) == Approx(std::tan(20 * pi / 180)));
  CHECK(only_mistake(with(R"({"bow": {"flare_deg": null}})")).pointer == "/bow/flare_deg");
  CHECK(only_mistake(with(R"({"bow": {"angles_at": "quarter_beam"}})")).pointer == "/bow/flare_deg");
  CHECK(only_mistake(with(R"({"bow": {"entrance_deg": 24}})")).pointer == "/bow/entrance_deg");
}

TEST_CASE("values given at model scale come back to the solver as they were given") {
  const Case c = read_case(
      with(R"({"ice": {"model": "paper", "scale": "model", "thickness_m": 0.04, "elastic_modulus_MPa": 52,
      "fracture_toughness_kPa_sqrt_m": 60, "friction": 0.07, "density_kg_m3": 826.6},
    "sheet": {"scale": "model", "length_m": 6.5, "width_m": 3.25, "half_model": true},
    "operation": {"scale": "model", "speed_kn": null, "speed_m_s": 0.4116, "advance_m": 2.5, "steady_from_m": 0.5},
    "solver": {"scale": "model", "spacing_m": 0.013, "time_step_s": 2e-5}})"),
      "t.json");
  check_ulps(c.ice.E, 1.3e9);
  check_ulps(c.ice.K_I, 7.5e6);
  check_ulps(c.V, 2.058);
  check_ulps(c.numerics.dt, 1e-4);
  const Scenario s = model_scenario(c);
  check_ulps(s.ice.h, 0.04);
  check_ulps(s.ice.E, 52e6);
  check_ulps(s.ice.K_I, 60e3);
  CHECK(s.ice.rho == 826.6);
  check_ulps(s.sheet.length, 6.5);
  check_ulps(s.sheet.width, 3.25);
  CHECK(s.sheet.half_model);
  check_ulps(s.V, 0.4116);
  check_ulps(s.advance, 2.5);
  check_ulps(s.steady_from, 0.5);
  check_ulps(s.numerics.dx, 0.013);
  check_ulps(s.numerics.dt, 2e-5);
  CHECK(s.numerics.friction == 0.07);
}

TEST_CASE("the round trip holds at an awkward scale") {
  Json document =
      with(R"({"scale": 17.3, "solver": {"scale": "model", "spacing_m": 0.02, "time_step_s": 3e-5},
    "ice": {"model": "paper", "scale": "model", "thickness_m": 0.06, "fracture_toughness_Pa_sqrt_m": 61234.5}})");
  const Scenario s = model_scenario(read_case(document, "t.json"));
  check_ulps(s.numerics.dx, 0.02);
  check_ulps(s.numerics.dt, 3e-5);
  check_ulps(s.ice.K_I, 61234.5);
}

TEST_CASE("every unit of a quantity reads as the same value") {
  const auto thickness = [](const char* patch) { return read_case(with(patch), "t").ice.h; };
  check_ulps(thickness(R"({"ice": {"thickness_m": null, "thickness_cm": 80}})"), 0.8);
  check_ulps(thickness(R"({"ice": {"thickness_m": null, "thickness_mm": 800}})"), 0.8);
  const Case c =
      read_case(with(R"({"bow": {"stem_deg": null, "stem_rad": 0.5}, "ice": {"flexural_strength_MPa": 0.6},
    "operation": {"speed_kn": null, "speed_m_s": 2.5}})"),
                "t");
  CHECK(c.bow.angles.stem == 0.5);
  check_ulps(c.flexural_strength, 6e5);
  CHECK(c.V == 2.5);
}

TEST_CASE("the formula gets full-scale values") {
  const LindqvistInputs in = lindqvist_inputs(read_case(minimal(), "t"));
  CHECK(in.L == 147.2);
  CHECK(in.h == 1.0);
  CHECK(in.mu == 0.1);
  CHECK(in.rho_i == 900);
  CHECK(in.sigma_f == 5e5);
  CHECK(in.waterline == Approx(radians(22)));
}

TEST_CASE("only the formula: ranked by it unless said otherwise") {
  CHECK(read_study(with(R"({"evaluators": ["lindqvist"]})"), "t").rank_by == "lindqvist_breaking");
}
