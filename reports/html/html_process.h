// How the ice of one design broke: a part of its card.
#pragma once

#include <string>

#include "base/json.h"

namespace icebow {

// Tables of a result's "process", with lengths at full scale; empty where it has none.
std::string process_html(const Json& result, double lambda);

}  // namespace icebow
