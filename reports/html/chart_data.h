// What the charts draw, as JSON inside the page.
#pragma once

#include "reports/content/report_content.h"
#include "study/effects/response_fit.h"

namespace icebow {

// What the page's charts are drawn from; loads full scale [N], NaN is null. {"name", "unit": {"name",
// "newtons", "decimals"}, "rank_by", "quantity", "compared", "spearman", "spearman_n", "bounds": {pointer:
// [min, max]}, "designs":
// [{"id", "name", "status", "order", "rank", "tied_with_best", "value", "value_ci95", "value_error",
// "value_freedom" (of Welch's test), "mean_N", "ci95_N", "max_N", "q95_N", "lindqvist_N", "lambda", "second",
// "second_ci95", "front" (empty: no place), "angles_deg", "parameters", "smallest_margin", "steady_m",
// "outline_m", "histories": [{"advance_m", "load_N", "samples"}]}], "fit": {"names", "effects": [{"pointer",
// "lower", "upper", "change", "ci95", "at", "value", "half_width", "moved"}]}, "second": {"words", "unit",
// "size", "best"} (null: one objective), "csv"}
Json chart_data(const ReportContent& content, const ResponseFit& fit);

}  // namespace icebow
