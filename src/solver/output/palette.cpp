#include "solver/output/palette.h"

#include <algorithm>
#include <limits>
#include <numeric>

namespace icebow {
namespace {

constexpr std::size_t most_colours = 256;

std::size_t bin_of(const std::uint8_t* p) {
  return static_cast<std::size_t>(p[0] >> 3) << 10 | static_cast<std::size_t>(p[1] >> 3) << 5 | p[2] >> 3;
}

struct Bin {
  std::int64_t count = 0;
  std::array<std::int64_t, 3> sum{};
};

}  // namespace

Palette::Palette(const std::vector<Raster>& pictures) {
  std::vector<Bin> all(bins);
  for (const Raster& picture : pictures)
    for (std::size_t at = 0; at + 2 < picture.rgb.size(); at += 3) {
      Bin& bin = all[bin_of(&picture.rgb[at])];
      ++bin.count;
      for (std::size_t c = 0; c < 3; ++c) bin.sum[c] += picture.rgb[at + c];
    }
  std::vector<std::size_t> used;
  for (std::size_t bin = 0; bin < bins; ++bin)
    if (all[bin].count > 0) used.push_back(bin);
  std::vector<std::size_t> order = used;
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return all[a].count > all[b].count; });
  order.resize(std::min(order.size(), most_colours));
  for (const std::size_t bin : order)
    for (std::size_t c = 0; c < 3; ++c)
      rgb_.push_back(static_cast<std::uint8_t>(all[bin].sum[c] / all[bin].count));
  for (const std::size_t bin : used) {
    std::int64_t least = std::numeric_limits<std::int64_t>::max();
    for (std::size_t k = 0; k < size(); ++k) {
      std::int64_t distance = 0;
      for (std::size_t c = 0; c < 3; ++c) {
        const std::int64_t apart = all[bin].sum[c] / all[bin].count - rgb_[3 * k + c];
        distance += apart * apart;
      }
      if (distance >= least) continue;
      least = distance;
      nearest_[bin] = static_cast<std::uint8_t>(k);
    }
  }
}

Indexed Palette::indexed(const Raster& picture) const {
  Indexed out{picture.width, picture.height, {}};
  out.pixels.reserve(picture.rgb.size() / 3);
  for (std::size_t at = 0; at + 2 < picture.rgb.size(); at += 3)
    out.pixels.push_back(nearest_[bin_of(&picture.rgb[at])]);
  return out;
}

Rectangle changed(const Indexed& before, const Indexed& now) {
  int left = now.width, right = -1, top = now.height, bottom = -1;
  for (int row = 0; row < now.height; ++row)
    for (int column = 0; column < now.width; ++column) {
      const std::size_t at = static_cast<std::size_t>(row) * now.width + column;
      if (before.pixels[at] == now.pixels[at]) continue;
      left = std::min(left, column), right = std::max(right, column);
      top = std::min(top, row), bottom = row;
    }
  if (right < 0) return {0, 0, 1, 1};
  return {left, top, right - left + 1, bottom - top + 1};
}

}  // namespace icebow
