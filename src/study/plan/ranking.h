// Designs in order of merit, ties marked.
#pragma once

#include <limits>
#include <string>
#include <vector>

#include "solver/model/mean_difference.h"
#include "study/evaluate/evaluation.h"
#include "study/plan/confirmation.h"
#include "study/plan/pareto.h"
#include "study/plan/race_record.h"
#include "study/spec/study_spec.h"

namespace icebow {

struct RankedDesign {
  Evaluation evaluation;        // of repeated runs the first one that is ok, by the design's name
  int runs = 1;                 // that the numbers below are of: those that are ok
  int rank = 0;                 // 1 = best; 0 = not ranked (infeasible, failed, running)
  bool tied_with_next = false;  // Welch's test does not tell it from the next design
  bool tied_with_best = false;  // nor, here, from the best one
  double value = std::numeric_limits<double>::quiet_NaN();  // what was ranked (smaller is better), full scale
  double mean_load = std::numeric_limits<double>::quiet_NaN();  //!< of the runs' means, full scale [N]
  // Half width of its 95 % interval: by the scatter of repeated runs, of one run by its series; full scale
  // [N]. The other two are both of these, NaN where there are none.
  double mean_load_ci95 = std::numeric_limits<double>::quiet_NaN();
  double ci95_series = std::numeric_limits<double>::quiet_NaN();
  double ci95_repeats = std::numeric_limits<double>::quiet_NaN();
  // By the breaking cycle [N]. Where designs were confirmed, mean_load is this times the ratio of simulation
  // and cycle, its interval with both errors, and solver_load what was simulated (NaN: not).
  double cycle_load = std::numeric_limits<double>::quiet_NaN(), cycle_ci95 = cycle_load;
  double difference_ci95 =
      std::numeric_limits<double>::quiet_NaN();  // where corrected: by which ties are told
  double solver_load = std::numeric_limits<double>::quiet_NaN(), solver_ci95 = solver_load;
  // By the cycle over the way that the simulation counted [N]; NaN: not known.
  double same_way_load = std::numeric_limits<double>::quiet_NaN(), same_way_ci95 = same_way_load;
  double lindqvist_breaking = std::numeric_limits<double>::quiet_NaN();  //!< [N]
  // What the mean load is compared with: Lindqvist's total where the simulated load is a whole one (ice with
  // weight and lift), his breaking part where it is of breaking alone or nothing was simulated [N]
  double lindqvist = std::numeric_limits<double>::quiet_NaN();
  bool whole_load = false;
  double ratio = std::numeric_limits<double>::quiet_NaN();  // mean load / `lindqvist`
  // Of a study with two objectives: the second one as the results have it, the half width of its 95 %
  // interval (0: exact; NaN: not known), and the place among all designs.
  double second = std::numeric_limits<double>::quiet_NaN(), second_ci95 = second;
  FrontPlace front = FrontPlace::none;
};

struct Ranking {
  std::string rank_by;
  SecondObjective objective;       // the second one, where there is one
  std::vector<RankedDesign> rows;  // ranked first, then infeasible, then failed, then running
  double spearman =
      std::numeric_limits<double>::quiet_NaN();  // of mean load and Lindqvist over the ranked designs
  int spearman_n = 0;
  // Of a study that confirms designs by the simulation: `designs` is 0 where it has not, or not yet.
  RatioFit confirmed;
  std::vector<std::string> disagreements;  // of simulation and cycle; sentences
  // Where differences between designs are smaller than their intervals or the resolution bias; sentences.
  std::vector<std::string> warnings;
  RaceRecord race;  // of a study that decides; else none
};

// What a study ranks by: "mean_load" [N], "mean_load_per_beam" [N/m], "cycle_load" [N],
// "lindqvist_breaking" [N], all full scale. NaN where the evaluation is not ok or has no such number. Throws
// InputError for another word.
double ranking_value(const Evaluation& evaluation, const std::string& rank_by);

// What the ranked value is worth for Welch's test (solver/model/mean_difference.h): its standard error by the
// runs' scatter, by the fit of a study that confirms designs, or by the independent samples of its series. A
// formula's value is exact; where a result does not say how many samples, its interval is taken for that of
// many.
MeanEstimate value_estimate(const RankedDesign& row, const std::string& rank_by);

// Evaluations of one design's repeats (study/plan/repeats.h) make one row. An evaluation that is ok but has
// no number to rank by is listed with the failed ones, with the reason. Designs are ranked by the first
// objective; a second one gives them their place at the Pareto front.
Ranking rank_designs(const std::vector<Evaluation>& evaluations, const std::string& rank_by,
                     const SecondObjective& second = {});

// Names of the ranked designs with that place, best first.
std::vector<std::string> names_at(const Ranking& ranking, FrontPlace place);

// The front in a sentence, and what may belong to it as well; empty where there is one objective.
std::string front_in_words(const Ranking& ranking);

// The designs that a study's "confirm" asks to simulate, by the cycle's loads of its evaluations.
std::vector<std::string> designs_to_confirm(const std::vector<Evaluation>& evaluations,
                                            const StudySpec& spec);

// The design that leads its race, else the first of those ranked; none where none is ranked. The leader's
// mean may be above that of a design that an earlier leg has put out.
const RankedDesign* best_of(const Ranking& ranking);

// "total", "breaking", or "total or breaking" where designs differ: of `lindqvist` over the ranked designs.
std::string compared_part(const Ranking& ranking);

// Full-scale values in N; the keys of `icebow rank --json`: design, status, reason, parameters, mean_load_N,
// mean_load_ci95_N, runs, ci95_series_N, ci95_repeats_N, lindqvist_breaking_N, lindqvist_N and lindqvist_part
// (what ratio compares with), ratio, rank, tied_with_next, tied_with_best; "race" (null where there was
// none) and "warnings"; with two objectives "second" {"by", "best"}, and of each design "second",
// "second_ci95" and "front". NaN becomes null.
Json to_json(const Ranking& ranking);

}  // namespace icebow
