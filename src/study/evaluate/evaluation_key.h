// What a stored evaluation is found by.
#pragma once

#include <string>

#include "study/spec/study_spec.h"

namespace icebow {

// Key of everything the result depends on: the SHA-256 of evaluation_text().
std::string evaluation_key(const Case& c, const Evaluators& asked);

// One line a field: the result version first, then the exact bits of the case, its name left out.
std::string evaluation_text(const Case& c, const Evaluators& asked);

}  // namespace icebow
