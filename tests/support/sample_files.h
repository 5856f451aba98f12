// Small stand-ins for the files of one design.
#pragma once

#include <string>

namespace icebow {

// Half hull of quads around z = 0: entrance angle [deg], bow length [m], beam 23 m.
std::string sample_hull_obj(double waterline_deg, double bow_length);
// A drawing with ids, references to them and a title to escape.
std::string sample_lines_svg(const std::string& title, double stem_deg, double waterline_deg);
// Broken ice seen from above. Throws RuntimeError.
void write_sample_picture(const std::string& path, int width_px, double advance, unsigned seed);

}  // namespace icebow
