// What stands around a picture: its title above it, its colours' meaning below it, its scale on it.
#pragma once

#include <string>
#include <vector>

#include "solver/output/picture_canvas.h"

namespace icebow {

struct LegendEntry {
  Color color;
  std::string words;
};

// Heights [px] of the strips on a picture of this width; 0 without a title or without entries.
double title_height(const std::string& title, int width_px);
double legend_height(const std::vector<LegendEntry>& entries, int width_px);

// Over whatever was drawn there.
void draw_title(Canvas& canvas, const std::string& title);
void draw_legend(Canvas& canvas, const std::vector<LegendEntry>& entries);

// A bar of 1, 2 or 5 times a power of ten metres in the lower left corner of what lies `above_px` the
// canvas's foot, with its length. A metre of the canvas is `lambda` metres of the bar.
void draw_scale_bar(Canvas& canvas, double lambda, double above_px);

}  // namespace icebow
