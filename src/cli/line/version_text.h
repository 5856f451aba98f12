// What `icebow --version` says: which program this is, and what it was built with.
#pragma once

#include <string>

namespace icebow {

// The first line is "icebow 0.1.0"; then one line each of commit, compiler, MPI, vector width and optional
// parts. Throws InputError where ICEBOW_KERNEL names a width this processor does not have.
std::string version_text();

}  // namespace icebow
