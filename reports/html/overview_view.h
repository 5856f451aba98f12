// First screen, method, conditions and provenance, as first_screen.html, reading.html and conditions.html
// take them.
#pragma once

#include "reports/content/report_content.h"

namespace icebow {

std::string kicker(const StudyResults& study);  // "Icebreaker bow study · 164 designs ranked, 37 infeasible"
Json method_view(const ReportContent& content);  // texts of what this study did, a list of {"title", "text"}
Json provenance_view(const StudyResults& study);

}  // namespace icebow
