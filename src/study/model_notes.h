// What is known to be wrong with the loads of a model that a study file asks for.
#pragma once

#include <string>
#include <vector>

#include "study/study_spec.h"

namespace icebow {

// In the words of docs/validation.md; empty where nothing is known.
std::vector<std::string> model_notes(const Case& c);

}  // namespace icebow
