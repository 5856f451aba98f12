// Designs from a table: the method "table" of a study file.
#pragma once

#include <string>
#include <vector>

#include "study/spec/spec_section.h"
#include "study/spec/study_spec.h"

namespace icebow {

// Where the method is a "table" with a "file" (CSV, its path from the study file's directory), "columns" and
// "rows" of its numbers are put beside it: the document then holds its designs whatever becomes of the file.
// Throws InputError naming the file and the line.
void take_in_table(Json& document, const std::string& study_file);

// Reads columns (pointers into the study file) as variables with the ranges of their numbers, and the rows.
// Notes its mistakes.
void parse_table(const Json& document, Method& method, Mistakes& mistakes);

}  // namespace icebow
