#include "cli/process_text.h"

#include <vector>

#include "base/json_fields.h"
#include "cli/text_table.h"
#include "study/evaluate/result_keys.h"

namespace icebow {
namespace {

std::string percent(const Json& result, const std::string& pointer) {
  return decimals(100.0 * number_at(result, pointer), 0);
}

std::string count(const Json& result, const std::string& pointer) {
  return decimals(number_at(result, pointer), 0);
}

// In units of the ice's thickness.
std::string thicknesses(const Json& result, const std::string& pointer) {
  return decimals(number_at(result, pointer) / number_at(result, result_key::sheet_thickness), 1);
}

bool has_process(const Json& result) {
  return part_at(result, result_key::process).is_object();
}

std::string load_rhythm(const Json& result) {
  const bool clear = text_at(result, result_key::cycles) == "clear";
  return clear ? thicknesses(result, result_key::cycle_advance) : "overlapping";
}

}  // namespace

std::string process_table(const Ranking& ranking) {
  std::vector<std::vector<std::string>> rows = {{"design", "radial", "circumferential", "splitting",
                                                 "breaking length/h", "floes", "in floes, %", "cycle/h",
                                                 "peak/mean", "no contact, %"}};
  for (const RankedDesign& row : ranking.rows) {
    const Json& result = row.evaluation.result;
    if (row.rank == 0 || !has_process(result)) continue;
    rows.push_back({row.evaluation.name, count(result, result_key::cracks("radial")),
                    count(result, result_key::cracks("circumferential")),
                    count(result, result_key::cracks("splitting")),
                    thicknesses(result, result_key::breaking_length), count(result, result_key::floes),
                    percent(result, result_key::in_floes_share), load_rhythm(result),
                    decimals(number_at(result, result_key::peak_over_mean), 1),
                    percent(result, result_key::without_contact_share)});
  }
  return rows.size() > 1 ? text_table(rows) : "";
}

std::string process_text(const Json& result) {
  if (!has_process(result)) return "";
  const std::string length = decimals(number_at(result, result_key::breaking_length_over_characteristic), 2);
  return "cracks: " + count(result, result_key::cracks("radial")) + " radial, " +
         count(result, result_key::cracks("circumferential")) + " circumferential, " +
         count(result, result_key::cracks("splitting")) + " splitting; breaking length " +
         thicknesses(result, result_key::breaking_length) + " h, " + length + " characteristic lengths\n" +
         "broken ice: " + count(result, result_key::floes) + " floes with " +
         percent(result, result_key::in_floes_share) + " % of it, " +
         percent(result, result_key::dust_share) + " % dust\n" + "load: peak/mean " +
         decimals(number_at(result, result_key::peak_over_mean), 1) + ", no contact for " +
         percent(result, result_key::without_contact_share) + " % of the time, cycles " +
         (load_rhythm(result) == "overlapping" ? load_rhythm(result) : "of " + load_rhythm(result) + " h") +
         "\n" + "hull's work: " + percent(result, result_key::energy("fracture")) + " % fracture, " +
         percent(result, result_key::energy("contact_loss")) + " % friction and impact, " +
         percent(result, result_key::energy("kinetic")) + " % motion of the ice\n";
}

}  // namespace icebow
