#include "reports/text/inline_svg.h"

#include <regex>
#include <set>

namespace icebow {
namespace {

std::string svg_element(const std::string& text) {
  const std::size_t begin = text.find("<svg"), end = text.rfind("</svg>");
  if (begin == std::string::npos || end == std::string::npos || end < begin) return {};
  return text.substr(begin, end + 6 - begin);
}

std::set<std::string> ids_of(const std::string& svg) {
  static const std::regex id(R"re(\sid\s*=\s*["']([^"']+)["'])re");
  std::set<std::string> ids;
  for (std::sregex_iterator it(svg.begin(), svg.end(), id), end; it != end; ++it) ids.insert((*it)[1]);
  return ids;
}

// Every `before name after` becomes `before prefix name after`.
void rename_all(std::string& text, const std::string& before, const std::string& name,
                const std::string& after, const std::string& prefix) {
  const std::string wanted = before + name + after;
  const std::string replacement = before + prefix + name + after;
  for (std::size_t at = 0; (at = text.find(wanted, at)) != std::string::npos; at += replacement.size())
    text.replace(at, wanted.size(), replacement);
}

}  // namespace

std::string inline_svg(const std::string& file_text, const std::string& prefix) {
  std::string svg = svg_element(file_text);
  static const std::regex runs(R"re(<script|<foreignObject|\son[a-z]+\s*=|javascript:)re", std::regex::icase);
  if (std::regex_search(svg, runs)) return {};
  for (const std::string& id : ids_of(svg)) {
    for (const char* quote : {"\"", "'"}) {
      rename_all(svg, std::string("id=") + quote, id, quote, prefix);
      rename_all(svg, std::string("href=") + quote + '#', id, quote, prefix);
      rename_all(svg, std::string("aria-labelledby=") + quote, id, quote, prefix);
      rename_all(svg, std::string("aria-describedby=") + quote, id, quote, prefix);
    }
    rename_all(svg, "url(#", id, ")", prefix);
  }
  return svg;
}

}  // namespace icebow
