#include "reports/html/html_process.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "reports/text/json_fields.h"
#include "reports/text/text_format.h"

namespace icebow {
namespace {

std::string row(const std::string& name, const std::vector<std::string>& values) {
  std::string html = "<tr><th scope=\"row\">" + name + "</th>";
  for (const std::string& value : values) html += "<td class=\"num\">" + value + "</td>";
  return html + "</tr>";
}

std::string table(const std::string& caption, const std::vector<std::string>& columns,
                  const std::string& rows) {
  std::string html = "<table><caption>" + caption + "</caption><thead><tr><td></td>";
  for (const std::string& column : columns) html += "<th scope=\"col\" class=\"num\">" + column + "</th>";
  return html + "</tr></thead><tbody>" + rows + "</tbody></table>\n";
}

std::string percent(double share) {
  return std::isfinite(share) ? fixed(100.0 * share, 0) + "\u00a0%" : fixed(share, 0);
}

// Median length and first advance of a kind among the cracks that are listed.
struct Listed {
  std::vector<double> lengths;
  double first = std::nan("");
};

Listed listed_of(const Json& process, const std::string& kind) {
  Listed result;
  for (const Json& crack : part_at(process, "/cracks/list")) {
    if (text_at(crack, "/kind") != kind) continue;
    if (result.lengths.empty()) result.first = number_at(crack, "/opened_m");
    result.lengths.push_back(number_at(crack, "/length_m"));
  }
  std::sort(result.lengths.begin(), result.lengths.end());
  return result;
}

std::string cracks_table(const Json& process, double lambda) {
  std::string rows;
  const std::pair<const char*, const char*> kinds[] = {{"radial", "Radial"},
                                                       {"circumferential", "Circumferential"},
                                                       {"splitting", "Splitting ahead"},
                                                       {"crushed", "Crushed at the hull"},
                                                       {"secondary", "Under the hull"},
                                                       {"held_edge", "Along held sides"}};
  for (const auto& [key, label] : kinds) {
    const Listed listed = listed_of(process, key);
    const double longest = listed.lengths.empty() ? std::nan("") : listed.lengths.back();
    rows += row(label, {fixed(number_at(process, std::string("/cracks/") + key + "/count"), 0),
                        fixed(longest * lambda, 1), fixed(listed.first * lambda, 1)});
  }
  return table("Cracks", {"number", "longest, m", "first at, m"}, rows);
}

std::string breaking_table(const Json& process, double lambda) {
  const double h = number_at(process, "/thickness_m"), l = number_at(process, "/characteristic_length_m");
  std::string rows;
  const auto add = [&](const char* name, const char* pointer) {
    const double value = number_at(process, pointer);
    rows += row(name, {fixed(value * lambda, 1), fixed(value / h, 1), fixed(value / l, 2)});
  };
  add("Breaking length, from the hull", "/breaking_length/normal_m");
  add("Breaking length, along the course", "/breaking_length/along_course_m");
  add("Floes, mean length", "/floes/length_m/mean");
  add("Floes, mean width", "/floes/width_m/mean");
  add("Advance per load cycle", "/load_cycle/advance_m");
  add("Channel, mean width", "/channel/width_m/mean");
  add("Channel, standard deviation", "/channel/width_std_m");
  return table("Sizes", {"full scale, m", "over h", "over \u2113"}, rows);
}

std::string load_table(const Json& process) {
  const auto value = [&](const char* pointer, int decimals) {
    return fixed(number_at(process, pointer), decimals);
  };
  const bool clear = text_at(process, "/load_cycle/cycles") == "clear";
  std::string rows = row("Cycles", {clear ? "clear" : "overlapping"});
  rows += row("Autocorrelation at the period", {value("/load_cycle/autocorrelation", 2)});
  rows += row("Significant above", {value("/load_cycle/significant_above", 2)});
  rows += row("Peak / mean", {value("/load_cycle/peak_over_mean", 1)});
  rows += row("Standard deviation / mean", {value("/load_cycle/std_over_mean", 2)});
  rows += row("Time without contact", {percent(number_at(process, "/load_cycle/without_contact_share"))});
  return table("Load in time", {""}, rows);
}

std::string ice_table(const Json& process) {
  std::string rows = row("Floes", {fixed(number_at(process, "/floes/count"), 0)});
  rows += row("of them as thick as the sheet", {fixed(number_at(process, "/floes/through_thickness"), 0)});
  rows += row("Broken ice in floes", {percent(number_at(process, "/detached/in_floes_share"))});
  rows += row("Broken ice that is dust", {percent(number_at(process, "/detached/dust_share"))});
  return table("Pieces", {""}, rows);
}

std::string energy_table(const Json& process) {
  std::string rows;
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
    const double share = number_at(process, std::string("/energy/") + key);
    if (std::isfinite(share) && share != 0.0) rows += row(label, {percent(share)});
  }
  return rows.empty() ? rows : table("Where the hull's work went", {"share"}, rows);
}

}  // namespace

std::string process_html(const Json& result, double lambda) {
  const Json& process = part_at(result, "/process");
  if (!process.is_object()) return {};
  return "<h4>How the ice broke <small>lengths at full scale; h thickness, \u2113 characteristic length of "
         "the floating sheet</small></h4><div class=\"tables process\">" +
         cracks_table(process, lambda) + breaking_table(process, lambda) + load_table(process) +
         ice_table(process) + energy_table(process) + "</div>\n";
}

}  // namespace icebow
