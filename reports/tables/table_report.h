// The ranking as a table.
#pragma once

#include <string>

#include "reports/content/study_results.h"

namespace icebow {

// One line a design, full precision; loads full scale [N] unless the column says model; angles measured on
// the mesh, requested ones where there is no mesh. Column names end in the unit; a missing number is an empty
// field.
std::string ranking_csv(const StudyResults& study);
std::string ranking_markdown(const StudyResults& study);

// Writes study_directory/ranking.csv and study_directory/ranking.md. Throws InputError where the directory
// holds no study.
void write_table_reports(const std::string& study_directory);

}  // namespace icebow
