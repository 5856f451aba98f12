// A small template: {{name}} is replaced, {{#name}} ... {{/name}} stays only where the name is given and not
// empty,
// {{^name}} ... {{/name}} only where it is not.
#pragma once

#include <map>
#include <string>

namespace icebow {

// Values go in as they are: escape them first. Throws std::logic_error for a name that has no value.
std::string filled(const std::string& page_template, const std::map<std::string, std::string>& values);

}  // namespace icebow
