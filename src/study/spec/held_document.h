// A study's document with the dimension that keeps its displacement: spec_hold.h.
#pragma once

#include "base/json.h"

namespace icebow {

// Puts the dimension that follows into the document, and first the displacement where the section leaves it
// out: that of the document's own bow. A document with mistakes, or for whose bow no value will do, stays as
// it is: the reader then says why.
void hold_displacement(Json& document);

}  // namespace icebow
