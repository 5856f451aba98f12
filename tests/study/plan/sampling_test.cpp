#include "study/plan/sampling.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <random>

using namespace icebow;

namespace {

double smallest_distance(const std::vector<std::vector<double>>& points) {
  double smallest = 1e9;
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      double square = 0.0;
      for (std::size_t k = 0; k < points[i].size(); ++k) square += std::pow(points[i][k] - points[j][k], 2);
      smallest = std::min(smallest, std::sqrt(square));
    }
  }
  return smallest;
}

}  // namespace

TEST_CASE("full factorial: every combination, the last axis fastest") {
  const auto points = full_factorial({{1, 2}, {5, 6, 7}});
  CHECK(points == std::vector<std::vector<double>>{{1, 5}, {1, 6}, {1, 7}, {2, 5}, {2, 6}, {2, 7}});
}

TEST_CASE("equally spaced levels meet their ends") {
  CHECK(equally_spaced(0.1, 0.7, 3).back() == 0.7);
  CHECK(equally_spaced(0.1, 0.7, 3).front() == 0.1);
  CHECK(equally_spaced(10, 20, 3)[1] == 15);
  CHECK(equally_spaced(10, 20, 1) == std::vector<double>{10});
}

TEST_CASE("a Latin hypercube has one point in every interval of every axis") {
  const int n = 12, dimension = 3;
  const auto points = latin_hypercube(dimension, n, 7);
  REQUIRE(points.size() == n);
  for (int k = 0; k < dimension; ++k) {
    std::vector<int> hits(n, 0);
    for (const auto& point : points) ++hits.at(static_cast<int>(point[k] * n));
    CHECK(std::count(hits.begin(), hits.end(), 1) == n);
  }
}

TEST_CASE("a Latin hypercube is its seed's") {
  CHECK(latin_hypercube(4, 10, 3) == latin_hypercube(4, 10, 3));
  CHECK(latin_hypercube(4, 10, 3) != latin_hypercube(4, 10, 4));
  CHECK(latin_hypercube(2, 1, 3).size() == 1);
  CHECK(latin_hypercube(1, 5, 3).size() == 5);
}

// Without the optimisation the smallest distance of 20 points in the unit square is about 0.05 on average.
TEST_CASE("a Latin hypercube keeps its points apart") {
  double sum = 0.0;
  for (int seed = 1; seed <= 5; ++seed) sum += smallest_distance(latin_hypercube(2, 20, seed)) / 5;
  CHECK(sum > 0.1);
}

namespace {

bool is_latin(const std::vector<std::vector<double>>& points) {
  const auto n = points.size();
  for (std::size_t axis = 0; axis < points[0].size(); ++axis) {
    std::vector<int> hits(n, 0);
    for (const auto& point : points)
      ++hits.at(static_cast<std::size_t>(point[axis] * static_cast<double>(n)));
    if (std::count(hits.begin(), hits.end(), 1) != static_cast<std::ptrdiff_t>(n)) return false;
  }
  return true;
}

// Centred L2 discrepancy, squared (Hickernell 1998).
double discrepancy(const std::vector<std::vector<double>>& points) {
  const double n = static_cast<double>(points.size());
  double single = 0.0, pairs = 0.0;
  for (const auto& x : points) {
    double product = 1.0;
    for (const double u : x) {
      const double a = std::fabs(u - 0.5);
      product *= 1.0 + 0.5 * a - 0.5 * a * a;
    }
    single += product;
    for (const auto& y : points) {
      product = 1.0;
      for (std::size_t k = 0; k < x.size(); ++k)
        product *=
            1.0 + 0.5 * std::fabs(x[k] - 0.5) + 0.5 * std::fabs(y[k] - 0.5) - 0.5 * std::fabs(x[k] - y[k]);
      pairs += product;
    }
  }
  return std::pow(13.0 / 12.0, static_cast<double>(points[0].size())) - 2.0 / n * single + pairs / n / n;
}

}  // namespace

TEST_CASE("100,000 points are a Latin hypercube, in the time of their number") {
  const auto points = latin_hypercube(4, 100000, 1);  // hours by annealing
  CHECK(points.size() == 100000);
  CHECK(is_latin(points));
}

TEST_CASE("many points of a hypercube are spread more evenly than at random") {
  const auto points = latin_hypercube(3, 300, 2);
  CHECK(is_latin(points));
  CHECK(points == latin_hypercube(3, 300, 2));
  CHECK(points != latin_hypercube(3, 300, 3));
  // Its axes permuted: another Latin hypercube, at random. By far: Sobol' points have a quarter of it.
  auto shuffled = points;
  std::mt19937 random(1);
  for (std::size_t axis = 0; axis < 3; ++axis)
    for (std::size_t i = shuffled.size() - 1; i > 0; --i)
      std::swap(shuffled[i][axis], shuffled[random() % (i + 1)][axis]);
  CHECK(is_latin(shuffled));
  CHECK(discrepancy(points) < 0.5 * discrepancy(shuffled));
}

TEST_CASE("an augmented hypercube begins with what was paid for and is Latin where that can be") {
  const auto three = latin_hypercube(3, 3, 5);
  const auto six = augmented_hypercube(three, 6, 5), twelve = augmented_hypercube(six, 12, 5);
  REQUIRE(six.size() == 6);
  REQUIRE(twelve.size() == 12);
  CHECK(std::equal(three.begin(), three.end(), six.begin()));
  CHECK(std::equal(six.begin(), six.end(), twelve.begin()));
  CHECK(is_latin(six));     // each point of three lies in an interval of its own of six
  CHECK(is_latin(twelve));  // and so on with each doubling
  CHECK(augmented_hypercube(three, 3, 5) == three);
  const auto seven = augmented_hypercube(three, 7, 5);
  for (std::size_t axis = 0; axis < 3; ++axis)
    for (std::size_t i = 3; i < 7; ++i)
      for (std::size_t j = 0; j < i; ++j)
        CHECK(std::floor(seven[i][axis] * 7) != std::floor(seven[j][axis] * 7));
  CHECK(augmented_hypercube(latin_hypercube(4, 1000, 1), 2000, 1).size() == 2000);
}

TEST_CASE("sequences begin with their shorter ones; the plane's first Halton points are known") {
  for (const Sequence kind : {Sequence::sobol, Sequence::halton}) {
    const auto four = sequence(kind, 2, 4), eight = sequence(kind, 2, 8);
    CHECK(std::equal(four.begin(), four.end(), eight.begin()));
    CHECK(eight[0] != eight[1]);
  }
  const auto halton = sequence(Sequence::halton, 2, 2);  // bases 2 and 3
  CHECK(halton[0][0] == Approx(0.5));
  CHECK(halton[0][1] == Approx(1.0 / 3.0));
  CHECK(halton[1][0] == Approx(0.25));
  CHECK(halton[1][1] == Approx(2.0 / 3.0));
}

TEST_CASE("central composite and Box-Behnken designs are the textbook's") {
  const auto composite = central_composite(3);
  CHECK(composite.size() == 1 + 6 + 8);
  CHECK(composite[0] == std::vector<double>{0.5, 0.5, 0.5});
  CHECK(std::count(composite.begin(), composite.end(), std::vector<double>{1, 0.5, 0.5}) == 1);
  CHECK(std::count(composite.begin(), composite.end(), std::vector<double>{1, 0, 1}) == 1);
  const auto behnken = box_behnken(3);
  CHECK(behnken.size() == 13);
  for (std::size_t i = 1; i < behnken.size(); ++i)
    CHECK(std::count(behnken[i].begin(), behnken[i].end(), 0.5) == 1);
}

TEST_CASE("a trajectory of Morris changes every axis once, by two thirds, and stays on four levels") {
  const auto points = morris(3, 20, 7);
  REQUIRE(points.size() == 80);
  CHECK(points == morris(3, 20, 7));
  CHECK(points != morris(3, 20, 8));
  for (std::size_t t = 0; t < 20; ++t) {
    std::vector<int> changed(3, 0);
    for (std::size_t step = 0; step < 3; ++step)
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const double from = points[4 * t + step][axis], to = points[4 * t + step + 1][axis];
        CHECK(std::fabs(3.0 * to - std::round(3.0 * to)) < 1e-12);  // rounding of thirds
        CHECK((to >= 0.0 && to <= 1.0));
        if (from == to) continue;
        ++changed[axis];
        CHECK(std::fabs(to - from) == Approx(2.0 / 3.0));
      }
    CHECK(changed == std::vector<int>{1, 1, 1});
  }
}
