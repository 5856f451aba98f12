// The section "derived" of a study file: numbers that follow from others by an expression.
#pragma once

#include "study/spec/spec_section.h"

namespace icebow {

// Puts the values of the expressions in the place of the numbers that the document has there. An expression
// sees the document's other numbers by their places, spelled "bow.beam_m", in the units they are written in,
// and what other expressions derive. Notes its mistakes; without "derived" nothing happens.
void apply_derived(Json& document, Mistakes& mistakes);

bool is_derived(const Json& document, const std::string& pointer);

}  // namespace icebow
