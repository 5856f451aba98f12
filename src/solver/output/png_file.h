// PNG files, still and animated (libpng).
#pragma once

#include <string>
#include <vector>

#include "solver/output/raster.h"

namespace icebow {

// The file is complete or absent. Throws RuntimeError naming it.
void write_png(const std::string& path, const Raster& raster);
// Throws InputError naming the file where it is no PNG.
Raster read_png(const std::string& path);

// Frames of one size, each for so long [s], the last one for two seconds more, over and over: an animated PNG
// (APNG 1.0) of at most 256 colours, each frame being the rectangle that changed. Readers that know still PNG
// alone show the first frame. Throws std::invalid_argument without frames or where sizes differ, and as
// write_png() does.
void write_animated_png(const std::string& path, const std::vector<Raster>& frames, double seconds);

}  // namespace icebow
