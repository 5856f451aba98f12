// An SVG file as part of an HTML page.
#pragma once

#include <string>

namespace icebow {

// The <svg> element alone (no XML prolog or doctype), its ids and the references to them prefixed so that
// many drawings share one page. Empty where the text holds no <svg>, or holds anything that runs (a script,
// an on... attribute).
std::string inline_svg(const std::string& file_text, const std::string& prefix);

}  // namespace icebow
