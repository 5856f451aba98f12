#include "study/plan/sampling.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <random>

namespace icebow {
namespace {

using Point = std::vector<double>;
using Points = std::vector<Point>;

constexpr double most_distances = 2e7;  // to compute for one augmentation: a fraction of a second
constexpr int most_fillings = 200;

// The same on every machine, as the library's distributions are not.
double between_0_and_1(std::mt19937_64& random) {
  return static_cast<double>(random() >> 11) * 0x1p-53;
}

void shuffle(std::vector<std::size_t>& list, std::mt19937_64& random) {
  for (std::size_t k = list.size(); k > 1; --k)
    std::swap(list[k - 1], list[static_cast<std::size_t>(between_0_and_1(random) * static_cast<double>(k))]);
}

// Which of the n equal intervals of an axis hold none of the points.
std::vector<std::size_t> empty_intervals(const Points& points, std::size_t axis, std::size_t n) {
  std::vector<char> hit(n, 0);
  for (const Point& point : points)
    hit[std::min(n - 1, static_cast<std::size_t>(point[axis] * static_cast<double>(n)))] = 1;
  std::vector<std::size_t> empty;
  for (std::size_t k = 0; k < n; ++k)
    if (!hit[k]) empty.push_back(k);
  return empty;
}

// One random filling: so many new points, each in an empty interval of every axis.
Points filling(const std::vector<std::vector<std::size_t>>& empty, std::size_t count, std::size_t n,
               std::mt19937_64& random) {
  Points points(count, Point(empty.size()));
  for (std::size_t axis = 0; axis < empty.size(); ++axis) {
    std::vector<std::size_t> intervals = empty[axis];
    shuffle(intervals, random);
    for (std::size_t i = 0; i < count; ++i)
      points[i][axis] =
          (static_cast<double>(intervals[i]) + between_0_and_1(random)) / static_cast<double>(n);
  }
  return points;
}

double square_distance(const Point& a, const Point& b) {
  double sum = 0.0;
  for (std::size_t k = 0; k < a.size(); ++k) sum += (a[k] - b[k]) * (a[k] - b[k]);
  return sum;
}

// The smallest distance, squared, of a new point to any other.
double apart(const Points& old, const Points& fresh) {
  double smallest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < fresh.size(); ++i) {
    for (const Point& point : old) smallest = std::min(smallest, square_distance(fresh[i], point));
    for (std::size_t j = 0; j < i; ++j) smallest = std::min(smallest, square_distance(fresh[i], fresh[j]));
  }
  return smallest;
}

}  // namespace

std::vector<std::vector<double>> full_factorial(const std::vector<std::vector<double>>& levels) {
  std::vector<std::vector<double>> points = {{}};
  for (const std::vector<double>& axis : levels) {
    std::vector<std::vector<double>> longer;
    for (const std::vector<double>& point : points) {
      for (const double value : axis) {
        longer.push_back(point);
        longer.back().push_back(value);
      }
    }
    points = std::move(longer);
  }
  return points;
}

std::vector<double> equally_spaced(double lower, double upper, int levels) {
  std::vector<double> values;
  for (int i = 0; i < levels; ++i) {
    const double t = levels > 1 ? static_cast<double>(i) / (levels - 1) : 0.0;
    values.push_back((1.0 - t) * lower + t * upper);
  }
  return values;
}

std::vector<std::vector<double>> augmented_hypercube(std::vector<std::vector<double>> points, int n,
                                                     std::uint64_t seed) {
  const auto all = static_cast<std::size_t>(n);
  if (points.empty() || points.size() >= all) return points;
  const std::size_t count = all - points.size();
  std::vector<std::vector<std::size_t>> empty;
  for (std::size_t axis = 0; axis < points.front().size(); ++axis)
    empty.push_back(empty_intervals(points, axis, all));
  std::mt19937_64 random(seed);
  const double distances = static_cast<double>(count) * static_cast<double>(all);
  const int tries = std::clamp(static_cast<int>(most_distances / distances), 1, most_fillings);
  Points best = filling(empty, count, all, random);
  double best_apart = tries > 1 ? apart(points, best) : 0.0;
  for (int k = 1; k < tries; ++k) {
    Points other = filling(empty, count, all, random);
    const double other_apart = apart(points, other);
    if (other_apart > best_apart) best = std::move(other), best_apart = other_apart;
  }
  points.insert(points.end(), best.begin(), best.end());
  return points;
}

std::vector<std::vector<double>> morris(int dimension, int trajectories, std::uint64_t seed) {
  const auto d = static_cast<std::size_t>(dimension);
  std::mt19937_64 random(seed);
  Points points;
  std::vector<std::size_t> order(d);
  for (int t = 0; t < trajectories; ++t) {
    std::vector<int> level(d), step(d);  // of 0 ... 3, and by 2 up or down
    for (std::size_t k = 0; k < d; ++k) {
      level[k] = static_cast<int>(4.0 * between_0_and_1(random));
      step[k] = level[k] < 2 ? 2 : -2;
    }
    const auto point = [&] {
      Point p;
      for (const int l : level) p.push_back(l / 3.0);
      return p;
    };
    std::iota(order.begin(), order.end(), std::size_t{0});
    shuffle(order, random);
    points.push_back(point());
    for (const std::size_t axis : order) {
      level[axis] += step[axis];
      points.push_back(point());
    }
  }
  return points;
}

std::vector<std::vector<double>> central_composite(int dimension) {
  const auto d = static_cast<std::size_t>(dimension);
  Points points = {Point(d, 0.5)};
  for (std::size_t axis = 0; axis < d; ++axis)
    for (const double face : {0.0, 1.0}) {
      points.emplace_back(d, 0.5);
      points.back()[axis] = face;
    }
  for (Point& corner : full_factorial(Points(d, {0.0, 1.0}))) points.push_back(std::move(corner));
  return points;
}

std::vector<std::vector<double>> box_behnken(int dimension) {
  const auto d = static_cast<std::size_t>(dimension);
  Points points = {Point(d, 0.5)};
  for (std::size_t i = 0; i < d; ++i)
    for (std::size_t j = i + 1; j < d; ++j)
      for (const Point& corner : full_factorial({{0.0, 1.0}, {0.0, 1.0}})) {
        points.emplace_back(d, 0.5);
        points.back()[i] = corner[0], points.back()[j] = corner[1];
      }
  return points;
}

}  // namespace icebow
