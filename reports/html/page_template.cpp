#include "reports/html/page_template.h"

#include <stdexcept>

namespace icebow {
namespace {

using Values = std::map<std::string, std::string>;

const std::string& value_of(const Values& values, const std::string& name) {
  const auto it = values.find(name);
  if (it == values.end()) throw std::logic_error("report template: no value for " + name);
  return it->second;
}

}  // namespace

std::string filled(const std::string& text, const Values& values) {
  std::string out;
  std::size_t at = 0;
  for (;;) {
    const std::size_t open = text.find("{{", at);
    if (open == std::string::npos) return out.append(text, at);
    const std::size_t close = text.find("}}", open);
    if (close == std::string::npos) throw std::logic_error("report template: {{ without }}");
    out.append(text, at, open - at);
    const std::string name = text.substr(open + 2, close - open - 2);
    at = close + 2;
    if (name[0] != '#' && name[0] != '^') {
      out += value_of(values, name);
      continue;
    }
    const std::string end_tag = "{{/" + name.substr(1) + "}}";
    const std::size_t end = text.find(end_tag, at);
    if (end == std::string::npos) throw std::logic_error("report template: no " + end_tag);
    const bool given = !value_of(values, name.substr(1)).empty();
    if (given == (name[0] == '#')) out += filled(text.substr(at, end - at), values);
    at = end + end_tag.size();
  }
}

}  // namespace icebow
