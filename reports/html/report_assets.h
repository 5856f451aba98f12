// The browser part of the report, embedded at build time (see build.mjs).
#pragma once

#include <string>

namespace icebow {

std::string report_page_template();
std::string report_style();
std::string report_script();

}  // namespace icebow
