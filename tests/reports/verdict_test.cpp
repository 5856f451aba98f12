#include "reports/content/verdict.h"

#include <catch2/catch.hpp>

#include "reports/content/load_unit.h"

namespace icebow {
namespace {

Evaluation measured(const std::string& name, double mean, double ci95, double lindqvist = 1e6) {
  Evaluation e;
  e.key = e.name = name;
  e.status = EvaluationStatus::ok;
  e.result = {{"ship", {{"B_m", 20.0}}},
              {"metrics", {{"full_scale", {{"mean_load_N", mean}, {"mean_load_ci95_N", ci95}}}}},
              {"lindqvist", {{"breaking_N", lindqvist}}}};
  return e;
}

StudyResults study_of(const std::vector<Evaluation>& evaluations, const std::string& rank_by = "mean_load") {
  StudyResults study;
  study.state = "finished";
  study.ok = static_cast<int>(evaluations.size());
  study.ranking = rank_designs(evaluations, rank_by);
  return study;
}

bool says(const Verdict& words, const std::string& part) {
  for (const std::string& remark : words.remarks)
    if (remark.find(part) != std::string::npos) return true;
  return false;
}

}  // namespace

TEST_CASE("the best design stands alone, or with those it cannot be told apart from") {
  const Verdict alone = verdict(study_of({measured("a", 1.2e6, 5e4), measured("b", 0.8e6, 6e4)}));
  CHECK(alone.headline ==
        "b has the lowest mean ice load, 0.80\u00a0\u00b1\u00a00.06\u00a0MN; its interval overlaps that of "
        "no other design.");
  const Verdict tied =
      verdict(study_of({measured("a", 0.9e6, 5e4), measured("b", 0.8e6, 6e4), measured("c", 2e6, 5e4)}));
  CHECK(
      tied.headline ==
      "b has the lowest mean ice load, 0.80\u00a0\u00b1\u00a00.06\u00a0MN; a cannot be told apart from it.");
}

TEST_CASE("an interval that is not known is not made up") {
  const Verdict words = verdict(study_of({measured("a", 8.125e5, std::nan(""))}));
  CHECK(words.headline == "a has the lowest mean ice load, 0.812\u00a0MN.");
}

TEST_CASE("the baseline is compared with where it is another design") {
  const Verdict words = verdict(study_of({measured("baseline", 1.0e6, 5e4), measured("b", 0.75e6, 6e4)}));
  CHECK(says(words, "25\u00a0% below the baseline (1.00\u00a0\u00b1\u00a00.05\u00a0MN)"));
  CHECK_FALSE(says(verdict(study_of({measured("baseline", 0.8e6, 5e4), measured("b", 0.75e6, 6e4)})),
                   "below the baseline"));
}

TEST_CASE("the order of the formula is put in words only where there are designs enough") {
  std::vector<Evaluation> designs;
  for (int i = 0; i < 5; ++i)
    designs.push_back(measured(std::to_string(i), 1e6 + 2e5 * i, 5e4, 2e6 - 1e5 * i));
  CHECK(says(verdict(study_of(designs)), "opposite order"));
  designs.resize(3);
  CHECK_FALSE(says(verdict(study_of(designs)), "Spearman"));
}

TEST_CASE("other quantities carry their own unit") {
  const Verdict per_beam = verdict(study_of({measured("a", 1e6, 4e4)}, "mean_load_per_beam"));
  CHECK(per_beam.headline ==
        "a has the lowest mean ice load per metre of beam, 50.0\u00a0\u00b1\u00a02.0\u00a0kN/m.");
  const Verdict formula = verdict(
      study_of({measured("a", 1e6, 4e4, 9.5e5), measured("b", 1e6, 4e4, 9.9e5)}, "lindqvist_breaking"));
  CHECK(formula.headline == "a has the lowest breaking resistance by Lindqvist's formula, 0.950\u00a0MN.");
}

TEST_CASE("nothing ranked is said, not hidden") {
  StudyResults none;
  CHECK(verdict(none).headline == "No design has been evaluated yet.");
  none.failed = 2;
  CHECK(verdict(none).headline == "No design could be ranked: each was infeasible or failed.");
}

TEST_CASE("what is missing is counted") {
  StudyResults study = study_of({measured("a", 1e6, 4e4)});
  study.state = "interrupted";
  study.infeasible = 1;
  study.running = {"b"};
  study.waiting = {"c", "d"};
  CHECK(says(verdict(study), "Not ranked: 1 design infeasible"));
  CHECK(says(verdict(study),
             "The study was interrupted: 1 design started without a result and 2 designs not started."));
}

TEST_CASE("small loads are told in kN") {
  CHECK(load_unit(study_of({measured("a", 4e4, 2e3, 5e4)}).ranking).name == "kN");
  CHECK(load_unit(study_of({measured("a", 4e4, 2e3, 5e5)}).ranking).name == "MN");
}

}  // namespace icebow
