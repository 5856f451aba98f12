// The designs that a study file asks for: named, varied, from a table, set on the command line.
#include <unistd.h>
#include <catch2/catch.hpp>
#include <filesystem>

#include "base/text_file.h"
#include "base/units.h"
#include "study/plan/design_space.h"
#include "study/spec/design_name.h"
#include "study/spec/document_keys.h"
#include "study/spec/spec_case.h"
#include "study/spec/spec_hints.h"
#include "study/spec/spec_method.h"
#include "tests/support/study_documents.h"

using namespace icebow;

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

TEST_CASE("what is looked up in a study file is where the reader takes it from") {
  const Json document = with(R"({"name": "all", "purpose": "keys", "solver": {"seed": 3},
    "evaluators": ["lindqvist"], "constraints": [{"at": "/hydrostatics/displacement_kg", "min": 1}],
    "scenarios": [{"name": "thin", "weight": 2, "set": {"ice": {"thickness_m": 0.5}}}],
    "ranking": {"over_scenarios": "worst"},
    "method": {"type": "latin_hypercube", "samples": 8, "extends": [4],
               "variables": {"/bow/stem_deg": {"min": 18, "max": 30}}}})");
  CHECK(mistakes_of(document).empty());  // a key that the reader does not know would be one
  const auto has = [](const Json& json, const char* pointer) {
    CAPTURE(pointer);
    CHECK(json.contains(Json::json_pointer(pointer)));
  };
  for (const char* pointer : document_key::all) has(document, pointer);
  has(document.at("constraints")[0], document_key::constraint_at);
  has(document.at("scenarios")[0], document_key::scenario_name);
  has(document.at("scenarios")[0], document_key::scenario_weight);
  has(document.at("method").at("variables").front(), document_key::variable_min);
  has(document.at("method").at("variables").front(), document_key::variable_max);
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
  for (const char* no_number : {"0x19", "inf", "nan", "", "2 1"})
    CHECK_THAT(message("/bow/stem_deg,x\n" + std::string(no_number) + ",1\n"),
               Catch::Contains("is no number"));
  CHECK_THAT(message(std::string("/bow/stem_deg\n21\0 22\n", 20)), Catch::Contains("zero byte"));
  CHECK_THAT(message("/bow/stem_deg,/bow/stem_deg\n21,22\n"), Catch::Contains("names /bow/stem_deg twice"));
  CHECK_THAT(message("/bow/stem_deg,/ice/thickness_m\n21\n"), Catch::Contains("line 2: has 1 cells"));
  CHECK(message("/bow/stem_deg,/operation/speed_kn\r21,3\r") ==
        baseline + "/bow/stem_deg 21;/operation/speed_kn 3;");
  CHECK_THAT(message("/bow/stem_deg\n\"21\n"),
             Catch::Contains("line 2: has a double quote that is not closed"));
  CHECK_THAT(message("stem\n21\n"), Catch::Contains("names no column"));
  CHECK_THAT(message("/bow/stem_deg\n95\n"), Catch::Contains("allowed 5 to 85 deg"));
  CHECK_THAT(message("/bow/stm_deg\n21\n"), Catch::Contains("did you mean \"/bow/stem_deg\""));
  CHECK(only_mistake(
            with(R"({"method": {"type": "table", "columns": ["/bow/stem_deg"], "rows": [[20], [21, 3]]}})"))
            .pointer == "/method/rows/1");
  CHECK(only_mistake(with(R"({"method": {"type": "table"}})")).pointer == "/method/columns");
  CHECK(only_mistake(with(R"({"method": {"type": "table", "columns": ["/bow/stem_deg", "/bow/stem_deg"],
                                         "rows": [[20, 21]]}})"))
            .message == "names a pointer twice; keep one of the two columns");
  std::filesystem::remove_all(path);
}
