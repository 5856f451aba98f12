// Colours and strokes of a lines plan.
#pragma once

#include <string>

#include "hullgen/lines_plan.h"

namespace icebow {

// The text of its <style> element.
std::string lines_style(DrawnFor reader);

}  // namespace icebow
