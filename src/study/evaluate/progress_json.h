// Progress of a run as one line of text, from a child process to its parent.
#pragma once

#include <optional>
#include <string>

#include "solver/model/run_options.h"

namespace icebow {

std::string progress_line(const Progress& progress);                  // without the newline
std::optional<Progress> progress_from_line(const std::string& line);  // nothing where it is something else

}  // namespace icebow
