// Names of designs, which are names of directories too.
#pragma once

#include <string>

namespace icebow {

// As a study file may give it: 1 to 64 characters, letters or digits of ASCII or anything printable beyond it
// first, then also space . _ + ( ) -, at most 200 bytes: with what the program adds a file system still takes
// it.
bool is_design_name(const std::string& name);

// "d001" ...: the program's own names, of the points of a method.
bool is_numbered_name(const std::string& name);

// As a store may hold it, with what the program and other versions of it add: nothing that leads out of the
// directory of designs, is hidden there, or commands a terminal.
bool is_stored_name(const std::string& name);

}  // namespace icebow
