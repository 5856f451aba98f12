#include "cli/process_text.h"

#include <limits>
#include <vector>

#include "cli/text_table.h"

namespace icebow {
namespace {

double at(const Json& process, const char* pointer) {
  const Json::json_pointer where(pointer);
  const bool there = process.contains(where) && process.at(where).is_number();
  return there ? process.at(where).get<double>() : std::numeric_limits<double>::quiet_NaN();
}

std::string percent(const Json& process, const char* pointer) {
  return decimals(100.0 * at(process, pointer), 0);
}

std::string count(const Json& process, const char* pointer) {
  return decimals(at(process, pointer), 0);
}

// In units of the ice's thickness.
std::string thicknesses(const Json& process, const char* pointer) {
  return decimals(at(process, pointer) / at(process, "/thickness_m"), 1);
}

bool has_process(const Json& result) {
  return result.is_object() && result.contains("process") && result.at("process").is_object();
}

std::string load_rhythm(const Json& process) {
  const bool clear = process.value("/load_cycle/cycles"_json_pointer, std::string()) == "clear";
  return clear ? thicknesses(process, "/load_cycle/advance_m") : "overlapping";
}

}  // namespace

std::string process_table(const Ranking& ranking) {
  std::vector<std::vector<std::string>> rows = {{"design", "radial", "circumferential", "splitting",
                                                 "breaking length/h", "floes", "in floes, %", "cycle/h",
                                                 "peak/mean", "no contact, %"}};
  for (const RankedDesign& row : ranking.rows) {
    if (row.rank == 0 || !has_process(row.evaluation.result)) continue;
    const Json& p = row.evaluation.result.at("process");
    rows.push_back(
        {row.evaluation.name, count(p, "/cracks/radial/count"), count(p, "/cracks/circumferential/count"),
         count(p, "/cracks/splitting/count"), thicknesses(p, "/breaking_length/normal_m"),
         count(p, "/floes/count"), percent(p, "/detached/in_floes_share"), load_rhythm(p),
         decimals(at(p, "/load_cycle/peak_over_mean"), 1), percent(p, "/load_cycle/without_contact_share")});
  }
  return rows.size() > 1 ? text_table(rows) : "";
}

std::string process_text(const Json& result) {
  if (!has_process(result)) return "";
  const Json& p = result.at("process");
  const std::string length = decimals(at(p, "/breaking_length/normal_over_characteristic"), 2);
  return "cracks: " + count(p, "/cracks/radial/count") + " radial, " +
         count(p, "/cracks/circumferential/count") + " circumferential, " +
         count(p, "/cracks/splitting/count") + " splitting; breaking length " +
         thicknesses(p, "/breaking_length/normal_m") + " h, " + length + " characteristic lengths\n" +
         "broken ice: " + count(p, "/floes/count") + " floes with " + percent(p, "/detached/in_floes_share") +
         " % of it, " + percent(p, "/detached/dust_share") + " % dust\n" + "load: peak/mean " +
         decimals(at(p, "/load_cycle/peak_over_mean"), 1) + ", no contact for " +
         percent(p, "/load_cycle/without_contact_share") + " % of the time, cycles " +
         (load_rhythm(p) == "overlapping" ? load_rhythm(p) : "of " + load_rhythm(p) + " h") + "\n" +
         "hull's work: " + percent(p, "/energy/fracture") + " % fracture, " +
         percent(p, "/energy/contact_loss") + " % friction and impact, " + percent(p, "/energy/kinetic") +
         " % motion of the ice\n";
}

}  // namespace icebow
