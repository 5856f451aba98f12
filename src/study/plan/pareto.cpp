#include "study/plan/pareto.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace icebow {
namespace {

constexpr double least_t = 1.959;  // no quantile of Student's t at 97.5 % is below it

bool is_exact(const MeanEstimate& a, const MeanEstimate& b) {
  return a.standard_error == 0.0 && b.standard_error == 0.0;
}

// Exact: as good. Else: better beyond the interval of the difference.
bool surely_not_worse(const MeanEstimate& a, const MeanEstimate& b) {
  if (is_exact(a, b)) return a.mean <= b.mean;
  const double error = std::hypot(a.standard_error, b.standard_error);
  if (!(b.mean - a.mean > least_t * error)) return false;
  return mean_difference(a, b).p < told_apart_below;
}

// By their values alone.
bool dominates(const Objectives& a, const Objectives& b) {
  return a.first.mean <= b.first.mean && a.second.mean <= b.second.mean &&
         (a.first.mean < b.first.mean || a.second.mean < b.second.mean);
}

bool has_place(const Objectives& design) {
  return std::isfinite(design.first.mean) && std::isfinite(design.second.mean);
}

std::vector<std::size_t> by_first(const std::vector<Objectives>& designs) {
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < designs.size(); ++i)
    if (has_place(designs[i])) order.push_back(i);
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    const Objectives &x = designs[a], &y = designs[b];
    return x.first.mean != y.first.mean ? x.first.mean < y.first.mean : x.second.mean < y.second.mean;
  });
  return order;
}

}  // namespace

const char* to_string(FrontPlace place) {
  switch (place) {
    case FrontPlace::front:
      return "front";
    case FrontPlace::open:
      return "open";
    case FrontPlace::dominated:
      return "dominated";
    case FrontPlace::none:
      break;
  }
  return "";
}

bool surely_dominates(const Objectives& a, const Objectives& b) {
  return dominates(a, b) && surely_not_worse(a.first, b.first) && surely_not_worse(a.second, b.second);
}

std::vector<FrontPlace> front_places(const std::vector<Objectives>& designs) {
  std::vector<FrontPlace> places(designs.size(), FrontPlace::none);
  const std::vector<std::size_t> order = by_first(designs);
  std::vector<std::size_t> front, others;
  double lowest = std::numeric_limits<double>::infinity();
  for (const std::size_t i : order) {
    const bool twin =
        !front.empty() && !dominates(designs[front.back()], designs[i]) && designs[i].second.mean == lowest;
    const bool on_front = designs[i].second.mean < lowest || twin;
    (on_front ? front : others).push_back(i);
    if (on_front) lowest = designs[i].second.mean, places[i] = FrontPlace::front;
  }
  std::vector<std::size_t> rivals = front;  // those most likely to settle it come first
  rivals.insert(rivals.end(), others.begin(), others.end());
  for (const std::size_t i : others) {
    const bool settled = std::any_of(rivals.begin(), rivals.end(),
                                     [&](std::size_t k) { return surely_dominates(designs[k], designs[i]); });
    places[i] = settled ? FrontPlace::dominated : FrontPlace::open;
  }
  return places;
}

}  // namespace icebow
