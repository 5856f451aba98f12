// How the ice broke, for a terminal.
#pragma once

#include <string>

#include "study/plan/ranking.h"

namespace icebow {

// A line a ranked design; empty where none was simulated.
std::string process_table(const Ranking& ranking);
// A few lines on one result; empty where it has no "process".
std::string process_text(const Json& result);

}  // namespace icebow
