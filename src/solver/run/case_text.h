// A run in words: what two runs must share for one to continue the other.
#pragma once

#include <string>

#include "geometry/quad_mesh.h"
#include "solver/model/run_options.h"
#include "solver/model/scenario.h"

namespace icebow {

// One "name = value" a line, numbers exact, the hull as a checksum of its points and quads. Not in it: what
// the result does not depend on (the rank grid), and how far a moving window sails, since its ice is the same
// whatever the voyage's end: a run can be sailed on.
std::string case_text(const QuadMesh& hull, const Scenario& scenario, const RunOptions& options);

// The first line in which two of them differ, in words: "ice.h = 0.04 there, 0.05 here"; empty where they
// agree.
std::string case_difference(const std::string& there, const std::string& here);

}  // namespace icebow
