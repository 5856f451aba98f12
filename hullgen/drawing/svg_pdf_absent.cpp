// Stands in for svg_pdf.cpp in a build without librsvg.
#include "base/errors.h"
#include "hullgen/drawing/svg_pdf.h"

namespace icebow {

std::string why_no_pdf() {
  return "this program was built without PDF (librsvg): install librsvg2-dev, configure with -DICEBOW_PDF=ON "
         "and build "
         "again, or draw an .svg";
}

void write_pdf(const std::string& path, const std::string&, const std::string&) {
  throw InputError(path + ": " + why_no_pdf());
}

}  // namespace icebow
