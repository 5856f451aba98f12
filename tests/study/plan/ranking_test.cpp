#include "study/plan/ranking.h"

#include <catch2/catch.hpp>
#include <cmath>

#include "base/errors.h"

using namespace icebow;

namespace {

Evaluation design(const std::string& name, double load, double ci95, double formula, double beam = 20.0) {
  Evaluation e;
  e.name = name;
  e.status = EvaluationStatus::ok;
  e.result = {{"metrics", {{"full_scale", {{"mean_load_N", load}, {"mean_load_ci95_N", ci95}}}}},
              {"lindqvist", {{"breaking_N", formula}}},
              {"ship", {{"B_m", beam}}}};
  return e;
}

Evaluation without_result(const std::string& name, EvaluationStatus status) {
  Evaluation e;
  e.name = name;
  e.status = status;
  e.reason = "reason of " + name;
  return e;
}

std::string names(const Ranking& ranking) {
  std::string text;
  for (const RankedDesign& row : ranking.rows) text += row.evaluation.name + std::to_string(row.rank) + " ";
  return text;
}

}  // namespace

TEST_CASE("ranked by load, ties where Welch's test does not tell two apart") {
  // a 90..110 and b 108..112: p = 0.055; c 115..125: p < 0.001 from both; d 121..139: p = 0.057 from c.
  const Ranking r = rank_designs({design("d", 130, 9, 400), design("b", 110, 2, 300),
                                  design("c", 120, 5, 100), design("a", 100, 10, 200)},
                                 "mean_load");
  CHECK(names(r) == "a1 b2 c3 d4 ");
  CHECK(r.rows[0].tied_with_next);
  CHECK_FALSE(r.rows[0].tied_with_best);
  CHECK(r.rows[1].tied_with_best);
  CHECK_FALSE(r.rows[1].tied_with_next);
  CHECK_FALSE(r.rows[2].tied_with_best);
  CHECK(r.rows[2].tied_with_next);
  CHECK_FALSE(r.rows[3].tied_with_next);
  CHECK(r.rows[0].ratio == 0.5);
  // Ranks 1 2 3 4 against 2 3 1 4: 1 - 6 (1 + 1 + 4 + 0)/(4 * 15) = 0.4
  CHECK(r.spearman == Approx(0.4));
  CHECK(r.spearman_n == 4);
}

TEST_CASE(
    "a whole load is compared with the formula's total, a load of breaking alone with its breaking part") {
  Evaluation whole = design("whole", 300, 1, 100), part = design("part", 50, 1, 100);
  whole.result["simulation"] = {{"load", "whole"}};
  part.result["simulation"] = {{"load", "breaking"}};
  for (Evaluation* e : {&whole, &part}) e->result["lindqvist"]["total_N"] = 200.0;
  const Ranking r = rank_designs({whole, part}, "mean_load");
  CHECK(r.rows[0].ratio == 0.5);
  CHECK(r.rows[1].ratio == 1.5);
  CHECK(compared_part(r) == "total or breaking");
  CHECK(compared_part(rank_designs({whole}, "mean_load")) == "total");
  CHECK(compared_part(rank_designs({part}, "mean_load")) == "breaking");
}

TEST_CASE("what published ice amounts to is said once for each ice") {
  Evaluation a = design("a", 100, 1, 1), b = design("b", 200, 1, 2), c = design("c", 300, 1, 3);
  for (Evaluation* e : {&a, &b})
    e->result["simulation"]["ice"] = {{"model", "paper"}, {"sentence", "ice: the published model; strong"}};
  c.result["simulation"]["ice"] = {{"model", "calibrated"}, {"sentence", "ice: calibrated"}};
  int told = 0;
  for (const std::string& w : rank_designs({a, b, c}, "mean_load").warnings) {
    told += w == "ice: the published model; strong";
    CHECK(w != "ice: calibrated");
  }
  CHECK(told == 1);
}

TEST_CASE("a record too short for an interval is tied with everybody") {
  Evaluation shorter = design("short", 100, 1, 1);
  shorter.result["metrics"]["full_scale"]["mean_load_ci95_N"] = nullptr;  // infinite
  const Ranking r = rank_designs({shorter, design("far", 900, 1, 2)}, "mean_load");
  CHECK(r.rows[0].tied_with_next);
  CHECK(r.rows[1].tied_with_best);
}

TEST_CASE("per beam and by the formula") {
  const std::vector<Evaluation> designs = {design("wide", 300, 10, 7, 30), design("narrow", 280, 10, 9, 14)};
  const Ranking beam = rank_designs(designs, "mean_load_per_beam");
  CHECK(names(beam) == "wide1 narrow2 ");
  CHECK(beam.rows[0].value == 10.0);
  CHECK_FALSE(beam.rows[0].tied_with_next);  // 10 +- 1/3 and 20 +- 5/7
  const Ranking formula = rank_designs(designs, "lindqvist_breaking");
  CHECK(names(formula) == "wide1 narrow2 ");
  CHECK_FALSE(formula.rows[0].tied_with_next);
  CHECK_THROWS_AS(rank_designs(designs, "beauty"), InputError);
}

TEST_CASE("what has no value is listed after, never ranked") {
  Evaluation nan = design("nan", 1, 1, 1);
  nan.result["metrics"]["full_scale"]["mean_load_N"] = nullptr;
  const Ranking r =
      rank_designs({without_result("running", EvaluationStatus::running),
                    without_result("failed", EvaluationStatus::failed), nan,
                    without_result("infeasible", EvaluationStatus::infeasible), design("ok", 5, 1, 1)},
                   "mean_load");
  CHECK(names(r) == "ok1 infeasible0 failed0 nan0 running0 ");
  CHECK(r.rows[3].evaluation.reason == "has no mean_load to rank by");
  CHECK(std::isnan(ranking_value(nan, "mean_load")));
  CHECK(std::isnan(r.spearman));
  const Json json = to_json(r);
  CHECK(json.at("spearman").is_null());
  CHECK(json.at("designs")[1].at("mean_load_N").is_null());
  CHECK(json.at("designs")[1].at("reason") == "reason of infeasible");
  CHECK(json.at("designs")[0].at("mean_load_N") == 5);
}

TEST_CASE("a result of an infeasible design is not taken for a load") {
  Evaluation e = design("infeasible", 1, 1, 1);
  e.status = EvaluationStatus::infeasible;
  const Ranking r = rank_designs({e, design("ok", 5, 1, 1)}, "mean_load");
  CHECK(names(r) == "ok1 infeasible0 ");
}
