// Stands in front of svg_pdf.cpp, which is loaded with librsvg and cairo when a page is first written.
#include "base/plugin.h"
#include "hullgen/drawing/svg_pdf.h"

namespace icebow {

std::string why_no_pdf() {
  return "";
}

void write_pdf(const std::string& path, const std::string& svg, const std::string& title) {
  using Write = void (*)(const std::string&, const std::string&, const std::string&);
  static const auto write = reinterpret_cast<Write>(plugin_function("libicebow_pdf.so", "icebow_write_pdf"));
  write(path, svg, title);
}

}  // namespace icebow
