// How the ice of one design broke: a part of its card.
#pragma once

#include "base/json.h"

namespace icebow {

// {"tables": [...]} of a result's "process", with lengths at full scale; null where it has none.
Json process_view(const Json& result, double lambda);

}  // namespace icebow
