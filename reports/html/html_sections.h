// The parts of the page that are made from data. All text is escaped here.
#pragma once

#include <string>

#include "reports/content/report_content.h"

namespace icebow {

std::string verdict_html(const StudyResults& study);
std::string provenance_html(const StudyResults& study);
// Ship, ice and speed the designs share; "from to" where they differ. Empty where no result says.
std::string conditions_html(const ReportContent& content);
std::string ranking_table_html(const ReportContent& content);
// Infeasible and failed designs with their reasons; empty where there are none.
std::string unranked_html(const ReportContent& content);
// One <details> a ranked design: lines plan, pictures, angles, loads, Lindqvist, margins.
std::string design_cards_html(const ReportContent& content);

}  // namespace icebow
