// Which designs of a large study its page shows: the others are in ranking.csv.
#pragma once

#include <string>

#include "reports/content/report_content.h"
#include "study/effects/response_fit.h"

namespace icebow {

// Leaves the best, the Pareto front, the baseline and the named designs, and of the others as many as fit,
// evenly by their rank; of those that are not ranked the first ones. 1,200 designs at most stay but for the
// front and the named ones. Returns a sentence on what was left out; empty where nothing was.
std::string leave_what_fits(ReportContent& content, ResponseFit& fit);

}  // namespace icebow
