// What a child process tells its parent, each as one line of text: the progress of its run, and what the
// machine did to it.
#pragma once

#include <optional>
#include <string>

#include "solver/model/run_options.h"

namespace icebow {

std::string progress_line(const Progress& progress);                  // without the newline
std::optional<Progress> progress_from_line(const std::string& line);  // nothing where it is something else

// A full disk, a file that cannot be written: no failure of the design. Said through the pipe, for the disk
// may take no log either, and by the exit code.
std::string trouble_line(const std::string& words);
std::optional<std::string> trouble_from_line(const std::string& line);
constexpr int machine_trouble_code = 74;  // EX_IOERR of sysexits.h

}  // namespace icebow
