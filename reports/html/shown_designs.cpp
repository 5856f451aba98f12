#include "reports/html/shown_designs.h"

#include <set>

#include "study/spec/design_name.h"

namespace icebow {
namespace {

constexpr std::size_t most_best = 600, most_others = 400, most_unranked = 200;  // in all 1,200

bool is_wanted(const RankedDesign& row) {
  return row.front == FrontPlace::front || !is_numbered_name(row.evaluation.name);
}

// Of each row, whether it stays.
std::vector<bool> kept_rows(const std::vector<RankedDesign>& rows) {
  std::vector<bool> kept(rows.size(), false);
  std::size_t ranked = 0;
  while (ranked < rows.size() && rows[ranked].rank > 0) ++ranked;
  for (std::size_t i = 0; i < rows.size(); ++i)
    kept[i] = i < ranked ? i < most_best || is_wanted(rows[i]) : i - ranked < most_unranked;
  if (ranked <= most_best) return kept;
  const std::size_t others = std::min(most_others, ranked - most_best);
  for (std::size_t k = 1; k <= others; ++k) kept[most_best + k * (ranked - most_best) / others - 1] = true;
  return kept;
}

template <class T>
void keep(std::vector<T>& list, const std::vector<bool>& kept) {
  std::size_t to = 0;
  for (std::size_t i = 0; i < list.size(); ++i) {
    if (!kept[i]) continue;
    if (to != i) list[to] = std::move(list[i]);
    ++to;
  }
  list.erase(list.begin() + static_cast<std::ptrdiff_t>(to), list.end());
}

void keep_of_fit(ResponseFit& fit, const std::set<std::string>& names) {
  std::vector<bool> kept;
  for (const std::string& name : fit.names) kept.push_back(names.count(name) > 0);
  for (Effect& effect : fit.effects) keep(effect.moved, kept);
  keep(fit.names, kept);
}

}  // namespace

std::string leave_what_fits(ReportContent& content, ResponseFit& fit) {
  std::vector<RankedDesign>& rows = content.study.ranking.rows;
  const std::size_t all = rows.size();
  if (all <= most_best + most_others + most_unranked) return "";
  const std::vector<bool> kept = kept_rows(rows);
  keep(content.designs, kept);
  keep(rows, kept);
  std::set<std::string> names;
  for (const RankedDesign& row : rows) names.insert(row.evaluation.name);
  keep_of_fit(fit, names);
  return "This page has " + std::to_string(rows.size()) + " of " + std::to_string(all) +
         " designs: the best " + std::to_string(most_best) +
         ", those with a name of their own, and of the others some at even distances of rank. ranking.csv "
         "has all.";
}

}  // namespace icebow
