// The table of the ranking and that of designs without a rank, as ranking.html and unranked.html take them.
#pragma once

#include "reports/content/report_content.h"

namespace icebow {

// "columns", "rows" and, of a long table, "more_rows", "has_ties", "has_marks", "compared", "angles_from".
Json ranking_view(const ReportContent& content);
Json unranked_view(const ReportContent& content);  // a list
// Three leading designs as the first screen shows them: a list.
Json podium_view(const ReportContent& content);

}  // namespace icebow
