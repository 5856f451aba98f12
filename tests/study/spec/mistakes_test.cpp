// What the reader answers to a study file with mistakes.
#include <catch2/catch.hpp>
#include <cmath>
#include <ctime>

#include "study/plan/design_space.h"
#include "study/spec/spec_hints.h"
#include "study/spec/spec_keys.h"
#include "study/spec/spec_method.h"
#include "tests/support/study_documents.h"

using namespace icebow;

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

TEST_CASE("an unknown optimiser is answered with the known ones") {
  const std::string message = only_mistake(with(R"({"method": {"type": "optimise", "algorithm": "cobila",
    "variables": {"/bow/stem_deg": {"min": 18, "max": 30}}}})"))
                                  .message;
  for (const Algorithm& a : algorithms()) CHECK(message.find(a.name) != std::string::npos);
  CHECK(message.find("did you mean \"cobyla\"") != std::string::npos);
  CHECK(find_algorithm("cobyla")->takes_constraints);
  CHECK_FALSE(find_algorithm("sbplx")->takes_constraints);
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
  const std::string scenario = R"({"evaluators": ["lindqvist"], "ranking": {"by": "lindqvist_breaking"},
      "scenarios": [{"name": "a", "set": {"ice": {"thickness_m": 1, "frictoin": null}}}]})";
  CHECK(only_mistake(with(scenario)).pointer == "/scenarios/0/set/ice/frictoin");
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

TEST_CASE("an optimiser varies the ship alone") {
  const auto optimise = [](const std::string& pointer) {
    return with(R"({"evaluators": ["lindqvist"], "method": {"type": "optimise", "variables": {")" + pointer +
                R"(": {"min": 0.9, "max": 2}}}})");
  };
  for (const char* pointer : {"/ice/thickness_m", "/operation/speed_kn"})
    CHECK_THAT(only_mistake(optimise(pointer)).message,
               Catch::Contains(pointer) && Catch::Contains("the ship alone"));
  CHECK(mistakes_of(with(R"({"evaluators": ["lindqvist"], "method": {"type": "grid", "variables":
    {"/ice/thickness_m": {"values": [0.5, 1]}}}})"))
            .empty());
}

TEST_CASE("a race sails its first leg at the least") {
  const std::string race = R"({"sheet": {"window_ahead_m": 40}, "operation": {"advance_m": 60}, "decide": )";
  CHECK(only_mistake(with(race + R"({"longest_m": 59}})")).pointer == "/decide/longest_m");
  CHECK(mistakes_of(with(race + R"({"longest_m": 60}})")).empty());
}

TEST_CASE("what other tools and tongues write is answered with what is meant") {
  const auto message = [](const std::string& patch) { return only_mistake(with(patch)).message; };
  const std::string range = R"("variables": {"/bow/stem_deg": {"min": 18, "max": 30}})";
  CHECK_THAT(message(R"({"method": {"type": "lhs"}})"), Catch::Contains("did you mean \"latin_hypercube\""));
  CHECK_THAT(message(R"({"method": {"type": "optimise", "algorithm": "COBYLA", )" + range + "}}"),
             Catch::Contains("did you mean \"cobyla\""));
  for (const auto& [theirs, ours] :
       {std::pair("Latin hypercube", "latin_hypercube"), std::pair("random", "latin_hypercube"),
        std::pair("Monte Carlo", "latin_hypercube"), std::pair("CCD", "central_composite"),
        std::pair("full factorial", "grid")})
    CHECK_THAT(message(R"({"method": {"type": ")" + std::string(theirs) + "\"}}"),
               Catch::Contains("did you mean \"" + std::string(ours) + "\""));
  for (const auto& [theirs, ours] :
       {std::pair("Nelder-Mead", "neldermead"), std::pair("EGO", "expected_improvement"),
        std::pair("Bayesian optimization", "expected_improvement"), std::pair("genetic", "esch")})
    CHECK_THAT(message(R"({"method": {"type": "optimise", "algorithm": ")" + std::string(theirs) + "\", " +
                       range + "}}"),
               Catch::Contains("did you mean \"" + std::string(ours) + "\""));
  CHECK_THAT(message(R"({"bow": {"stem_deg": "1e999"}})"), !Catch::Contains("write"));
  CHECK_THAT(message(R"({"bow": {"stem_deg": "24,35"}})"), Catch::Contains("write 24.35"));
  CHECK_THAT(message(R"({"bow": {"stem_deg": "steep"}})"), !Catch::Contains("write"));
  CHECK_THAT(
      message(R"({"method": {"type": "grid", "variables": {"/bow/stem_rad": {"values": [0.3, 0.4]}}}})"),
      Catch::Contains("the file gives /bow/stem_deg: vary that, in its unit"));
}
