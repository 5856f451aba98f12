#include "reports/html/process_view.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/json_fields.h"
#include "reports/html/table_view.h"
#include "reports/text/text_format.h"
#include "study/evaluate/result_keys.h"

namespace icebow {
namespace {

std::string percent(double share) {
  return std::isfinite(share) ? fixed(100.0 * share, 0) + "\u00a0%" : fixed(share, 0);
}

// Median length and first advance of a kind among the cracks that are listed.
struct Listed {
  std::vector<double> lengths;
  double first = std::nan("");
};

Listed listed_of(const Json& result, const std::string& kind) {
  Listed found;
  for (const Json& crack : part_at(result, result_key::crack_list)) {
    if (text_at(crack, result_key::crack_kind) != kind) continue;
    if (found.lengths.empty()) found.first = number_at(crack, result_key::crack_opened);
    found.lengths.push_back(number_at(crack, result_key::crack_length));
  }
  std::sort(found.lengths.begin(), found.lengths.end());
  return found;
}

Json cracks_table(const Json& result, double lambda) {
  Json rows = Json::array();
  const std::pair<const char*, const char*> kinds[] = {{"radial", "Radial"},
                                                       {"circumferential", "Circumferential"},
                                                       {"splitting", "Splitting ahead"},
                                                       {"crushed", "Crushed at the hull"},
                                                       {"secondary", "Under the hull"},
                                                       {"held_edge", "Along held sides"}};
  for (const auto& [key, label] : kinds) {
    const Listed listed = listed_of(result, key);
    const double longest = listed.lengths.empty() ? std::nan("") : listed.lengths.back();
    rows.push_back(row_view(label, {fixed(number_at(result, result_key::cracks(key)), 0),
                                    fixed(longest * lambda, 1), fixed(listed.first * lambda, 1)}));
  }
  return table_view("Cracks", {"number", "longest, m", "first at, m"}, rows);
}

Json breaking_table(const Json& result, double lambda) {
  const double h = number_at(result, result_key::sheet_thickness),
               l = number_at(result, result_key::characteristic_length);
  Json rows = Json::array();
  const auto add = [&](const char* name, const char* pointer) {
    const double value = number_at(result, pointer);
    rows.push_back(row_view(name, {fixed(value * lambda, 1), fixed(value / h, 1), fixed(value / l, 2)}));
  };
  add("Breaking length, from the hull", result_key::breaking_length);
  add("Breaking length, half of it nearer than", result_key::breaking_length_median);
  add("Breaking length, a tenth farther than", result_key::breaking_length_nine_tenths);
  add("Breaking length, along the course", result_key::breaking_length_along_course);
  add("Floes, mean length", result_key::floe_length);
  add("Floes, mean width", result_key::floe_width);
  add("Advance per load cycle", result_key::cycle_advance);
  add("Channel, mean width", result_key::channel_width);
  add("Channel, standard deviation", result_key::channel_width_std);
  return table_view("Sizes", {"full scale, m", "over h", "over \u2113"}, rows);
}

Json load_table(const Json& result) {
  const auto value = [&](const char* pointer, int decimals) {
    return fixed(number_at(result, pointer), decimals);
  };
  const bool clear = text_at(result, result_key::cycles) == "clear";
  Json rows = Json::array();
  rows.push_back(row_view("Cycles", {clear ? "clear" : "overlapping"}));
  rows.push_back(row_view("Autocorrelation at the period", {value(result_key::cycle_autocorrelation, 2)}));
  rows.push_back(row_view("Significant above", {value(result_key::cycle_significant_above, 2)}));
  rows.push_back(row_view("Peak / mean", {value(result_key::peak_over_mean, 1)}));
  rows.push_back(row_view("Standard deviation / mean", {value(result_key::std_over_mean, 2)}));
  rows.push_back(
      row_view("Time without contact", {percent(number_at(result, result_key::without_contact_share))}));
  return table_view("Load in time", {"value"}, rows);
}

Json ice_table(const Json& result) {
  Json rows = Json::array();
  rows.push_back(row_view("Floes", {fixed(number_at(result, result_key::floes), 0)}));
  rows.push_back(row_view("of them as thick as the sheet",
                          {fixed(number_at(result, result_key::floes_through_thickness), 0)}));
  rows.push_back(row_view("Broken ice in floes", {percent(number_at(result, result_key::in_floes_share))}));
  rows.push_back(row_view("Broken ice that is dust", {percent(number_at(result, result_key::dust_share))}));
  return table_view("Pieces", {"value"}, rows);
}

Json energy_table(const Json& result) {
  Json rows = Json::array();
  const std::pair<const char*, const char*> parts[] = {{"contact_loss", "Friction and impact"},
                                                       {"fracture", "Fracture"},
                                                       {"water", "Motion of the water"},
                                                       {"floe_contact", "Ice against ice"},
                                                       {"absorbed", "Damped edges"},
                                                       {"kinetic", "Motion of the ice"},
                                                       {"elastic", "Elastic"},
                                                       {"potential", "Weight and lift"},
                                                       {"left_astern", "Left astern"},
                                                       {"unexplained", "Error of the balance"}};
  for (const auto& [key, label] : parts) {
    const double share = number_at(result, result_key::energy(key));
    if (std::isfinite(share) && share != 0.0) rows.push_back(row_view(label, {percent(share)}));
  }
  return table_view("Where the hull's work went", {"share"}, rows);
}

}  // namespace

Json process_view(const Json& result, double lambda) {
  if (!part_at(result, result_key::process).is_object()) return nullptr;
  return {{"tables", tables_view({cracks_table(result, lambda), breaking_table(result, lambda),
                                  load_table(result), ice_table(result), energy_table(result)})}};
}

}  // namespace icebow
