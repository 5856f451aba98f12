// Searching a box for the point of the smallest noisy value, each point chosen by all that was learnt before:
// a Gaussian process (gaussian_process.h) says where one more evaluation is expected to gain most. Knows
// nothing of ships.
//
// The gain of a point x is the logarithm of
//   E[max(T - m(x) - S(x) U, 0)] (1 - t / sqrt(S(x)^2 + t^2)) prod_j P[h_j(x) >= 0]              (1)
// the augmented expected improvement [Huang2006] under constraints [Schonlau1998], with U ~ N(0, 1), t^2 the
// noise of one value and T = m(x*) at the evaluated feasible point x* of the smallest m + S; each constraint
// h_j has a process of its own. Before there is a feasible point only the product counts. Margins that are
// known in closed form bound the box exactly. A batch is chosen one point after the other, each believed to
// turn out as expected [Ginsbourger2010]. Compared with others in docs/study_engine.md.
//
// Deterministic: the same answers lead through the same points.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace icebow {

struct LearningOptions {
  std::uint64_t seed = 1;
  int max_evaluations = 60;   // points asked for, at most
  int initial = 0;            // of them to begin with; 0 = 2 (variables + 1)
  int batch = 1;              // points asked for at once after that
  double least_gain = 0.001;  // ends where two rounds expect less than this part of the best value; 0 = never
};

// What one point has come to.
struct Answer {
  double value = 0.0;     // not finite: none
  double variance = 0.0;  // of its noise; not finite: not known
  bool exact = false;     // neither noise nor anything else that a smooth function has not
  bool feasible = true;
  std::vector<double> reserves;  // of constraints, 0 or more where they are kept, in their own units; not
                                 // finite: not known. As many at each point
};

// One choice, as it can be kept and given back: what led to it is known by `state`.
struct LearningRound {
  std::string state;                        // SHA-256 of options, box and answers
  std::vector<std::vector<double>> points;  // in the unit cube
  double gain = 0.0;  // (1) of the first, in the value's unit; NaN: of the initial design
  std::vector<std::vector<double>> parameters;  // of the processes, from which the next fit starts
};

struct LearningProblem {
  std::vector<double> lower, upper;  // lower < upper
  std::vector<double> start;         // clipped to the box; asked first. Empty: none
  // In the problem's units, as long as the points: answers to all of them, which may be evaluated side by
  // side. May throw: the exception comes out.
  std::function<std::vector<Answer>(const std::vector<std::vector<double>>&)> ask;
  // Optional: margins, all >= 0 where the point is feasible. No other point is asked for.
  std::function<std::vector<double>(const std::vector<double>&)> margins;
  // Optional: a cheaper response, finite everywhere; a multiple of it is part of the mean.
  std::function<double(const std::vector<double>&)> prior;
  // What was evaluated before the search, for nothing.
  std::vector<std::vector<double>> known;
  std::vector<Answer> known_answers;
  // Optional: choices kept by an earlier run of the same search.
  std::function<std::optional<LearningRound>(const std::string& state)> remembered;
  std::function<void(const LearningRound&)> remember;
};

struct LearningResult {
  std::vector<double>
      best;  // of the evaluated feasible points that of the smallest m + S; empty where there is none
  double value = 0.0;           // m there
  double sd = 0.0;              // S there
  int evaluations = 0;          // points asked for
  int initial = 0;              // of them in the initial design
  int known = 0;                // values it began with
  std::string reason;           // why the search ended, in words
  double gain = 0.0;            // expected of one more point, the last time it was asked; NaN: never
  double left_out_error = 0.0;  // root mean square error of values predicted from the others; NaN: no model
  double noise_sd = 0.0;        // of one value; NaN: no model
  double prior_factor = 0.0;    // of `prior` in the mean; NaN where there is none, or it does not help
};

LearningResult search_by_learning(const LearningProblem& problem, const LearningOptions& options);

}  // namespace icebow
