// A case as each evaluator takes it.
#pragma once

#include "formula/lindqvist.h"
#include "solver/model/scenario.h"
#include "study/spec/study_spec.h"

namespace icebow {

// The same case as the solver wants it: model scale. Of calibrated ice the modulus is the one to be measured
// and there is no critical stretch: see simulated_scenario() in study/evaluate/calibration.h.
Scenario model_scenario(const Case& full);
LindqvistInputs lindqvist_inputs(const Case& full);

}  // namespace icebow
