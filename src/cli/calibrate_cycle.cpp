#include "cli/calibrate_cycle.h"

#include <cstdio>
#include <iostream>

#include "cli/commands.h"
#include "cli/text_table.h"
#include "cycle/breaking.h"
#include "study/evaluate/calibration.h"
#include "study/evaluate/cycle_run.h"
#include "study/evaluate/patch_tests.h"
#include "study/spec/spec_hints.h"

namespace icebow {
namespace {

struct Row {
  cycle::PatchTest test;
  double literature_capacity, literature_length, plate_capacity, plate_length;  // as the test's
};

Row compared(const Case& c, const cycle::PatchTest& test) {
  const cycle::Ice ice = cycle_ice(c);
  const double load = ice.sigma_f * ice.h * ice.h, l = ice.characteristic_length();
  const cycle::Press press = {test.width_h * ice.h, test.edge_speed, test.edge_speed};
  cycle::BreakingRule rule = c.cycle.rule;
  rule.type = cycle::Breaking::literature;
  const cycle::Capacity literature = cycle::capacity(ice, rule, press);
  rule.type = cycle::Breaking::plate;
  const cycle::Capacity plate = cycle::capacity(ice, rule, press);
  return {test, literature.load / load, literature.radius / l, plate.load / load, plate.radius / l};
}

Json to_json(const std::vector<Row>& rows, const PatchTable& table, const std::string& design) {
  Json list = Json::array();
  for (const Row& r : rows)
    list.push_back({{"width_over_h", r.test.width_h},
                    {"edge_speed_m_s", r.test.edge_speed},
                    {"capacity", r.test.capacity},
                    {"breaking_length_over_characteristic", r.test.length_l},
                    {"literature", {{"capacity", r.literature_capacity}, {"length", r.literature_length}}},
                    {"plate", {{"capacity", r.plate_capacity}, {"length", r.plate_length}}}});
  return {{"design", design}, {"tests", list}, {"notes", table.notes}, {"recalled", table.recalled}};
}

std::string for_people(const std::vector<Row>& rows, const PatchTable& table, const std::string& design) {
  std::vector<std::vector<std::string>> cells = {{"width/h", "edge speed, m/s", "C tested", "literature",
                                                  "plate", "length/l tested", "literature", "plate"}};
  for (const Row& r : rows)
    cells.push_back({brief(r.test.width_h), brief(r.test.edge_speed), decimals(r.test.capacity, 2),
                     decimals(r.literature_capacity, 2), decimals(r.plate_capacity, 2),
                     decimals(r.test.length_l, 2), decimals(r.literature_length, 2),
                     decimals(r.plate_length, 2)});
  std::string text = design +
                     ": edges pressed down by a plate of 45 deg; C is the load that breaks them over "
                     "flexural strength x thickness^2, length the crack's distance from the hull" +
                     std::string(table.recalled ? " (recalled)" : "") + "\n\n" + text_table(cells);
  for (const std::string& note : table.notes)
    text += "note: " + note + "; it has the numbers of the nearest width\n";
  return text;
}

}  // namespace

int calibrate_cycle(const ChosenDesign& chosen, bool as_json) {
  const Case& c = chosen.description;
  const auto on_test = [](double width, double speed) {
    std::fprintf(stderr, "edge pressed over %g h at %.3g m/s\n", width, speed);
  };
  const PatchTable table =
      patch_table(Communicator::serial(), c, patch_plan(c), calibration_directory(), on_test);
  std::vector<Row> rows;
  for (const cycle::PatchTest& test : table.tests) rows.push_back(compared(c, test));
  const std::string name = chosen.design.name;
  if (as_json) {
    std::cout << to_json(rows, table, name).dump(2) << "\n";
  } else {
    std::cout << for_people(rows, table, name);
  }
  if (!rows.empty()) return exit_code::ok;
  std::cerr << name << ": no edge broke: the breaking cycle cannot be calibrated with this ice\n";
  return exit_code::failure;
}

}  // namespace icebow
