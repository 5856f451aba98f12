// What the charts draw, as JSON inside the page.
#pragma once

#include "reports/content/report_content.h"

namespace icebow {

// {"name", "unit": {"name", "newtons", "decimals"}, "spearman", "spearman_n", "designs": [{"id", "name",
// "status", "rank", "tied_with_best", "tied_with_next", "mean_N", "ci95_N", "max_N", "q95_N", "lindqvist_N",
// "lambda", "angles_deg", "parameters", "steady_m", "history": {"advance_m", "load_N"}}], "csv"}; full scale.
Json chart_data(const ReportContent& content);

}  // namespace icebow
