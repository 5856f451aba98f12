#include "study/learn/first_points.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "study/plan/sampling.h"

namespace icebow {
namespace {

using Point = std::vector<double>;
using Points = std::vector<Point>;

constexpr int candidates = 256;
constexpr double too_near = 0.05;  // to a known point: it would tell the same again

double nearest(const Point& point, const Points& others) {
  double least = std::numeric_limits<double>::infinity();
  for (const Point& other : others) least = std::min(least, distance(point, other));
  return least;
}

}  // namespace

double distance(const Point& a, const Point& b) {
  double sum = 0.0;
  for (std::size_t k = 0; k < a.size(); ++k) sum += (a[k] - b[k]) * (a[k] - b[k]);
  return std::sqrt(sum);
}

Points turned_sequence(int dimension, int n, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  Point turn(static_cast<std::size_t>(dimension));
  for (double& t : turn) t = static_cast<double>(random() >> 11) * 0x1p-53;
  Points points = sequence(Sequence::sobol, dimension, n);
  for (Point& point : points)
    for (std::size_t k = 0; k < point.size(); ++k) point[k] = std::fmod(point[k] + turn[k], 1.0);
  return points;
}

Points first_points(int dimension, int n, std::uint64_t seed, const Points& known,
                    const std::function<bool(const Point&)>& feasible) {
  Points taken = known, points;
  const auto take = [&](const Point& point) { taken.push_back(point), points.push_back(point); };
  if (n <= 0) return points;
  for (const Point& point : latin_hypercube(dimension, n, seed))
    if (feasible(point) && nearest(point, taken) > too_near) take(point);
  Points others;
  if (points.size() < static_cast<std::size_t>(n))
    for (Point& point : turned_sequence(dimension, candidates, seed))
      if (feasible(point)) others.push_back(std::move(point));
  while (points.size() < static_cast<std::size_t>(n) && !others.empty()) {
    const auto farthest = std::max_element(others.begin(), others.end(), [&](const Point& a, const Point& b) {
      return nearest(a, taken) < nearest(b, taken);
    });
    take(*farthest);
    others.erase(farthest);
  }
  return points;
}

}  // namespace icebow
