#include "study/plan/feasible_points.h"

#include <algorithm>
#include <optional>

#include "study/plan/sampling.h"

namespace icebow {
namespace {

constexpr std::size_t tries_for_each = 100, least_tries = 10000;

using IsFeasible = std::function<bool(const std::vector<double>&)>;

// Feasible points of a sequence, one after the other.
class FeasibleSequence {
 public:
  FeasibleSequence(const Method& method, const IsFeasible& is_feasible, std::size_t most)
      : method_(method), is_feasible_(is_feasible), end_(most) {}

  std::optional<std::vector<double>> next() {
    while (at_ < end_) {
      if (at_ >= points_.size()) longer();
      const std::vector<double>& point = points_[at_++];
      if (is_feasible_(point)) return point;
    }
    return std::nullopt;
  }

 private:
  void longer() {
    const std::size_t number = std::min(end_, std::max<std::size_t>(64, 2 * (at_ + 1)));
    const Sequence kind = method_.type == MethodType::halton ? Sequence::halton : Sequence::sobol;
    const int dimension = static_cast<int>(method_.variables.size());
    points_ = in_units(sequence(kind, dimension, static_cast<int>(number)), method_.variables);
  }

  const Method& method_;
  const IsFeasible& is_feasible_;
  std::size_t at_ = 0, end_;
  std::vector<std::vector<double>> points_;
};

}  // namespace

std::vector<std::vector<double>> in_units(std::vector<std::vector<double>> points,
                                          const std::vector<Variable>& variables) {
  for (std::vector<double>& point : points) {
    for (std::size_t i = 0; i < point.size(); ++i) {
      const Variable& v = variables[i];
      const std::size_t n = v.values.size();
      point[i] = n == 0
                     ? v.lower + point[i] * (v.upper - v.lower)
                     : v.values[std::min(n - 1, static_cast<std::size_t>(point[i] * static_cast<double>(n)))];
    }
  }
  return points;
}

void replace_infeasible(const Method& method, std::vector<std::vector<double>>& points,
                        const IsFeasible& is_feasible, std::string& note) {
  const bool is_sequence = method.type != MethodType::latin_hypercube;
  FeasibleSequence feasible(method, is_feasible, std::max(least_tries, tries_for_each * points.size()));
  std::size_t infeasible = 0, left = 0;
  for (std::vector<double>& point : points) {
    const bool is_good = is_feasible(point);
    infeasible += is_good ? 0 : 1;
    if (is_good && !is_sequence) continue;
    if (auto other = feasible.next())
      point = std::move(*other);
    else
      ++left;
  }
  if (infeasible == 0) return;
  note = std::to_string(infeasible) + " of " + std::to_string(points.size()) +
         " points were infeasible and are replaced by feasible ones (method.replace_infeasible)";
  if (left > 0)
    note += "; for " + std::to_string(left) + " no other was found: `icebow check` looks for bounds";
}

}  // namespace icebow
