// Colours and strokes of a lines plan.
#pragma once

#include <string>

namespace icebow {

enum class DrawnFor { screen, print };

// The text of its <style> element.
std::string lines_style(DrawnFor reader);

}  // namespace icebow
