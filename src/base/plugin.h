// Parts of the program that are loaded when they are first asked for: the libraries under them take longer to
// load than most commands run.
#pragma once

#include <string>

namespace icebow {

// The function of that name (extern "C") in the shared library beside the program, in the folder above it, or
// where `cmake --install` puts it.
// Throws RuntimeError where there is none.
void* plugin_function(const std::string& library, const std::string& function);

}  // namespace icebow
