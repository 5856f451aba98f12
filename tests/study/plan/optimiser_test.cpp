#include "study/plan/optimiser.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

#include "base/errors.h"
#include "study/spec/spec_method.h"

using namespace icebow;

namespace {

using Point = std::vector<double>;

double smooth(const Point& x) {
  return 3.0 + std::pow(x[0] - 20.0, 2) + 4.0 * std::pow(x[1] - 31.0, 2);
}

OptimiserProblem problem_of(std::function<double(const Point&)> value) {
  return {{10, 20}, {40, 60}, {35, 55}, std::move(value), nullptr};
}

OptimiserOptions options_of(const std::string& algorithm, int evaluations) {
  return {algorithm, 5, evaluations, 1e-5};
}

}  // namespace

TEST_CASE("the reader knows the same optimisers") {
  std::vector<std::string> known;
  for (const auto& a : algorithms())
    if (a.name != std::string(learning_algorithm)) known.push_back(a.name);  // beside NLopt's
  auto names = optimiser_names();
  std::sort(known.begin(), known.end());
  std::sort(names.begin(), names.end());
  CHECK(names == known);
}

TEST_CASE("every optimiser stays within its bounds and its budget, and improves") {
  for (const std::string& name : optimiser_names()) {
    CAPTURE(name);
    int calls = 0;
    bool inside = true;
    auto problem = problem_of([&](const Point& x) {
      ++calls;
      inside = inside && x[0] >= 10 && x[0] <= 40 && x[1] >= 20 && x[1] <= 60;
      return smooth(x);
    });
    const OptimiserResult result = optimise(problem, options_of(name, 83));
    CHECK(inside);
    CHECK(calls <= 83);
    CHECK(calls == result.evaluations);
    CHECK(result.value < smooth(problem.start) / 4);
    CHECK(result.value == smooth(result.best));
  }
}

TEST_CASE("the budget is met exactly where nothing else stops the search") {
  for (const std::string& name : optimiser_names()) {
    CAPTURE(name);
    OptimiserOptions options = options_of(name, 37);
    options.tolerance = 0.0;
    const OptimiserResult result = optimise(problem_of(smooth), options);
    CHECK(result.evaluations == 37);
    CHECK(result.reason == "the allowed number of evaluations was used");
  }
}

TEST_CASE("sbplx finds the optimum of a smooth problem") {
  const OptimiserResult result = optimise(problem_of(smooth), options_of("sbplx", 200));
  CHECK(result.best[0] == Approx(20).margin(0.01));  // degrees; found 5e-5 after 200 points
  CHECK(result.best[1] == Approx(31).margin(0.01));  // likewise
}

TEST_CASE("the same answers lead through the same points") {
  for (const std::string& name : optimiser_names()) {
    CAPTURE(name);
    std::vector<Point> first, second;
    optimise(problem_of([&](const Point& x) { return first.push_back(x), smooth(x); }), options_of(name, 60));
    optimise(problem_of([&](const Point& x) { return second.push_back(x), smooth(x); }),
             options_of(name, 60));
    CHECK(first == second);
  }
}

TEST_CASE("no optimiser hangs or prefers points that have no value") {
  for (const std::string& name : optimiser_names()) {
    CAPTURE(name);
    auto problem = problem_of([](const Point& x) {
      if (x[0] < 22.0) return std::numeric_limits<double>::quiet_NaN();
      if (x[1] > 50.0) return -std::numeric_limits<double>::infinity();
      return smooth(x);
    });
    problem.start = {35, 48};  // without margins nothing leads a local search back from a plateau
    const OptimiserResult result = optimise(problem, options_of(name, 80));
    REQUIRE_FALSE(result.best.empty());
    CHECK(result.best[0] >= 22.0);
    CHECK(std::isfinite(result.value));
  }
  const auto hopeless = problem_of([](const Point&) { return std::numeric_limits<double>::quiet_NaN(); });
  CHECK(optimise(hopeless, options_of("sbplx", 20)).best.empty());
}

TEST_CASE("cobyla keeps to margins, and a value beyond them is never the best") {
  // Nearest to (20, 31) with x0 + x1 >= 60: Lagrange gives x0 = 20 + 4 k, x1 = 31 + k, 51 + 5 k = 60.
  for (const std::string name : {"cobyla", "sbplx"}) {
    auto problem = problem_of(smooth);
    problem.start = {38, 58};
    problem.margins = [](const Point& x) { return Point{x[0] + x[1] - 60.0}; };
    const OptimiserResult result = optimise(problem, options_of(name, 250));
    CAPTURE(name);
    REQUIRE_FALSE(result.best.empty());
    CHECK(result.best[0] + result.best[1] >= 60.0);
    if (name != "cobyla") continue;
    CHECK(result.best[0] == Approx(27.2).margin(0.01));  // degrees; found 1e-4, where it stopped
    CHECK(result.best[1] == Approx(32.8).margin(0.01));  // likewise
  }
}

TEST_CASE("an exception of the objective comes out as it was, at once") {
  for (const std::string& name : optimiser_names()) {
    CAPTURE(name);
    int calls = 0;
    const auto problem = problem_of([&](const Point& x) {
      if (++calls == 9) throw RuntimeError("the disk is full");
      return smooth(x);
    });
    CHECK_THROWS_WITH(optimise(problem, options_of(name, 80)), "the disk is full");
    CHECK(calls == 9);
  }
}

TEST_CASE("what cannot be searched is said") {
  CHECK_THROWS_AS(optimise(problem_of(smooth), options_of("gradient descent", 10)), InputError);
  const OptimiserProblem one = {{0}, {1}, {0.5}, [](const Point& x) { return x[0]; }, nullptr};
  CHECK_THROWS_AS(optimise(one, options_of("bobyqa", 10)), InputError);
  CHECK(optimise(one, options_of("sbplx", 60)).best[0] < 0.01);
}

TEST_CASE("local algorithms find an optimum on a margin, and ask for no value beyond it") {
  // As above: 67.8 at (27.2, 32.8). The start is worth 3243; 5 % are what 120 points leave a simplex.
  for (const std::string name : {"cobyla", "sbplx", "bobyqa", "neldermead"}) {
    CAPTURE(name);
    auto problem = problem_of(smooth);
    int outside = 0;
    problem.value = [&](const Point& x) { return outside += x[0] + x[1] < 60.0, smooth(x); };
    problem.start = {38, 58};
    problem.margins = [](const Point& x) { return Point{x[0] + x[1] - 60.0}; };
    const OptimiserResult result = optimise(problem, options_of(name, 120));
    CHECK(outside == 0);
    CHECK(result.value < 1.05 * 67.8);
  }
}

TEST_CASE("by default an optimum on a margin is met") {
  auto problem = problem_of(smooth);
  problem.start = {38, 58};
  problem.margins = [](const Point& x) { return Point{x[0] + x[1] - 60.0}; };
  OptimiserOptions options;
  options.max_evaluations = 60, options.tolerance = 1e-4;
  const OptimiserResult result = optimise(problem, options);
  // 3 + 7.2^2 + 4 x 1.8^2 at (27.2, 32.8); a tenth of what lies between it and the start is far.
  CHECK(result.value == Approx(67.8).epsilon(1e-4));  // the tolerance asked for
}
