// An SVG drawing as a PDF page of vectors and text, through librsvg and cairo. Built in where CMake finds
// those (option ICEBOW_PDF).
#pragma once

#include <string>

namespace icebow {

// "" where PDF is built in; otherwise why not and what to do, to stand behind a file's name.
std::string why_no_pdf();

// One page of the drawing's own size, 96 px to the inch. The drawing may not use CSS variables. Throws
// InputError where it is not built in, RuntimeError where the drawing cannot be read or the file cannot be
// written.
void write_pdf(const std::string& path, const std::string& svg, const std::string& title);

}  // namespace icebow
