#include "solver/model/breaking_process.h"

#include <algorithm>
#include <cmath>

namespace icebow {
namespace {

struct WeightedMean {
  double sum = 0.0, weight = 0.0;
  void add(double value, double w) {
    if (!std::isfinite(value)) return;
    sum += w * value;
    weight += w;
  }
  double value() const { return weight > 0.0 ? sum / weight : std::numeric_limits<double>::quiet_NaN(); }
};

}  // namespace

const char* to_string(CrackKind kind) {
  static const char* const names[crack_kinds] = {"radial",  "circumferential", "splitting",
                                                 "crushed", "secondary",       "held_edge"};
  return names[static_cast<int>(kind)];
}

EnergyShares energy_shares(const History& history) {
  EnergyShares shares;
  const auto balanced = std::find_if(history.rows.rbegin(), history.rows.rend(),
                                     [](const HistoryRow& row) { return std::isfinite(row.balance_error); });
  if (balanced == history.rows.rend() || !(balanced->hull_work > 0.0)) return shares;
  const HistoryRow& row = *balanced;
  const double work = row.hull_work;
  shares.hull_work = work;
  shares.fracture = row.fracture / work;
  shares.elastic = row.elastic / work;
  shares.kinetic = row.kinetic_energy / work;
  shares.potential = row.potential / work;
  shares.contact_loss = row.contact_loss / work;
  shares.water = row.water_loss / work;
  shares.floe_contact = row.floe_loss / work;
  shares.absorbed = row.edge_loss / work;
  shares.unexplained = row.balance_error / work;
  shares.left_astern = 1.0 + shares.unexplained - shares.contact_loss - shares.fracture - shares.elastic -
                       shares.kinetic - shares.potential - shares.water - shares.floe_contact -
                       shares.absorbed;
  return shares;
}

namespace {

// The distance below which this part of the columns lies; cracks by rising distance.
double quantile(const std::vector<const Crack*>& cracks, double part) {
  double columns = 0.0, so_far = 0.0;
  for (const Crack* crack : cracks) columns += crack->columns;
  for (const Crack* crack : cracks) {
    so_far += crack->columns;
    if (so_far >= part * columns) return crack->from_hull;
  }
  return std::numeric_limits<double>::quiet_NaN();
}

}  // namespace

BreakingLength breaking_length(const std::vector<Crack>& cracks) {
  BreakingLength result;
  WeightedMean normal, along, square;
  std::vector<const Crack*> by_distance;
  for (const Crack& crack : cracks) {
    if (crack.kind != CrackKind::circumferential) continue;
    ++result.cracks;
    by_distance.push_back(&crack);
    normal.add(crack.from_hull, crack.columns);
    along.add(crack.along_course, crack.columns);
  }
  for (const Crack& crack : cracks) {
    if (crack.kind == CrackKind::circumferential)
      square.add(std::pow(crack.from_hull - normal.value(), 2), crack.columns);
  }
  result.normal = normal.value();
  result.along = along.value();
  result.deviation = std::sqrt(square.value());
  std::stable_sort(by_distance.begin(), by_distance.end(),
                   [](const Crack* a, const Crack* b) { return a->from_hull < b->from_hull; });
  result.tenth = quantile(by_distance, 0.1);
  result.median = quantile(by_distance, 0.5);
  result.nine_tenths = quantile(by_distance, 0.9);
  return result;
}

}  // namespace icebow
