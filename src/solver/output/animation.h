// The pictures of a run one after the other.
#pragma once

#include <string>
#include <vector>

namespace icebow {

constexpr const char* animation_name = "breaking.png";  // in a run's directory

// An animated PNG of the pictures, a hundred at most, `seconds` each; 0 = as long as makes five seconds of
// all, a second each at most. Throws InputError naming a picture that is none, or of another size than the
// first, RuntimeError where `path` cannot be written, std::invalid_argument without pictures.
void animate_pictures(const std::string& path, const std::vector<std::string>& pictures,
                      double seconds = 0.0);

}  // namespace icebow
