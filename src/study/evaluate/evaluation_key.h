// What a stored evaluation is found by.
#pragma once

#include <string>

#include "base/json.h"
#include "study/spec/study_spec.h"

namespace icebow {

// Key of everything the result depends on: the SHA-256 of evaluation_text().
std::string evaluation_key(const Case& c, bool use_lindqvist, bool use_peridynamics, bool use_cycle = false);

// One line a field: the result version first, then the exact bits of the case, its name left out.
std::string evaluation_text(const Case& c, bool use_lindqvist, bool use_peridynamics, bool use_cycle = false);

// By the document's evaluators.
std::string evaluation_key(const Case& c, const Json& document);

// Whether a study document asks for "lindqvist", "cycle" or "peridynamics": the first and the last where it
// has no "evaluators".
bool asks_for(const Json& document, const std::string& evaluator);

}  // namespace icebow
