// Words on a raster, in letters of 5 x 7 dots.
#pragma once

#include <string>

#include "solver/output/picture_canvas.h"

namespace icebow {

// Side of a dot [px] on a picture of this width.
double letter_dot(int width_px);
// Width of one line [px].
double text_width(const std::string& words, double dot);
// `left` and `bottom` in pixels from the lower left corner. What is not printable ASCII is drawn as "?".
void draw_text(Canvas& canvas, const std::string& words, double left, double bottom, double dot,
               const Color& color);

}  // namespace icebow
