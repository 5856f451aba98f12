#include "reports/html/packed_text.h"

#include <zlib.h>

#include "base/errors.h"
#include "reports/text/text_format.h"

namespace icebow {

std::string packed(const std::string& text) {
  uLongf bytes = compressBound(static_cast<uLong>(text.size()));
  std::string out(bytes, '\0');
  const int status =
      compress2(reinterpret_cast<Bytef*>(out.data()), &bytes, reinterpret_cast<const Bytef*>(text.data()),
                static_cast<uLong>(text.size()), Z_BEST_COMPRESSION);
  if (status != Z_OK) throw RuntimeError("the report's cards cannot be packed: out of memory");
  out.resize(bytes);
  return base64(out);
}

}  // namespace icebow
