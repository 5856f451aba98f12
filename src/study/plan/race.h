// A race: which of several bows has the lowest load, by voyages that are sailed on until the answer is sure.
//
// After each leg every pair is compared by Welch's test, one-sided. A bow that is surely worse than another
// one is out. The race is decided where the bow that leads is surely at most `best_within` of its load above
// each that is left. What is not yet sure is sailed on.
//
// Proof of the error. Let i be the bow that truly is the best. Every wrong answer needs that, in some leg k,
// the measured difference between i and one of the n - 1 others lies farther from the true one than the
// one-sided bound of level a_k / (n - 1) allows, to the disadvantage of i: i goes out only so, and the race
// ends with a bow that is worse by more than best_within only so. The sum over the others and the legs is at
// most sum a_k = 1 - confidence, with a_k = (1 - confidence) / (k (k + 1)), however many legs there are
// (Bonferroni). best_within is counted on the leader's measured load.
//
// The proof takes each load for the mean of one process. The mean of a record that drifts is none, so its
// error counts as not known: the bow neither wins nor puts out another one, and is sailed on. This can only
// keep a race open.
#pragma once

#include <cstddef>
#include <vector>

#include "solver/model/drift.h"
#include "solver/model/mean_difference.h"

namespace icebow {

struct RaceRule {
  double best_within = 0.05;  // of the leader's load
  double confidence = 0.95;
};

struct RaceStanding {
  std::size_t leader = 0;        // has the lowest mean of those in
  std::vector<bool> in;          // may be the best
  std::vector<bool> sail_on;     // its error keeps the race open
  double most_above_best = 0.0;  // of the leader's load: the leader is not farther above the best; may be inf
  bool decided = false;
};

// What a record counts for in the race: its error is not known where it drifts.
MeanEstimate load_in_race(MeanEstimate load, const Drift& drift);

// After leg `leg` (1, 2 ...). `in` says which designs were in before it: all of them in the first leg. At
// least one must be in. A design that is out stays out, but counts among the designs compared.
RaceStanding standing(const std::vector<MeanEstimate>& loads, const std::vector<bool>& in, int leg,
                      const RaceRule& rule);

// How far the next leg goes: what is counted grows by half.
double next_leg(double counted_from, double sailed_to);

}  // namespace icebow
