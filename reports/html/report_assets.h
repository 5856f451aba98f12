// The browser part of the report, embedded at build time (see build.mjs).
#pragma once

#include <map>
#include <string>

namespace icebow {

const std::map<std::string, std::string>& report_templates();  // by the names of their files, without .html
std::string report_style();
std::string report_script();

}  // namespace icebow
