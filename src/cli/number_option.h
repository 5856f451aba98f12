// Numbers and lengths among the options of a command.
#pragma once

#include "cli/line/arguments.h"

namespace icebow {

// The fallback where the option is not given. Throws InputError naming the option, what was given and the
// allowed range where it is not a number from lower to upper; `unit` is for that message.
double number_option(const Arguments& arguments, const std::string& option, double fallback, double lower,
                     double upper, const std::string& unit);

}  // namespace icebow
