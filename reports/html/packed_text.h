// Text that a page carries in few bytes.
#pragma once

#include <string>

namespace icebow {

// Deflated (zlib's format) and in base64: what a browser's DecompressionStream("deflate") opens.
std::string packed(const std::string& text);

}  // namespace icebow
