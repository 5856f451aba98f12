// A study of the user's own hull: from the mesh file to the result.
#include <catch2/catch.hpp>
#include <cmath>

#include "base/units.h"
#include "study/evaluate/evaluate.h"
#include "study/evaluate/evaluator_inputs.h"
#include "study/evaluate/result_keys.h"
#include "study/plan/design_space.h"
#include "study/spec/case_hull.h"
#include "study/spec/read_study.h"
#include "tests/support/fake_study.h"
#include "tests/support/main.h"

using namespace icebow;

namespace {

const std::string mesh_file = STUDIES "/hulls/supply_vessel.obj";

Json document(const std::string& patch = "{}") {
  Json d = Json::parse(R"({"icebow_study": 1, "hull": {"forward": "-x", "draft_m": 6.5, "mirror": true},
    "ice": {"model": "paper", "thickness_m": 1.2}, "sheet": {"length_m": 34, "width_m": 40},
    "operation": {"speed_kn": 6, "advance_m": 6, "steady_from_m": 2},
    "solver": {"layers": 1}, "output": {"pictures": 1}})");
  d["hull"]["file"] = mesh_file;
  d.merge_patch(Json::parse(patch));
  return d;
}

Case own(const std::string& patch = "{}") {
  return read_study(document(patch), "t.json").baseline;
}

std::string mistakes(const Json& d) {
  try {
    read_study(d, "t.json");
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

Evaluation evaluated(const std::string& patch, const EvaluateOptions& options = {}) {
  return evaluate(test_world(), read_design("one", document(patch)), options);
}

}  // namespace

TEST_CASE("dimensions and angles of the ship are those of the mesh") {
  const Case c = own();
  CHECK(c.own.imported->mesh.quads.size() > 400);
  CHECK(c.bow.L == Approx(80.0));
  CHECK(c.bow.B == Approx(18.0));
  CHECK(c.bow.T == Approx(6.5));
  CHECK(c.bow.D == Approx(10.0));
  CHECK(c.bow.Lf > 20.0);
  CHECK(c.bow.Lf < 24.0);  // l of the file's formula, where the fairing ends
  CHECK(degrees(c.bow.angles.stem) == Approx(28.0).margin(0.001));  // found 0.0002: digits of the file
  // dy/dx = 9 * 1.7 / 24 at the stem.
  CHECK(degrees(c.bow.angles.waterline) ==
        Approx(degrees(std::atan(9.0 * 1.7 / 24.0))).margin(0.5));  // deg: panels leave it over a curve
  const LindqvistInputs in = lindqvist_inputs(c);
  CHECK(in.stem == c.bow.angles.stem);
  CHECK(in.waterline == c.bow.angles.waterline);
  CHECK(c.sheet.width == 40.0);
  CHECK(own(R"({"sheet": {"width_m": null}})").sheet.width == Approx(3.5 * 18.0));
}

TEST_CASE("a file is meant from the study's directory, and a design may have another") {
  const TemporaryDirectory scratch;
  Json d = document(
      R"({"hull": {"file": "a.obj"}, "designs": [{"name": "B", "set": {"hull": {"file": "b.obj"}}}]})");
  for (const char* name : {"a.obj", "b.obj"})
    write_text_file(scratch / name, read_text_file(mesh_file) + "# " + name + "\n");
  const StudySpec spec = read_study(d, scratch / "study.json");
  CHECK(spec.baseline.own.file == scratch / "a.obj");
  const StudyPlan plan = plan_study(spec);
  REQUIRE(plan.designs.size() == 2);
  CHECK(plan.designs[0].key != plan.designs[1].key);
  CHECK(plan.designs[1].design.document.at("hull").at("file") == scratch / "b.obj");
}

TEST_CASE("the key hangs on what the file holds and how it is read, not on where it lies") {
  const auto key = [](const Case& c) { return evaluation_key(c, {true, true}); };
  const TemporaryDirectory scratch;
  const std::string text = read_text_file(mesh_file);
  const auto with_file = [&](const std::string& name, const std::string& content) {
    write_text_file(scratch / name, content);
    return key(own(R"({"hull": {"file": ")" + (scratch / name) + R"("}})"));
  };
  const std::string base = key(own());
  CHECK(with_file("copy.obj", text) == base);
  CHECK(with_file("copy.obj", text + "# changed\n") != base);
  for (const char* patch :
       {R"({"hull": {"draft_m": 6.4}})", R"({"hull": {"factor": 1.01}})",
        R"({"hull": {"left_handed": true}})", R"({"hull": {"stem_deg": 26}})",
        R"({"hull": {"stem_deg": 26, "flare_deg": 40}})", R"({"ice": {"thickness_m": 1.3}})"}) {
    INFO(patch);
    CHECK(key(own(patch)) != base);
  }
}

TEST_CASE("an imported hull runs the whole chain") {
  const TemporaryDirectory scratch;
  EvaluateOptions options;
  options.directory = test_world().broadcast(scratch / "designs/one");
  const Evaluation e = evaluated("{}", options);
  INFO(e.reason);
  REQUIRE(e.status == EvaluationStatus::ok);
  const Json& hull = e.result.at("hull");
  CHECK(hull.at("requested_deg").at("stem").is_null());
  CHECK(hull.at("measured_deg").at("stem").get<double>() == Approx(28.0).margin(0.001));  // as above
  CHECK(hull.at("mesh").at("closed") == true);
  for (const char* key : result_key::of_every_import) CHECK(e.result.contains(Json::json_pointer(key)));
  CHECK(hull.at("imported").at("file") == "supply_vessel.obj");
  CHECK(hull.at("imported").at("sha256") == own().own.sha256);
  CHECK(hull.at("imported").at("repairs").dump().find("mirrored") != std::string::npos);
  CHECK(e.result.at("ship").at("B_m").get<double>() == Approx(18.0));
  CHECK(e.result.at("metrics").at("full_scale").at("mean_load_N").get<double>() > 0.0);
  CHECK(e.result.at("lindqvist").at("inputs").at("stem_deg") == hull.at("measured_deg").at("stem"));
  if (test_world().is_root()) {
    const std::string lines = read_text_file(options.directory + "/lines.svg");
    CHECK(lines.find("imported from supply_vessel.obj") != std::string::npos);
    CHECK(read_text_file(options.directory + "/hull.obj").find("g bow") != std::string::npos);
  }
}

TEST_CASE("angles asked of an imported hull deform its bow") {
  const Evaluation e =
      evaluated(R"({"hull": {"stem_deg": 25, "flare_deg": 45}, "evaluators": ["lindqvist"]})");
  INFO(e.reason);
  REQUIRE(e.status == EvaluationStatus::ok);
  const Json& hull = e.result.at("hull");
  CHECK(hull.at("measured_deg").at("stem").get<double>() ==
        Approx(25.0).margin(1e-6));  // found 3e-9: rounding
  CHECK(hull.at("measured_deg").at("flare").get<double>() == Approx(45.0).margin(1e-6));  // likewise
  CHECK(hull.at("measured_deg").at("buttock").get<double>() ==
        Approx(degrees(own().own.imported->measured.angles.buttock)).margin(1e-6));  // likewise
  CHECK(e.result.at("lindqvist").at("inputs").at("stem_deg").get<double>() == Approx(25.0));

  const Evaluation folded = evaluated(R"({"hull": {"stem_deg": 5}, "evaluators": ["lindqvist"]})");
  CHECK(folded.status == EvaluationStatus::infeasible);
  CHECK_THAT(folded.reason, Catch::Contains("cannot be deformed"));
}

TEST_CASE("what is wrong with a hull is said with its place in the study") {
  CHECK(mistakes(document()) == "");
  CHECK_THAT(mistakes(document(R"({"bow": {"stem_deg": 20}})")),
             Catch::Contains("/bow") && Catch::Contains("beside /hull"));
  CHECK_THAT(mistakes(document(R"({"hull": {"file": "none.stl"}})")),
             Catch::Contains("/hull/file") && Catch::Contains("none.stl: no such file"));
  CHECK_THAT(mistakes(document(R"({"hull": {"mirror": null}})")), Catch::Contains("/hull/file") &&
                                                                      Catch::Contains("not closed") &&
                                                                      Catch::Contains("\"mirror\": true"));
  CHECK_THAT(mistakes(document(R"({"hull": {"up": "-x"}})")), Catch::Contains("/hull/up"));
  CHECK_THAT(mistakes(document(R"({"hull": {"unit": "mm", "draft_m": null, "waterline_height_mm": 6.5}})")),
             Catch::Contains("0.08 m length") && Catch::Contains("/hull/unit"));
  CHECK_THAT(mistakes(document(R"({"hull": {"unit": "mm"}})")),
             Catch::Contains("does not cut the hull") && Catch::Contains("unit"));
  const Json swept =
      document(R"({"method": {"type": "grid", "variables": {"/bow/stem_deg": {"values": [20, 24]}}}})");
  CHECK_THAT(mistakes(swept), Catch::Contains("/hull/stem_deg"));
}
