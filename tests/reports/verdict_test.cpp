#include "reports/content/verdict.h"

#include <catch2/catch.hpp>

#include "reports/content/conditions.h"
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

bool says_in(const std::string& text, const std::string& words) {
  INFO(text);
  return text.find(words) != std::string::npos;
}

TEST_CASE("the best design is told from the others, or the others are counted") {
  const Verdict alone = verdict(study_of({measured("a", 1.2e6, 5e4), measured("b", 0.8e6, 6e4)}));
  CHECK(alone.ranks);
  CHECK(alone.headline == "b has the lowest mean ice load, 0.80\u00a0\u00b1\u00a00.06\u00a0MN.");
  const Verdict tied =
      verdict(study_of({measured("a", 0.85e6, 5e4), measured("b", 0.8e6, 6e4), measured("c", 2e6, 5e4)}));
  CHECK(tied.headline ==
        "b has the lowest mean ice load, 0.80\u00a0\u00b1\u00a00.06\u00a0MN; 1 other design cannot be told "
        "apart from "
        "it.");
  CHECK(tied.next.find("repeats") != std::string::npos);
}

TEST_CASE("confirmed by few simulations the order is told, and the level is said to be open") {
  StudyResults study = study_of({measured("baseline", 0.95e6, 2.8e6), measured("b", 0.8e6, 2.4e6)});
  for (RankedDesign& row : study.ranking.rows) row.difference_ci95 = 3e4;  // of the cycle alone
  study.ranking.confirmed.designs = 2;
  const Verdict words = verdict(study);
  CHECK(words.ranks);
  CHECK(says_in(words.headline, "b has the lowest mean ice load"));
  CHECK(says_in(words.headline, "16\u00a0\u00b1\u00a04\u00a0% below the baseline (p < 0.001)"));
  CHECK(
      says(words,
           "The level of the loads is not known: its interval is wider than the mean after 2 simulations."));
  CHECK(says_in(words.next, "confirm.best"));
  for (RankedDesign& row : study.ranking.rows) row.difference_ci95 = 1.2e6;  // nor the order
  CHECK_FALSE(verdict(study).ranks);
}

TEST_CASE("an interval that is not known is not made up") {
  const Verdict words = verdict(study_of({measured("a", 8.125e5, std::nan(""))}));
  CHECK(words.headline == "a is the only design with a rank: mean ice load 0.812\u00a0MN.");
}

TEST_CASE("the baseline is compared with where it is another design, with the test of the difference") {
  const Verdict words = verdict(study_of({measured("baseline", 1.0e6, 5e4), measured("b", 0.75e6, 6e4)}));
  CHECK(words.headline ==
        "b has the lowest mean ice load, 0.75\u00a0\u00b1\u00a00.06\u00a0MN, 25\u00a0\u00b1\u00a08\u00a0% "
        "below the baseline (p "
        "< 0.001).");
  const Verdict near = verdict(study_of({measured("baseline", 0.8e6, 5e4), measured("b", 0.75e6, 6e4)}));
  CHECK(near.headline.find("6\u00a0\u00b1\u00a010\u00a0% below the baseline (p = 0.21: not told apart)") !=
        std::string::npos);
}

TEST_CASE("records that are too short rank nothing, and say how far to sail") {
  const auto short_run = [](const std::string& name, double mean, double ci95, double samples) {
    Evaluation e = measured(name, mean, ci95);
    e.wall_seconds = 600.0;
    e.result["simulation"] = {{"lambda", 25}};
    e.result["metrics"]["effective_samples"] = samples;
    e.result["metrics"]["full_scale"]["steady_from_m"] = 10.0;
    e.result["metrics"]["full_scale"]["steady_to_m"] = 35.0;
    return e;
  };
  StudyResults wide = study_of({short_run("a", 1e6, 1.2e6, 20.0), short_run("b", 2e6, 1e5, 20.0)});
  wide.wall_seconds = 1200.0;
  const Verdict words = verdict(wide);
  CHECK_FALSE(words.ranks);
  CHECK(words.headline ==
        "This study does not rank these bows: the 95\u00a0% interval of a is wider than its mean.");
  // A half width of 0.2 of the mean wants 36 times the 25 m: 10 + 900 m.
  CHECK(
      words.next ==
      "Sail 910\u00a0m instead of 35\u00a0m (operation.advance_m): about 8\u00a0h 40\u00a0min of computing.");
  const Verdict few = verdict(study_of({short_run("a", 1e6, 1e5, 4.0), short_run("b", 2e6, 1e5, 20.0)}));
  CHECK(few.headline ==
        "This study does not rank these bows: the record of a is worth 4 independent samples, and 10 "
        "are the least.");
  CHECK(few.next.find("Sail 75\u00a0m instead of 35\u00a0m") == 0);  // 10 / 4 times the steady part
}

TEST_CASE("of one design nothing is the lowest, and a short record leaves its load unknown") {
  CHECK(verdict(study_of({measured("a", 1e6, 4e4)})).headline ==
        "a is the only design with a rank: mean ice load 1.00\u00a0\u00b1\u00a00.04\u00a0MN.");
  Evaluation e = measured("a", 1e6, 2e6);
  e.result["simulation"] = {{"lambda", 25}};
  CHECK(says_in(verdict(study_of({e})).headline, "This study does not know the load of this bow: "));
}

TEST_CASE("equal numbers without sampling error are the same, however often they are evaluated") {
  const Verdict words = verdict(
      study_of({measured("baseline", 1e6, 4e4, 9e5), measured("b", 1e6, 4e4, 9e5)}, "lindqvist_breaking"));
  CHECK(says_in(words.headline, "0.900\u00a0MN; 1 other design has the same."));
  const StudyResults study =
      study_of({measured("baseline", 1e6, 4e4, 9e5), measured("b", 1e6, 4e4, 9e5)}, "lindqvist_breaking");
  CHECK(versus_in_words(study.ranking.rows[1], study) == "the same as the baseline");
}

TEST_CASE("numbers that are not positive are compared in their unit, not in percent") {
  std::vector<Evaluation> designs = {measured("baseline", 1e6, 4e4), measured("b", 1e6, 4e4)};
  designs[0].result["programs"] = {{"yard", {{"gain_N", -1e6}}}};
  designs[1].result["programs"] = {{"yard", {{"gain_N", -3e6}}}};
  const StudyResults study = study_of(designs, "/programs/yard/gain_N");
  CHECK(says_in(verdict(study).headline, "\u22123.000\u00a0MN, 2.000\u00a0MN below the baseline."));
  CHECK(says_in(verdict(study).next, "second evaluator"));            // nothing to repeat
  CHECK(load_in_words(1.2e-4, {"MN", 1e6, 3}) == "1.2e-10\u00a0MN");  // not "0.000 MN"
}

TEST_CASE("what the formula says of its own range stands among the remarks, once") {
  std::vector<Evaluation> designs = {measured("a", 1e6, 5e4), measured("b", 2e6, 5e4),
                                     measured("c", 3e6, 5e4)};
  for (const std::size_t i : {0u, 2u}) designs[i].result["lindqvist"]["caution"] = "not made for flat bows";
  const Verdict words = verdict(study_of(designs));
  CHECK(says(words, "Lindqvist's formula for a and c: Not made for flat bows."));
}

TEST_CASE("unlike ships or ices in one study are told") {
  std::vector<Evaluation> designs = {measured("a", 1e6, 5e4), measured("b", 2e6, 5e4)};
  for (std::size_t i = 0; i < 2; ++i) {
    designs[i].result["lindqvist"]["inputs"] = {
        {"B_m", 20.0 + static_cast<double>(i)}, {"h_m", 1.0 + static_cast<double>(i)}, {"sigma_f_Pa", 863e3}};
    designs[i].result["simulation"] = {{"nz", 3},
                                       {"ice", {{"flexural_strength_Pa", 5952e3}, {"model", "paper"}}}};
  }
  const StudyResults study = study_of(designs);
  CHECK(says(verdict(study),
             "The ranking compares unlike cases: Ice thickness is 1.00 to 2.00\u00a0m and Beam is 20.0 to "
             "21.0\u00a0m."));
  const Conditions found = conditions(study);
  CHECK(found.unlike_ices == "simulated in ice of 5952\u00a0kPa, the formula in ice of 863\u00a0kPa");
  CHECK(found.ice.find("5952\u00a0kPa in bending, by its toughness, as published, 3\u00a0layers") !=
        std::string::npos);
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
        "a is the only design with a rank: mean ice load per metre of beam "
        "50.0\u00a0\u00b1\u00a02.0\u00a0kN/m.");
  const Verdict formula = verdict(
      study_of({measured("a", 1e6, 4e4, 9.5e5), measured("b", 1e6, 4e4, 9.9e5)}, "lindqvist_breaking"));
  CHECK(formula.headline == "a has the lowest breaking resistance by Lindqvist's formula, 0.950\u00a0MN.");
}

TEST_CASE("of a race the headline claims no more than was decided") {
  StudyResults study =
      study_of({measured("a", 1.0e6, 4e4), measured("b", 1.02e6, 4e4), measured("c", 2e6, 4e4)});
  study.state = "finished";
  RaceRecord& race = study.ranking.race;
  race.best_within = 0.1, race.confidence = 0.95;
  race.state = RaceState::budget;
  race.legs = {{{{"a", 80.0}, {"b", 80.0}, {"c", 80.0}}, {"a", "b"}, "a", 0.12, 1.0}};
  CHECK(says_in(verdict(study).headline, "a leads with a mean ice load of 1.00"));
  CHECK(says_in(verdict(study).headline, "the race is not decided: 1 other design may be lower."));
  CHECK(says_in(verdict(study).next, "decide.budget_core_h"));
  CHECK(says(verdict(study), "Not decided: a leads, and is at most 12 % above"));
  race.state = RaceState::decided;
  CHECK(says_in(verdict(study).headline, "a has the lowest mean ice load within 10\u00a0%, 1.00"));
  race.legs.back().in = {"a"};
  CHECK(says_in(verdict(study).headline, "a has the lowest mean ice load, 1.00"));
}

TEST_CASE("a number of the study's own program is ranked in plain words, without a test of its error") {
  std::vector<Evaluation> designs = {measured("baseline", 1e6, 4e4), measured("b", 1e6, 4e4)};
  designs[0].result["programs"] = {{"yard", {{"ice_resistance_N", 4e6}}}};
  designs[1].result["programs"] = {{"yard", {{"ice_resistance_N", 3e6}}}};
  const Verdict words = verdict(study_of(designs, "/programs/yard/ice_resistance_N"));
  CHECK(words.headline ==
        "b has the lowest ice resistance by yard, 3.000\u00a0MN, 25\u00a0% below the baseline.");
  CHECK(words.next.find("lattice") == std::string::npos);
  CHECK(ranked_quantity("/lindqvist/total_N") == "total by lindqvist");
}

TEST_CASE("loads over scenarios say so, and do not pass the first one's ice for all") {
  std::vector<Evaluation> designs = {measured("a", 1e6, 4e4), measured("b", 2e6, 4e4)};
  designs[0].result["lindqvist"]["inputs"] = {{"h_m", 0.6}, {"sigma_f_Pa", 5e5}, {"B_m", 20.0}};
  StudyResults study = study_of(designs);
  study.document = {
      {"scenarios", {{{"name", "thin"}, {"weight", 0.7}}, {{"name", "thick"}, {"weight", 0.3}}}},
      {"ranking", {{"over_scenarios", "worst"}}}};
  CHECK(
      verdict(study).headline ==
      "a has the lowest mean ice load over 2 scenarios, by their worst, 1.00\u00a0\u00b1\u00a00.04\u00a0MN.");
  const Conditions found = conditions(study);
  CHECK(found.ice == "Loads over 2 scenarios, by their worst: thin (weight 0.7) and thick (weight 0.3).");
  for (const Fact& fact : found.shared) CHECK(fact.label != "Ice thickness");

  // A study file that can be read says which ice each of them is, and at what speed.
  study.document = Json::parse(R"({
    "icebow_study": 1, "name": "Two ices", "purpose": "Which bow is best in both?",
    "bow": {"family": "straight_parallel_buttocks", "length_m": 147.2, "beam_m": 23.0, "draft_m": 8.0,
            "depth_m": 13.5, "bow_length_m": 32.5, "stem_deg": 24.35, "waterline_deg": 22.0, "buttock_deg": 28.0,
            "flare_deg": 33.0},
    "ice": {"thickness_m": 1.0, "flexural_strength_kPa": 500}, "operation": {"speed_kn": 4.0},
    "evaluators": ["lindqvist", "cycle"],
    "scenarios": [{"name": "thin", "weight": 0.7, "set": {"ice": {"thickness_m": 0.6}}},
                  {"name": "thick", "weight": 0.3, "set": {"operation": {"speed_kn": 2}}}],
    "ranking": {"by": "cycle_load", "over_scenarios": "worst"}})");
  CHECK(
      conditions(study).ice ==
      "Loads over 2 scenarios, by their worst: thin (0.60\u00a0m of 500\u00a0kPa at 4.0\u00a0kn, weight 0.7) "
      "and thick (1.00\u00a0m of 500\u00a0kPa at 2.0\u00a0kn, weight 0.3).");
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
