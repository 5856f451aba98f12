#include "study/plan/front_search.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

namespace icebow {
namespace {

using Point = std::vector<double>;

// Schaffer's problem with a second variable that is best at 0 for both: the front is x in 0 ... 2, y = 0,
// where sqrt(f) + sqrt(g) = 2.
double f(const Point& p) {
  return p[0] * p[0] + p[1] * p[1];
}
double g(const Point& p) {
  return (p[0] - 2.0) * (p[0] - 2.0) + p[1] * p[1];
}

struct Tried {
  double first, second;
};

struct Searched {
  std::vector<Tried> points;
  OptimiserResult result;
};

Searched searched(const std::string& algorithm, int evaluations) {
  Searched s;
  const OptimiserProblem problem = {{-4, -4},
                                    {4, 4},
                                    {3, 3},
                                    [&](const Point& p) {
                                      return s.points.push_back({f(p), g(p)}), f(p);
                                    },
                                    nullptr};
  s.result = search_front(problem, g, {algorithm, 1, evaluations, 1e-3});
  return s;
}

// How far the tried points leave the front uncovered: over nine places of the front, the largest distance in
// sqrt(f) and sqrt(g), which are 0 ... 2 along it.
double uncovered(const std::vector<Tried>& points) {
  double worst = 0.0;
  for (int k = 0; k <= 8; ++k) {
    double nearest = std::numeric_limits<double>::infinity();
    for (const Tried& t : points)
      nearest =
          std::min(nearest, std::hypot(std::sqrt(t.first) - 0.25 * k, std::sqrt(t.second) - 2.0 + 0.25 * k));
    worst = std::max(worst, nearest);
  }
  return worst;
}

}  // namespace

TEST_CASE("the front between two values is found along its whole length, within the budget") {
  for (const char* algorithm : {"cobyla", "sbplx"}) {
    CAPTURE(algorithm);
    const Searched s = searched(algorithm, 200);
    CHECK(s.result.evaluations == static_cast<int>(s.points.size()));
    CHECK(s.result.evaluations <= 200);
    // The bounds leave 2 / 7 of the front between neighbours; no point further off than that.
    CHECK(uncovered(s.points) < 0.29);
  }
}

TEST_CASE("the same answers lead along the same front") {
  const Searched a = searched("cobyla", 90), b = searched("cobyla", 90);
  REQUIRE(a.points.size() == b.points.size());
  for (std::size_t i = 0; i < a.points.size(); ++i) CHECK(a.points[i].first == b.points[i].first);
}

TEST_CASE("two objectives that agree have no front, and one that is never known is told") {
  const OptimiserProblem problem = {{-4, -4}, {4, 4}, {3, 3}, f, nullptr};
  const OptimiserResult same = search_front(problem, f, {"cobyla", 1, 60, 1e-3});
  CHECK_THAT(same.reason, Catch::Contains("there is no front"));
  const OptimiserProblem nowhere = {{-4, -4},
                                    {4, 4},
                                    {3, 3},
                                    [](const Point&) { return std::numeric_limits<double>::quiet_NaN(); },
                                    nullptr};
  CHECK_THAT(search_front(nowhere, g, {"cobyla", 1, 60, 1e-3}).reason, Catch::Contains("no point"));
}

TEST_CASE("a limit that only a value tells is kept, and the best point lies on it") {
  // Smallest f with g <= 1: x = 1, y = 0, f = 1.
  for (const char* algorithm : {"cobyla", "sbplx", "neldermead", "bobyqa", "isres"}) {
    CAPTURE(algorithm);
    OptimiserProblem problem = {{-4, -4}, {4, 4}, {3, 1}, f, nullptr};
    problem.limits = 1;
    problem.limit_margins = [](const Point& p) { return Point{1.0 - g(p)}; };
    const bool global = algorithm == std::string("isres");
    const OptimiserResult result = optimise(problem, {algorithm, 1, global ? 600 : 120, 1e-4});
    REQUIRE_FALSE(result.best.empty());
    CHECK(g(result.best) <= 1.0);
    CHECK(result.value <
          (global ? 1.6 : 1.1));  // the start is worth 10; a tenth is what a penalty's kink leaves
  }
}

}  // namespace icebow
