// Pictures in the 256 colours that they use most.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "solver/output/raster.h"

namespace icebow {

struct Indexed {
  int width = 0, height = 0;
  std::vector<std::uint8_t> pixels;  // places in a palette
};

struct Rectangle {
  int left = 0, top = 0, width = 0, height = 0;  //!< [px]
};

class Palette {
 public:
  // Colours are told apart by the upper five bits of a channel. The most frequent ones of all pictures enter.
  explicit Palette(const std::vector<Raster>& pictures);

  std::size_t size() const { return rgb_.size() / 3; }
  const std::vector<std::uint8_t>& rgb() const { return rgb_; }  // three bytes a colour
  // Every pixel by the nearest colour.
  Indexed indexed(const Raster& picture) const;

 private:
  static constexpr std::size_t bins = 1u << 15;

  std::vector<std::uint8_t> rgb_;
  std::vector<std::uint8_t> nearest_ = std::vector<std::uint8_t>(bins, 0);  // of each bin
};

// The smallest rectangle outside which two pictures of one size are the same; one pixel where they are the
// same everywhere.
Rectangle changed(const Indexed& before, const Indexed& now);

}  // namespace icebow
