// Where, when and by what a result was made.
#pragma once

#include <string>

namespace icebow {

std::string program_version();
std::string host_name();
std::string utc_now();  // "2026-11-22T15:43:32Z"

}  // namespace icebow
