// The breaking cycle in a design's card: its parts, what was simulated beside it, and a voyage.
#pragma once

#include <string>

#include "reports/content/report_content.h"

namespace icebow {

// Empty where the design was not evaluated by the cycle.
std::string cycle_html(const RankedDesign& ranked, const DesignContent& design, const LoadUnit& unit);

}  // namespace icebow
