// Colours and strokes of a lines plan.
#pragma once

#include "hullgen/drawing/svg_style.h"

namespace icebow {

const SvgStyle& lines_style();

}  // namespace icebow
