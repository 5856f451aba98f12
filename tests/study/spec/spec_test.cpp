#include <unistd.h>

#include <catch2/catch.hpp>
#include <cmath>
#include <ctime>
#include <filesystem>

#include "base/errors.h"
#include "base/text_file.h"
#include "base/units.h"
#include "hullgen/bow/family.h"
#include "study/evaluate/evaluator_inputs.h"
#include "study/plan/design_space.h"
#include "study/spec/design_name.h"
#include "study/spec/model_notes.h"
#include "study/spec/read_study.h"
#include "study/spec/spec_case.h"
#include "study/spec/spec_hints.h"
#include "study/spec/spec_keys.h"
#include "study/spec/spec_method.h"
#include "study/spec/study_spec.h"

using namespace icebow;

namespace {

Json minimal() {
  return Json::parse(R"({"icebow_study": 1,
    "bow": {"family": "straight_parallel_buttocks", "length_m": 147.2, "beam_m": 23.0, "draft_m": 8.0, "depth_m": 13.5,
            "bow_length_m": 32.5, "stem_deg": 24.35, "waterline_deg": 22.0, "buttock_deg": 28.0, "flare_deg": 33.0},
    "ice": {"thickness_m": 1.0},
    "operation": {"speed_kn": 4.0}})");
}

Json with(const std::string& patch) {
  Json document = minimal();
  document.merge_patch(Json::parse(patch));
  return document;
}

std::vector<Mistake> mistakes_of(const Json& document) {
  try {
    read_study(document, "t.json");
  } catch (const InputError& e) {
    return e.mistakes();
  }
  return {};
}

Mistake only_mistake(const Json& document) {
  const auto mistakes = mistakes_of(document);
  REQUIRE(mistakes.size() == 1);
  return mistakes[0];
}

// Equal but for the last two places.
void check_ulps(double value, double expected) {
  CHECK(std::abs(value - expected) <= 2.3e-16 * 2 * std::abs(expected));
}

}  // namespace

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

TEST_CASE("every mistake of a file is found at once, by pointer") {
  const auto mistakes = mistakes_of(with(R"({"icebow_study": 3, "scale": "big",
    "bow": {"stem_deg": 95, "beem_m": 23, "beam_m": null, "depth_m": "deep"}, "ice": {"friction": -0.1},
    "operation": {"speed_kn": null}, "solver": {"contact": "papper"}, "evaluators": ["magic"],
    "designs": [{"name": ""}, {"name": "x", "set": {"bow": {"flare_deg": 120}}}],
    "method": {"type": "grid", "variables": {"/bow/stem_deg": {"min": 20, "max": 95, "levels": 0}}},
    "execution": {"ranks_per_design": 0}, "surprise": 1})"));
  std::vector<std::string> pointers;
  for (const Mistake& m : mistakes) pointers.push_back(m.pointer);
  std::sort(pointers.begin(), pointers.end());
  CHECK(pointers == std::vector<std::string>{"/bow/beem_m", "/bow/depth_m", "/bow/stem_deg",
                                             "/designs/0/name", "/designs/1/set/bow/flare_deg",
                                             "/evaluators/0", "/execution/ranks_per_design", "/ice/friction",
                                             "/icebow_study", "/method/variables/~1bow~1stem_deg/levels",
                                             "/method/variables/~1bow~1stem_deg/max", "/operation/speed_m_s",
                                             "/scale", "/solver/contact", "/surprise"});
}

TEST_CASE("a message gives the value, the allowed range with its unit and what to change") {
  CHECK(only_mistake(with(R"({"bow": {"stem_deg": 95}})")).message == "is 95, allowed 5 to 85 deg");
  CHECK(only_mistake(with(R"({"ice": {"thickness_m": null, "thickness_mm": 0.5}})")).message ==
        "is 0.5, allowed 1 to 10000 mm");
  const std::string unknown =
      only_mistake(with(R"({"ice": {"thicknes_m": 1, "thickness_m": null}})")).message;
  CHECK(unknown.find("\"thickness_m\"") != std::string::npos);
  const std::string twice = only_mistake(with(R"({"operation": {"speed_m_s": 2}})")).message;
  CHECK(twice.find("speed_kn") != std::string::npos);
}

TEST_CASE("values that contradict each other are found at the scale of the file") {
  CHECK(only_mistake(with(R"({"sheet": {"scale": "model", "width_m": 0.9}})")).pointer == "/sheet/width_m");
  CHECK(mistakes_of(with(R"({"sheet": {"scale": "model", "width_m": 0.93}})")).empty());
  CHECK(only_mistake(with(R"({"solver": {"spacing_cm": 101}})")).pointer == "/solver/spacing_cm");
  CHECK(mistakes_of(with(R"({"ice": {"model": "paper"}, "solver": {"spacing_cm": 100}})")).empty());
  CHECK(only_mistake(with(R"({"ice": {"friction_between_pieces": 0.2}, "solver": {"floe_contact": false}})"))
            .pointer == "/ice/friction_between_pieces");
  CHECK(only_mistake(with(R"({"operation": {"advance_m": 40, "steady_from_m": 40}})")).pointer ==
        "/operation/steady_from_m");
}

TEST_CASE("a design's patch is read like the file, under its own pointer") {
  const StudySpec spec = read_study(
      with(R"({"designs": [{"name": "fast", "set": {"operation": {"speed_kn": 6}}}, {"name": "same"}]})"),
      "t");
  REQUIRE(spec.designs.size() == 2);
  Json document = spec.document;
  document.merge_patch(spec.designs[0].set);
  check_ulps(read_case(document, "fast").V, 6 * metres_per_second_per_knot);
  CHECK(spec.designs[1].set == Json::object());
  // A mistake of the file itself is not repeated for every design.
  CHECK(mistakes_of(with(R"({"ice": {"friction": 2}, "designs": [{"name": "a"}, {"name": "b"}]})")).size() ==
        1);
}

TEST_CASE("methods are read with their defaults") {
  const Method lhs = read_study(with(R"({"method": {"type": "latin_hypercube", "samples": 8, "seed": 42,
    "variables": {"/bow/stem_deg": {"min": 18, "max": 30}, "/operation/speed_kn": {"min": 2, "max": 5}}}})"),
                                "t")
                         .method;
  CHECK(lhs.type == MethodType::latin_hypercube);
  CHECK(lhs.samples == 8);
  CHECK(lhs.seed == 42);
  REQUIRE(lhs.variables.size() == 2);
  CHECK(lhs.variables[0].pointer == "/bow/stem_deg");
  CHECK(lhs.variables[0].lower == 18);
  CHECK(lhs.variables[1].upper == 5);
  const Method best =
      read_study(
          with(R"({"method": {"type": "optimise", "variables": {"/bow/stem_deg": {"min": 18, "max": 30}}}})"),
          "t")
          .method;
  CHECK(best.algorithm == "cobyla");  // a bow's optimum lies on its margins
  CHECK(best.max_evaluations == 60);
  CHECK(best.tolerance == 0.01);
  const Method grid =
      read_study(
          with(
              R"({"method": {"type": "grid", "variables": {"/bow/stem_deg": {"min": 18, "max": 30, "levels": 4},
    "/ice/thickness_m": {"values": [0.5, 1.0]}}}})"),
          "t")
          .method;
  CHECK(grid.variables[0].levels == 4);
  CHECK(grid.variables[1].values == std::vector<double>{0.5, 1.0});
}

TEST_CASE("an unknown optimiser is answered with the known ones") {
  const std::string message = only_mistake(with(R"({"method": {"type": "optimise", "algorithm": "cobila",
    "variables": {"/bow/stem_deg": {"min": 18, "max": 30}}}})"))
                                  .message;
  for (const Algorithm& a : algorithms()) CHECK(message.find(a.name) != std::string::npos);
  CHECK(message.find("did you mean \"cobyla\"") != std::string::npos);
  CHECK(find_algorithm("cobyla")->takes_constraints);
  CHECK_FALSE(find_algorithm("sbplx")->takes_constraints);
}

TEST_CASE("only the formula: ranked by it unless said otherwise") {
  CHECK(read_study(with(R"({"evaluators": ["lindqvist"]})"), "t").rank_by == "lindqvist_breaking");
}

TEST_CASE("--set changes, creates and is checked by the reader") {
  Json document = minimal();
  apply_set(document, "/bow/stem_deg=20.5");
  apply_set(document, "/solver/contact=paper");
  apply_set(document, "/water/buoyancy_and_gravity=false");
  apply_set(document, "/operation={\"speed_m_s\": 2}");
  const Case c = read_case(document, "t");
  CHECK(c.bow.angles.stem == Approx(radians(20.5)));
  CHECK(c.numerics.contact == ContactRule::paper);
  CHECK_FALSE(c.water.buoyancy_and_gravity);
  CHECK(c.V == 2);
  apply_set(document, "/bow/stemm_deg=20");
  CHECK(only_mistake(document).pointer == "/bow/stemm_deg");
  CHECK_THROWS_AS(apply_set(document, "stem_deg=20"), InputError);
  CHECK_THROWS_AS(apply_set(document, "/bow/stem_deg"), InputError);
  CHECK_THROWS_AS(apply_set(document, "/bow/beam_m/x=20"), InputError);
}

TEST_CASE("the table of keys has no two keys of one spelling") {
  for (const Key& key : study_keys()) {
    for (const Unit& unit : units_of(key.quantity)) {
      CHECK(find_spelling(key.section, key.name + std::string(unit.suffix)).key == &key);
    }
    if (is_numeric(key.quantity) && !std::isnan(key.fallback)) {
      CHECK(key.fallback >= key.lower);
      CHECK(key.fallback <= key.upper);
    }
  }
}

TEST_CASE("the nearest word is found, and none where nothing is near") {
  CHECK(edit_distance("stem", "stem") == 0);
  CHECK(edit_distance("stem", "setm") == 1);
  CHECK(edit_distance("kitten", "sitting") == 3);
  CHECK(nearest("stem_dge", {"flare_deg", "stem_deg"}) == "stem_deg");
  CHECK(nearest("beam", {"depth_m", "beam_m"}) == "beam_m");
  CHECK(nearest("zzzzzz", {"flare_deg", "stem_deg"}).empty());
}

TEST_CASE("null drops a key that exists; one that does not is a mistake like any other") {
  const auto set = [](const std::string& patch) {
    return with(R"({"designs": [{"name": "a", "set": )" + patch + "}]}");
  };
  CHECK(mistakes_of(set(R"({"ice": {"friction": null, "scale": null}, "sheet": null})")).empty());
  const Mistake m = only_mistake(set(R"({"ice": {"frictoin": null}})"));
  CHECK(m.pointer == "/designs/0/set/ice/frictoin");
  CHECK_THAT(m.message, Catch::Contains("did you mean \"friction\""));
  CHECK(only_mistake(set(R"({"water": {"scale": null}})")).pointer == "/designs/0/set/water/scale");
}

TEST_CASE("names of designs fit into a directory, with what the program adds to them") {
  const auto letters = [](int n, const std::string& letter) {
    std::string name;
    for (int k = 0; k < n; ++k) name += letter;
    return name;
  };
  CHECK(is_design_name(letters(64, "a")));
  CHECK(is_design_name(letters(64, "\u00e9")));
  CHECK(is_design_name(letters(50, "\U0001F6A2")));
  CHECK_FALSE(is_design_name(letters(51, "\U0001F6A2")));
  CHECK_FALSE(is_design_name(letters(64, "\U0001F6A2")));
  CHECK_FALSE(is_design_name("a\u202eb"));
  for (const char* name : {"baseline", "d001", "d1#2", "Steep stem~0a1b2c3d", "a#12~0a1b2c3d"})
    CHECK(is_stored_name(name));
  for (const char* name : {"", ".", "..", "../x", "a/b", "/etc", ".hidden", "a~b/../..", "a\n", "a\x1b[2J"})
    CHECK_FALSE(is_stored_name(name));
}

TEST_CASE("reading designs costs in proportion to their number, and a long wrong word next to nothing") {
  const auto seconds = [](int designs) {
    Json document = minimal();
    for (int k = 0; k < designs; ++k)
      document["designs"].push_back(
          {{"name", "x" + std::to_string(k)}, {"set", {{"bow", {{"stem_deg", 20 + 1e-3 * k}}}}}});
    const std::clock_t begin = std::clock();
    CHECK(plan_study(read_study(document, "t.json")).designs.size() == static_cast<std::size_t>(designs) + 1);
    return double(std::clock() - begin) / CLOCKS_PER_SEC;
  };
  seconds(50);
  CHECK(seconds(800) <
        20 * std::max(0.01, seconds(100)));  // 8 where it is linear, 64 where every pair is looked at
  const std::string word(1000000, 'x');
  const std::clock_t begin = std::clock();
  CHECK(mistakes_of(with("{\"bow\": {\"" + word + "\": 1}, \"" + word + "\": 2}")).size() == 2);
  CHECK(double(std::clock() - begin) / CLOCKS_PER_SEC <
        2.0);  // a hundredth of a second; over 30 s by tables of distances
}

TEST_CASE("what other tools and tongues write is answered with what is meant") {
  const auto message = [](const std::string& patch) { return only_mistake(with(patch)).message; };
  const std::string range = R"("variables": {"/bow/stem_deg": {"min": 18, "max": 30}})";
  CHECK_THAT(message(R"({"method": {"type": "lhs"}})"), Catch::Contains("did you mean \"latin_hypercube\""));
  CHECK_THAT(message(R"({"method": {"type": "optimise", "algorithm": "COBYLA", )" + range + "}}"),
             Catch::Contains("did you mean \"cobyla\""));
  CHECK_THAT(message(R"({"bow": {"stem_deg": "24,35"}})"), Catch::Contains("write 24.35"));
  CHECK_THAT(message(R"({"bow": {"stem_deg": "steep"}})"), !Catch::Contains("write"));
  CHECK_THAT(
      message(R"({"method": {"type": "grid", "variables": {"/bow/stem_rad": {"values": [0.3, 0.4]}}}})"),
      Catch::Contains("the file gives /bow/stem_deg: vary that, in its unit"));
}

TEST_CASE("designs by their names: how many variables, levels and samples they take") {
  const auto method = [](const std::string& text) {
    return read_study(with("{\"method\": {" + text + "}}"), "t").method;
  };
  const std::string
      one = R"("/bow/stem_deg": {"min": 20, "max": 28})",
      three =
          one + R"(, "/bow/flare_deg": {"min": 30, "max": 36}, "/ice/thickness_m": {"min": 0.5, "max": 1})";
  CHECK(method(R"("type": "sobol", "samples": 16, "variables": {)" + one + "}").samples == 16);
  CHECK(method(R"("type": "box_behnken", "variables": {)" + three + "}").type == MethodType::box_behnken);
  CHECK(method(R"("type": "latin_hypercube", "samples": 12, "extends": [3, 6], "variables": {)" + one + "}")
            .extends == std::vector<int>{3, 6});
  CHECK(method(R"("type": "one_at_a_time", "variables": {"/bow/stem_deg": {"values": [20, 28]}})")
            .variables[0]
            .values.size() == 2);
  CHECK(only_mistake(with(R"({"method": {"type": "box_behnken", "variables": {)" + one + "}}}")).pointer ==
        "/method/variables");
  for (const char* wrong : {"[6, 3]", "[12]", "[]", "3", "[2.5]"})
    CHECK(only_mistake(with(R"({"method": {"type": "latin_hypercube", "samples": 12, "extends": )" +
                            std::string(wrong) + R"(, "variables": {)" + one + "}}}"))
              .pointer == "/method/extends");
  CHECK(
      only_mistake(with(R"({"method": {"type": "sobol", "seed": 3, "variables": {)" + one + "}}}")).pointer ==
      "/method/seed");
}

TEST_CASE("designs from a table") {
  const auto path = std::filesystem::temp_directory_path() / ("icebow_table_" + std::to_string(::getpid()));
  std::filesystem::create_directories(path);
  const auto message = [&](const std::string& csv) -> std::string {
    write_text_file((path / "d.csv").string(), csv);
    try {
      const StudySpec spec =
          read_study(with(R"({"method": {"type": "table", "file": "d.csv"}})"), (path / "s.json").string());
      CHECK(spec.document.at("method").at("rows").size() == spec.method.rows.size());
      std::filesystem::remove(path / "d.csv");  // the document has the numbers
      const StudySpec again = read_study(spec.document, (path / "s.json").string());
      std::string said;
      for (const PlannedDesign& p : plan_study(again).designs)
        for (const auto& [pointer, value] : p.design.parameters) said += pointer + " " + brief(value) + ";";
      return said;
    } catch (const InputError& error) {
      return error.what();
    }
  };
  const std::string baseline = "/bow/stem_deg 24.35;/operation/speed_kn 4;";
  CHECK(message("design,/bow/stem_deg,/operation/speed_kn\nd001,21,3\n\"a, b\",22.5,5\n") ==
        baseline + "/bow/stem_deg 21;/operation/speed_kn 3;/bow/stem_deg 22.5;/operation/speed_kn 5;");
  CHECK(message("\xef\xbb\xbf/bow/stem_deg;/operation/speed_kn\r\n21;3\r\n\r\n") ==
        baseline + "/bow/stem_deg 21;/operation/speed_kn 3;");
  CHECK_THAT(message("/bow/stem_deg;x\n21,5;1\n"),
             Catch::Contains("d.csv, line 2, /bow/stem_deg") && Catch::Contains("write 21.5"));
  CHECK_THAT(message("/bow/stem_deg,/ice/thickness_m\n21\n"), Catch::Contains("line 2: has 1 cells"));
  CHECK_THAT(message("stem\n21\n"), Catch::Contains("names no column"));
  CHECK_THAT(message("/bow/stem_deg\n95\n"), Catch::Contains("allowed 5 to 85 deg"));
  CHECK_THAT(message("/bow/stm_deg\n21\n"), Catch::Contains("did you mean \"/bow/stem_deg\""));
  CHECK(only_mistake(
            with(R"({"method": {"type": "table", "columns": ["/bow/stem_deg"], "rows": [[20], [21, 3]]}})"))
            .pointer == "/method/rows/1");
  CHECK(only_mistake(with(R"({"method": {"type": "table"}})")).pointer == "/method/columns");
  std::filesystem::remove_all(path);
}
