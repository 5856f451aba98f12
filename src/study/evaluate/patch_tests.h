// How the edge of a study's own ice breaks: it is pressed down over some widths at some speeds by a sloping
// plate, in the simulation. The breaking cycle takes the numbers (docs/cycle.md, "calibrated").
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "base/communicator.h"
#include "cycle/cycle_input.h"
#include "study/spec/study_spec.h"

namespace icebow {

struct PatchPlan {
  std::vector<double> widths_h = {1.0, 2.0, 4.0, 8.0};  // over the thickness
  std::vector<double> edge_speeds;                      //!< full scale [m/s]
};
// Speeds: a tenth, a third and all of the speed with which this case's ship drives an edge down.
PatchPlan patch_plan(const Case& c);

// One test; capacity and length are NaN where the edge did not break within the plate's way. Collective.
// Throws InputError for ice that cannot be simulated.
cycle::PatchTest patch_test(const Communicator& comm, const Case& c, double width_h, double edge_speed);

struct PatchTable {
  std::vector<cycle::PatchTest>
      tests;                       // a full grid, those that did not break with their neighbour's numbers
  std::vector<std::string> notes;  // which did not break; sentences
  bool recalled = false;           // from the cache
};
// Kept in `directory` (empty: not) by everything the tests depend on. `on_test` is told before each one.
PatchTable patch_table(const Communicator& comm, const Case& c, const PatchPlan& plan,
                       const std::string& directory,
                       const std::function<void(double width_h, double edge_speed)>& on_test = nullptr);

// The rule a case asks for, patch tests done where it is "calibrated" (minutes, once). Collective.
cycle::BreakingRule cycle_rule(const Communicator& comm, const Case& c);

}  // namespace icebow
