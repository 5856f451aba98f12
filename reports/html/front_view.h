// The Pareto front of a study with two objectives.
#pragma once

#include "base/json.h"
#include "reports/content/report_content.h"

namespace icebow {

// Of the template "charts": "has_front", "first_words", "second_words", "front_count", "open_words" and
// "front", a row
// {"id", "name", "outline", "first", "second"} for each design of the front. Without a second objective
// "has_front" is false.
Json front_view(const ReportContent& content);

// Of the chart's data: "words", "unit", "size", "best"; null without a second objective.
Json second_json(const ReportContent& content);

}  // namespace icebow
