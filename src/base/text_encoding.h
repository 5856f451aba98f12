// Whether bytes are text that our readers take whole.
#pragma once

#include <string>

namespace icebow {

// "is UTF-16 text; save it as UTF-8" and the like; empty where it may be UTF-8. Readers of text take a zero
// byte for its end: what stands behind one would be left out without a word.
std::string why_no_text(const std::string& text);

}  // namespace icebow
