// The report of a finished or running study as a page, made from its result store and the files beside it.
#pragma once

#include <string>

namespace icebow {

// One self-contained HTML page (opens offline). Throws InputError where `study_directory` holds no study.
void write_html_report(const std::string& study_directory, const std::string& html_path);

}  // namespace icebow
