// The templates in reports/html/templates (Mustache) filled with values: the only place where text becomes
// HTML.
#pragma once

#include <string>

#include "base/json.h"

namespace icebow {

// {{name}} is escaped, {{{name}}} goes in as it is, {{#name}} ... {{/name}} repeats for each element of a
// list and stays where the value is given, {{^name}} stays where it is not, {{> name}} is another template.
// Given: a text that is not empty, true, an object, a list with elements. A number goes in as JSON writes it;
// null is not given. Throws std::logic_error for a name that has no value, for an unknown template and for
// one that cannot be parsed.
std::string rendered(const std::string& template_name, const Json& values);
// The same of a text that is no template of the page.
std::string rendered_text(const std::string& text, const Json& values);

}  // namespace icebow
