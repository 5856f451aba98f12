// A picture in memory.
#pragma once

#include <cstdint>
#include <vector>

namespace icebow {

struct Raster {
  int width = 0, height = 0;
  std::vector<std::uint8_t> rgb;  // three bytes a pixel, top row first
};

}  // namespace icebow
