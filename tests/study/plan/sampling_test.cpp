#include "study/plan/sampling.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

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
