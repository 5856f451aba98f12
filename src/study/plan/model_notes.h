// What is known to be wrong with the loads of a model that a study file asks for.
#pragma once

#include <string>
#include <vector>

#include "study/spec/study_spec.h"

namespace icebow {

// Notes on the study file's own values, in the words of docs/validation.md; empty where nothing is known.
// Designs that change them are not looked at.
// `confirms`: the simulation is compared with the cycle over the same way, so it may be short.
std::vector<std::string> model_notes(const Case& c, bool confirms = false);

}  // namespace icebow
