#include "solver/output/animation.h"

#include <algorithm>

#include "base/errors.h"
#include "solver/output/png_file.h"

namespace icebow {
namespace {

constexpr std::size_t most_frames = 100;  // two hundred megabytes of pixels

// Equally spaced, the last one kept.
std::vector<std::string> spread(const std::vector<std::string>& pictures) {
  const std::size_t n = pictures.size(), most = std::min(n, most_frames);
  std::vector<std::string> kept;
  for (std::size_t k = 1; k <= most; ++k) kept.push_back(pictures[k * n / most - 1]);
  return kept;
}

}  // namespace

void animate_pictures(const std::string& path, const std::vector<std::string>& pictures, double seconds) {
  std::vector<Raster> frames;
  for (const std::string& picture : spread(pictures)) {
    frames.push_back(read_png(picture));
    const Raster &first = frames.front(), &last = frames.back();
    if (last.width != first.width || last.height != first.height)
      throw InputError(picture + ": " + std::to_string(last.width) + " x " + std::to_string(last.height) +
                       " pixels, the first picture has " + std::to_string(first.width) + " x " +
                       std::to_string(first.height));
  }
  const auto count = static_cast<double>(frames.size());
  write_animated_png(path, frames, seconds > 0.0 ? seconds : std::min(1.0, 5.0 / std::max(1.0, count)));
}

}  // namespace icebow
