// An SVG file as part of an HTML page.
#pragma once

#include <string>

namespace icebow {

// What an allow-list takes of the <svg> element: shapes, groups, clip paths and text; attributes of place,
// form and plain paint. Ids and the references to them are prefixed, so that many drawings share one page;
// a drawing of
// ours is coloured by drawings_style(), not by its file. Empty where the text is no XML, holds no
// <svg>, or holds an element that is not on the list or an attribute that runs something: a drawing that is
// not one of ours is left out.
std::string inline_svg(const std::string& file_text, const std::string& prefix);
// CSS of lines plans and voyages, once for a page.
std::string drawings_style();

}  // namespace icebow
