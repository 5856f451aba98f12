// Searching a box for the point of the smallest value, with the algorithms of NLopt. Knows nothing of ships.
//
// Deterministic: the same answers lead through the same points, bit by bit, so a search that was cut short is
// resumed by running it again with its first answers read back.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace icebow {

struct OptimiserOptions {
  std::string algorithm = "cobyla";  // see optimiser_names()
  std::uint64_t seed = 1;
  int max_evaluations = 60;  // `value` is never called more often
  double tolerance = 0.01;   // stop when every variable moves less than this part of its range; 0 = never
};

struct OptimiserProblem {
  std::vector<double> lower, upper;  // lower < upper
  std::vector<double> start;         // clipped to the bounds

  // The value of a point within the bounds. Not finite = the point is infeasible or could not be evaluated;
  // the search then sees the worst value so far plus a margin. May throw: the search ends at once and the
  // exception comes out.
  std::function<double(const std::vector<double>&)> value;

  // Optional: margins g, of the same number at every point, all >= 0 where the point is feasible. Constraints
  // for the algorithms that take some ("cobyla", "isres"). For all: an infeasible point is answered with the
  // value on the margin, on the way to the first feasible point, and a slope that leads back; `value` is then
  // asked there. Before there is a feasible point, what the margins lack grades the penalty.
  std::function<std::vector<double>(const std::vector<double>&)> margins;

  // Optional: `limits` margins that are known only once the point has a value; asked after `value` at the
  // same point, >= 0 where the limit is kept, of order one. Constraints for the algorithms that take some;
  // the others see the value raised by what is missing. Where a limit is broken the value is that of the
  // point all the same.
  int limits = 0;
  std::function<std::vector<double>(const std::vector<double>&)> limit_margins = nullptr;
};

struct OptimiserResult {
  std::vector<double>
      best;             // of the feasible points that keep the limits; empty where none had a finite value
  double value = 0.0;   // there
  int evaluations = 0;  // calls of `value`
  std::string reason;   // why the search ended, in words
};

// Throws InputError for an unknown algorithm, or one that cannot search so few variables.
OptimiserResult optimise(const OptimiserProblem& problem, const OptimiserOptions& options);

const std::vector<std::string>& optimiser_names();

}  // namespace icebow
