// What a report reads beside the store: a history, a drawing, a hull; and the lists of a checkpoint.
#include <cstdlib>
#include <cstring>

#include "base/errors.h"
#include "reports/content/history_file.h"
#include "reports/content/hull_outline.h"
#include "reports/content/inline_svg.h"
#include "solver/watch/detached_ice.h"
#include "tests/fuzz/memory_file.h"

using namespace icebow;

namespace {

void read_lists(const std::uint8_t* data, std::size_t size) {
  std::vector<double> list(size / sizeof(double));
  if (!list.empty()) std::memcpy(list.data(), data, list.size() * sizeof(double));
  try {
    DetachedIceCount count;
    count.restore(list);
  } catch (const RuntimeError&) {
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  const std::string text(reinterpret_cast<const char*>(data) + 1, size - 1);
  switch (data[0] % 4) {
    case 0:
      thinned(read_load_series(memory_file(".csv", data + 1, size - 1), 25.0, 100.0), 100);
      break;
    case 1: {
      const std::string svg = inline_svg(text, "d-");
      for (const char* banned : {"<script", "javascript:", "http:", "onload", "<foreignObject"})
        if (svg.find(std::string(banned) + "=") != std::string::npos ||
            svg.find("<script") != std::string::npos)
          std::abort();
      break;
    }
    case 2:
      bow_outline(read_waterline(memory_file(".obj", data + 1, size - 1)), 30.0, 1.0);
      break;
    default:
      read_lists(data + 1, size - 1);
  }
  return 0;
}
