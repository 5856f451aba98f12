#include "study/run/expected_work.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace icebow {

namespace {

// A step is the way of a wave over the lattice spacing.
double work_of(const Case& c) {
  const double dx = c.numerics.dx;
  const double particles =
      c.sheet.length * c.sheet.width * c.ice.h / (dx * dx * dx) * (c.sheet.half_model ? 0.5 : 1.0);
  const double steps = c.advance / c.V * std::sqrt(c.ice.E / c.ice.rho) / dx;
  const double work = particles * steps;
  return std::isfinite(work) ? work : 0.0;
}

}  // namespace

double expected_work(const Design& design) {
  if (!design.given || !design.asked.peridynamics) return 0.0;
  if (design.given->scenarios.empty()) return work_of(*design.given);
  double work = 0.0;
  for (const CaseScenario& scenario : design.given->scenarios) work += work_of(*scenario.given);
  return work;
}

std::vector<PlannedDesign> longest_first(std::vector<PlannedDesign> designs) {
  std::vector<double> work;
  for (const PlannedDesign& planned : designs) work.push_back(expected_work(planned.design));
  std::vector<std::size_t> order(designs.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return work[a] > work[b]; });
  std::vector<PlannedDesign> sorted;
  for (const std::size_t i : order) sorted.push_back(std::move(designs[i]));
  return sorted;
}

}  // namespace icebow
