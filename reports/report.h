// Reports of a finished or running study, made from its result store and the files beside it.
#pragma once

#include <string>

namespace icebow {

// One self-contained HTML page (opens offline). Throws InputError where `study_directory` holds no study.
void write_html_report(const std::string& study_directory, const std::string& html_path);
// study_directory/ranking.csv and study_directory/ranking.md
void write_table_reports(const std::string& study_directory);

}  // namespace icebow
