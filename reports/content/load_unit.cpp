#include "reports/content/load_unit.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/text.h"
#include "reports/text/text_format.h"
#include "study/evaluate/result_keys.h"

namespace icebow {
namespace {

struct Ending {
  const char *text, *unit;
  double size;
};

// Masses in tonnes; loads as the page has them elsewhere.
std::vector<Ending> endings(const LoadUnit& load) {
  return {{"_kg", "t", 1e3},       {"_N", load.name.c_str(), load.newtons},
          {"_m2", "m\u00b2", 1.0}, {"_m3", "m\u00b3", 1.0},
          {"_m", "m", 1.0},        {"_deg", "\u00b0", 1.0}};
}

bool ends_with(const std::string& text, const std::string& end) {
  return text.size() > end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

}  // namespace

bool is_own_number(const std::string& rank_by) {
  return !rank_by.empty() && rank_by[0] == '/';
}

LoadUnit load_unit(const Ranking& ranking) {
  double largest = 0.0;
  for (const RankedDesign& row : ranking.rows)
    for (const double load : {row.mean_load, row.lindqvist, is_own_number(ranking.rank_by) ? row.value : NAN})
      if (std::isfinite(load)) largest = std::max(largest, std::abs(load));
  if (largest > 0.0 && largest < 1e5) return {"kN", 1e3, largest < 1e4 ? 2 : 1};
  return {"MN", 1e6, largest < 1e7 ? 3 : 2};
}

std::string load_number(double value, const LoadUnit& unit) {
  const bool vanishes = value != 0.0 && std::fabs(value) < 0.5 * std::pow(10.0, -unit.decimals);
  return vanishes ? text("%.2g", value) : fixed(value, unit.decimals);
}

std::string load_in_words(double newtons, const LoadUnit& unit) {
  return load_number(newtons / unit.newtons, unit) + "\u00a0" + unit.name;
}

std::string with_interval(double value, double half_width, int decimals) {
  if (!std::isfinite(half_width)) return fixed(value, decimals);
  return fixed(value, decimals) + "\u00a0\u00b1\u00a0" + fixed(half_width, decimals);
}

int decimals_for_interval(double half_width, int least, int most) {
  if (!std::isfinite(half_width) || half_width <= 0.0) return most;
  const double exponent = std::floor(std::log10(half_width));
  const bool starts_with_one = half_width / std::pow(10.0, exponent) < 1.95;
  return std::clamp(static_cast<int>(-exponent) + (starts_with_one ? 1 : 0), least, most);
}

std::string ranked_quantity(const std::string& rank_by) {
  if (rank_by == "mean_load") return "mean ice load";
  if (rank_by == "mean_load_per_beam") return "mean ice load per metre of beam";
  if (rank_by == "lindqvist_breaking") return "breaking resistance by Lindqvist's formula";
  if (rank_by == "cycle_load") return "mean load by the breaking cycle";
  if (!is_own_number(rank_by)) return rank_by;
  // "/programs/yard/ice_resistance_N" reads "ice resistance by yard".
  const std::size_t last = rank_by.rfind('/');
  std::string words = rank_by.substr(last + 1);
  if (words.size() > 2 && words.compare(words.size() - 2, 2, "_N") == 0) words.resize(words.size() - 2);
  std::replace(words.begin(), words.end(), '_', ' ');
  const std::size_t before = last > 0 ? rank_by.rfind('/', last - 1) : std::string::npos;
  return before == std::string::npos ? words : words + " by " + rank_by.substr(before + 1, last - before - 1);
}

SecondQuantity second_quantity(const Ranking& ranking, const LoadUnit& load) {
  const std::string& by = ranking.objective.by;
  if (!is_own_number(by)) return {ranked_quantity(by), load.name, load.newtons};
  std::string word = by.substr(by.rfind('/') + 1);
  SecondQuantity quantity;
  for (const Ending& ending : endings(load)) {
    if (!ends_with(word, ending.text)) continue;
    word.resize(word.size() - std::string(ending.text).size());
    quantity.unit = ending.unit, quantity.size = ending.size;
    break;
  }
  std::replace(word.begin(), word.end(), '_', ' ');
  quantity.words = result_key::is_margin(by) ? "margin " + word : word;
  return quantity;
}

double value_ci95(const RankedDesign& row, const std::string& rank_by) {
  if (rank_by == "lindqvist_breaking" || is_own_number(rank_by))
    return std::nan("");  // a formula has no sampling error
  if (rank_by == "cycle_load") return row.cycle_ci95;
  return row.mean_load != 0.0 ? row.mean_load_ci95 * row.value / row.mean_load : std::nan("");
}

}  // namespace icebow
