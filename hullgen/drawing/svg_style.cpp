#include "hullgen/drawing/svg_style.h"

#include <algorithm>
#include <sstream>
#include <utility>

namespace icebow {
namespace {

bool has_class(const std::string& classes, const std::string& one) {
  std::istringstream list(classes);
  for (std::string name; list >> name;)
    if (name == one) return true;
  return false;
}

// A "background" is CSS alone.
bool is_attribute(const std::string& property) {
  return property != "background";
}

}  // namespace

SvgStyle::SvgStyle(std::string drawing, std::vector<StyleRule> rules, std::vector<StyleColour> colours,
                   std::string screen_root)
    : drawing_(std::move(drawing)),
      rules_(std::move(rules)),
      colours_(std::move(colours)),
      screen_root_(std::move(screen_root)) {}

std::string SvgStyle::coloured(std::string words, std::string StyleColour::*value) const {
  for (const StyleColour& colour : colours_) {
    const std::string name = "$" + colour.name, &put = colour.*value;
    for (std::size_t at = words.find(name); at != std::string::npos; at = words.find(name, at + put.size()))
      words.replace(at, name.size(), put);
  }
  return words;
}

std::string SvgStyle::css() const {
  // Readers that know no variables pass over the whole and keep the attributes.
  std::string out = "@supports (color: var(--a)) {\n" + screen_root_;
  for (const StyleRule& rule : rules_) {
    out += "." + drawing_;
    if (!rule.group.empty()) out += " ." + rule.group;
    if (rule.element != "svg") out += " " + rule.element;
    if (!rule.of.empty()) out += "." + rule.of;
    out += "{" + rule.declarations + "}\n";
  }
  return coloured(out + "}\n", &StyleColour::screen);
}

std::string SvgStyle::attributes(const std::string& element, const std::string& classes,
                                 const std::string& group) const {
  std::vector<std::pair<std::string, std::string>> list;
  for (const StyleRule& rule : rules_) {
    const bool holds = rule.element == element && (rule.group.empty() || rule.group == group) &&
                       (rule.of.empty() || has_class(classes, rule.of));
    if (!holds) continue;
    std::istringstream declarations(rule.declarations);
    for (std::string one; std::getline(declarations, one, ';');) {
      const std::string property = one.substr(0, one.find(':')), value = one.substr(one.find(':') + 1);
      const auto known =
          std::find_if(list.begin(), list.end(), [&](const auto& entry) { return entry.first == property; });
      if (known != list.end())
        known->second = value;
      else if (is_attribute(property))
        list.emplace_back(property, value);
    }
  }
  std::string out;
  for (const auto& [property, value] : list) out += " " + property + "=\"" + value + "\"";
  return coloured(out, &StyleColour::plain);
}

bool SvgStyle::knows(const std::string& style_class) const {
  return style_class == drawing_ || std::any_of(rules_.begin(), rules_.end(), [&](const StyleRule& rule) {
           return style_class == rule.of || style_class == rule.group;
         });
}

}  // namespace icebow
