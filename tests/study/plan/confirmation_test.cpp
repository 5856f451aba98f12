// Two fidelities: which designs are confirmed, the ratio that is fitted, and what it makes of a ranking.
#include "study/plan/confirmation.h"

#include <catch2/catch.hpp>
#include <cmath>

#include "study/plan/design_space.h"
#include "study/plan/ranking.h"
#include "tests/support/fake_study.h"

using namespace icebow;

namespace {

Fidelities design(const std::string& name, double stem, double cycle, double solver = NAN,
                  double solver_ci95 = 0.05) {
  Fidelities f;
  f.design = name;
  f.parameters = {{"/bow/stem_deg", stem}};
  f.cycle = cycle, f.cycle_ci95 = 0.01 * cycle;
  f.solver = solver, f.solver_ci95 = solver_ci95 * solver;
  return f;
}

Evaluation evaluation(const std::string& name, const Json& result, double stem) {
  Evaluation e;
  e.key = name, e.name = name, e.status = EvaluationStatus::ok, e.result = result;
  e.parameters = {{"/bow/stem_deg", stem}};
  return e;
}

Json loads(double mean, double ci95) {
  return {{"full_scale", {{"mean_load_N", mean}, {"mean_load_ci95_N", ci95}}}};
}

Evaluation by_cycle(const std::string& name, double stem, double mean) {
  return evaluation(name,
                    {{"cycle", {{"mean_load_N", mean}, {"mean_load_ci95_N", 0.01 * mean}}},
                     {"metrics", loads(mean, 0.01 * mean)}},
                    stem);
}

Evaluation by_solver(const std::string& name, double stem, double mean) {
  return evaluation(name, {{"metrics", loads(mean, 0.02 * mean)}}, stem);
}

}  // namespace

TEST_CASE("the best and what is far from them are confirmed, the baseline first") {
  const std::vector<Fidelities> ranked = {design("a", 20, 1),        design("b", 21, 2), design("c", 22, 3),
                                          design("baseline", 23, 4), design("d", 24, 5), design("e", 40, 6)};
  CHECK(designs_to_confirm(ranked, 2, 0) == std::vector<std::string>{"a", "b"});
  CHECK(designs_to_confirm(ranked, 2, 2) == std::vector<std::string>{"a", "b", "baseline", "e"});
  CHECK(designs_to_confirm(ranked, 9, 9).size() == 6);
}

TEST_CASE("a constant ratio, with the error of both") {
  const RatioFit fit = fit_ratio(
      {design("a", 20, 100, 50), design("b", 24, 120, 66), design("c", 30, 200, 90), design("d", 30, 210)});
  CHECK(fit.designs == 3);
  CHECK(fit.variable.empty());
  CHECK(std::exp(fit.constant) == Approx(std::cbrt(0.5 * 0.55 * 0.45)));
  CHECK(fit.half_width({}) > fit.half_width_of_difference({}));
  CHECK(fit.between > 0.0);  // 10 % between designs, 2.6 % of their own
}

TEST_CASE("a slope is taken where designs left out are met better by it, and only there") {
  std::vector<Fidelities> sloping, level;
  const double noise[] = {0.01, -0.012, 0.008, -0.006, 0.011, -0.01};
  for (int i = 0; i < 6; ++i) {
    const double stem = 20.0 + 2.0 * i;
    sloping.push_back(design("s", stem, 100, 60 * std::exp(0.05 * (stem - 25)) * (1 + noise[i])));
    level.push_back(design("l", stem, 100, 60 * (1 + noise[i])));
  }
  const RatioFit with = fit_ratio(sloping), without = fit_ratio(level);
  CHECK(with.variable == "/bow/stem_deg");
  CHECK(with.slope == Approx(0.05).epsilon(0.1));  // noise of 1 %: the standard error is 2.4 %
  CHECK(with.error < 0.3 * with.error_of_constant);
  CHECK(without.variable.empty());
}

TEST_CASE("a simulation is compared with the cycle over the same way") {
  // Both entered the ice while they were counted: half of the load of the whole voyage, by either.
  Fidelities a = design("a", 20, 100, 49), b = design("b", 24, 120, 61);
  a.beside = 50, a.beside_ci95 = 1, b.beside = 60, b.beside_ci95 = 1;
  const RatioFit fit = fit_ratio({a, b});
  CHECK(std::exp(fit.constant) == Approx(std::sqrt(49.0 / 50.0 * 61.0 / 60.0)));
  CHECK(disagreements(fit, {a, b}).empty());

  Evaluation solved = by_solver("a@solver", 20, 45);
  solved.result["cycle"] = {
      {"mean_load_N", 100}, {"mean_load_ci95_N", 1}, {"same_way", {{"mean_load_N", 50}, {"ci95_N", 1}}}};
  const Ranking ranking = rank_designs({by_cycle("a", 20, 100), by_cycle("b", 24, 120), solved}, "mean_load");
  REQUIRE(ranking.rows.size() == 2);
  CHECK(ranking.rows[0].mean_load == Approx(90.0));  // of the whole voyage, times 45/50
  CHECK(ranking.rows[1].mean_load == Approx(108.0));
}

TEST_CASE("one confirmed design gives a ratio and no interval") {
  const RatioFit fit = fit_ratio({design("a", 20, 100, 50), design("b", 22, 90)});
  CHECK(fit.ratio({}) == Approx(0.5));
  CHECK(std::isinf(fit.half_width({})));
  CHECK(fit_ratio({design("b", 22, 90)}).designs == 0);
}

TEST_CASE("where the two disagree beyond their intervals it is said") {
  const std::vector<Fidelities> agreeing = {design("a", 20, 100, 101), design("b", 22, 110, 108),
                                            design("c", 24, 120, 121)};
  CHECK(disagreements(fit_ratio(agreeing), agreeing).empty());
  const std::vector<Fidelities> level = {design("a", 20, 100, 50), design("b", 22, 110, 56),
                                         design("c", 24, 120, 59)};
  const auto words = disagreements(fit_ratio(level), level);
  REQUIRE(words.size() == 1);
  CHECK(words[0].find("the simulation has 0.50 (") != std::string::npos);
  std::vector<Fidelities> order = level;
  order[2].solver = 118;
  const auto both = disagreements(fit_ratio(order), order);
  REQUIRE_FALSE(both.empty());
  CHECK(both.back().find("disagree on c: ") != std::string::npos);
}

TEST_CASE(
    "a ranking goes by the corrected load, its interval has both errors, ties leave out what all share") {
  std::vector<Evaluation> all = {by_cycle("baseline", 24, 120e3), by_cycle("d001", 20, 100e3),
                                 by_cycle("d002", 30, 150e3)};
  const Ranking before = rank_designs(all, "mean_load");
  CHECK(before.confirmed.designs == 0);
  CHECK(before.rows[0].mean_load == 100e3);
  for (const auto& [name, stem, mean] :
       {std::tuple("baseline@solver", 24.0, 62e3), std::tuple("d001@solver", 20.0, 49e3),
        std::tuple("d001@solver#2", 20.0, 51e3)})
    all.push_back(by_solver(name, stem, mean));
  const Ranking ranking = rank_designs(all, "mean_load");
  REQUIRE(ranking.rows.size() == 3);  // simulations are no designs of their own
  CHECK(ranking.confirmed.designs == 2);
  const double ratio = std::sqrt(62.0 / 120.0 * 50.0 / 100.0);
  CHECK(ranking.rows[0].evaluation.name == "d001");
  CHECK(ranking.rows[0].mean_load == Approx(ratio * 100e3));
  CHECK(ranking.rows[0].solver_load == Approx(50e3));
  CHECK(ranking.rows[0].cycle_load == 100e3);
  CHECK(ranking.rows[2].mean_load == Approx(ratio * 150e3));
  CHECK(std::isnan(ranking.rows[2].solver_load));
  CHECK(ranking.rows[0].mean_load_ci95 > ranking.rows[0].difference_ci95);
  CHECK_FALSE(ranking.rows[2].tied_with_best);
  CHECK(ranking.disagreements.empty());  // two designs, one of two runs: the level is not known to a half
}

TEST_CASE("a study that confirms sweeps without the simulation, and simulates what is chosen") {
  const StudySpec spec = read_study(
      fake_document(
          R"({"evaluators": ["lindqvist", "cycle", "peridynamics"], "confirm": {"best": 1, "spread": 1},
                        "repeats": 2})"),
      "fake");
  CHECK_FALSE(spec.use_peridynamics);
  const StudyPlan plan = plan_study(spec);
  for (const PlannedDesign& planned : plan.designs) {
    CHECK_FALSE(planned.design.asked.peridynamics);
    CHECK(planned.design.name.find('#') == std::string::npos);  // the cycle would give the same again
  }
  const std::vector<PlannedDesign> runs = confirmations(spec, plan.designs.front().design);
  REQUIRE(runs.size() == 2);
  CHECK(runs[0].design.name == "baseline@solver");
  CHECK(runs[1].design.name == "baseline@solver#2");
  CHECK(runs[0].design.asked.peridynamics);
  CHECK(runs[0].design.asked.cycle);  // over the way of the simulation
}
