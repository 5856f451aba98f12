#include <iostream>

#include "base/units.h"
#include "cli/commands.h"
#include "cli/cycle_text.h"
#include "cli/study_choice.h"
#include "study/evaluate/cycle_run.h"
#include "study/evaluate/patch_tests.h"
#include "study/spec/case_hull.h"

namespace icebow {
namespace {

Json found_json(const CycleOutcome& outcome, const Case& c, const std::string& design) {
  Json json = cycle_json(outcome, c, c.cycle.rule);
  json["design"] = design;
  json["metrics"] = cycle_metrics_json(outcome);
  return json;
}

}  // namespace

int run_cycle_command(const Communicator&, const Arguments& arguments) {
  const ChosenDesign chosen = choose_design(load_study(arguments), arguments);
  const Case& c = chosen.description;
  const Hull hull = make_hull(c);
  const std::string name = chosen.design.name;
  if (hull.status != HullStatus::ok) {
    std::cerr << name << ": there is no hull: " << hull.reason << "\n";
    return exit_code::failure;
  }
  const cycle::BreakingRule rule = cycle_rule(Communicator::serial(), c);
  const CycleOutcome outcome = run_cycle(c, hull.mesh, rule);
  if (!outcome.reason.empty()) {
    std::cerr << name << ": no voyage: " << outcome.reason << "\n";
    return exit_code::failure;
  }
  if (arguments.has("--json")) {
    std::cout << found_json(outcome, c, name).dump(2) << "\n";
  } else {
    std::cout << cycle_text(outcome, c, name);
  }
  return exit_code::ok;
}

}  // namespace icebow
