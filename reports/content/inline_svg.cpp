#include "reports/content/inline_svg.h"

#include <algorithm>
#include <pugixml.hpp>
#include <set>
#include <sstream>

#include "hullgen/drawing/lines_style.h"
#include "study/evaluate/voyage_picture.h"

namespace icebow {
namespace {

using Names = std::set<std::string>;

constexpr int most_levels = 32;
constexpr const char* svg_namespace = "http://www.w3.org/2000/svg";

const Names shapes = {"path", "line", "polyline", "polygon", "rect", "circle", "ellipse"};
const Names containers = {"svg", "g", "defs", "clipPath"};
const Names words = {"text", "tspan", "title", "desc"};

// Numbers, lists of numbers and plain words: none of them names a place to load from.
const Names plain = {
    "d",           "x",           "y",         "x1",          "y1",           "x2",
    "y2",          "cx",          "cy",        "r",           "rx",           "ry",
    "dx",          "dy",          "width",     "height",      "points",       "transform",
    "viewBox",     "role",        "fill",      "stroke",      "stroke-width", "stroke-dasharray",
    "fill-rule",   "text-anchor", "font-size", "font-weight", "fill-opacity", "stroke-opacity",
    "aria-hidden", "paint-order"};

// Left to drawings_style() in a drawing of ours: the page then colours it by its theme, and is smaller.
const Names looks = {"fill",           "stroke",      "stroke-width", "stroke-dasharray", "fill-opacity",
                     "stroke-opacity", "paint-order", "font-size",    "font-weight"};

bool only_of(const std::string& text, const char* allowed) {
  return std::all_of(text.begin(), text.end(), [&](unsigned char c) {
    return (c < 0x80 && std::isalnum(c)) ||
           std::string(allowed).find(static_cast<char>(c)) != std::string::npos;
  });
}

bool is_id(const std::string& text) {
  return !text.empty() && text.size() <= 100 && only_of(text, "-_.");
}

// Classes that the styles of our drawings know; the page's own would let a drawing pose as a part of it.
std::string known_classes(const std::string& text) {
  std::istringstream list(text);
  std::string known;
  for (std::string name; list >> name;)
    if (lines_style().knows(name) || voyage_style().knows(name)) known += (known.empty() ? "" : " ") + name;
  return known;
}

bool is_ours(const std::string& drawing) {
  return drawing == lines_style().drawing() || drawing == voyage_style().drawing();
}

class Copy {
 public:
  Copy(const std::string& prefix, bool is_ours) : prefix_(prefix), is_ours_(is_ours) {}

  // False where the drawing is to be left out.
  bool element(const pugi::xml_node& from, pugi::xml_node to, int level) {
    const std::string name = from.name();
    const bool bears_words = words.count(name) > 0;
    if (level > most_levels || (!bears_words && !shapes.count(name) && !containers.count(name))) return false;
    for (const pugi::xml_attribute& a : from.attributes())
      if (!attribute(a, to)) return false;
    for (const pugi::xml_node& child : from.children())
      if (!child_of(child, to, bears_words, level)) return false;
    return true;
  }

 private:
  bool child_of(const pugi::xml_node& child, pugi::xml_node to, bool bears_words, int level) {
    const bool text = child.type() == pugi::node_pcdata || child.type() == pugi::node_cdata;
    if (text && bears_words) to.append_child(pugi::node_pcdata).set_value(child.value());
    if (child.type() != pugi::node_element || std::string(child.name()) == "style") return true;
    const std::string parent = to.name();
    if (parent == "title" || parent == "desc") return false;  // HTML reads what stands there as its own
    return element(child, to.append_child(child.name()), level + 1);
  }

  bool attribute(const pugi::xml_attribute& a, pugi::xml_node to) {
    const std::string name = a.name(), value = a.value();
    if (name.size() > 2 && (name[0] == 'o' || name[0] == 'O') && (name[1] == 'n' || name[1] == 'N'))
      return false;
    std::string kept;
    if (name == "id" && is_id(value)) kept = prefix_ + value;
    if (name == "class") kept = known_classes(value);
    if (name == "xmlns" && value == svg_namespace) kept = value;
    if (name == "clip-path") kept = reference(value);
    if (name == "aria-labelledby" || name == "aria-describedby") kept = is_id(value) ? prefix_ + value : "";
    if (plain.count(name) && only_of(value, " \t\n-+.,#%()")) kept = value;
    if (is_ours_ && looks.count(name)) kept.clear();
    if (value.find("url(") != std::string::npos && name != "clip-path") kept.clear();
    if (!kept.empty()) to.append_attribute(name.c_str()).set_value(kept.c_str());
    return true;
  }

  // "url(#a)" alone.
  std::string reference(const std::string& value) const {
    if (value.rfind("url(#", 0) != 0 || value.back() != ')') return "";
    const std::string id = value.substr(5, value.size() - 6);
    return is_id(id) ? "url(#" + prefix_ + id + ")" : "";
  }

  std::string prefix_;
  bool is_ours_;
};

}  // namespace

std::string inline_svg(const std::string& file_text, const std::string& prefix) {
  pugi::xml_document file, page;
  const unsigned options = pugi::parse_default | pugi::parse_ws_pcdata_single;
  if (!file.load_buffer(file_text.data(), file_text.size(), options, pugi::encoding_utf8)) return {};
  const pugi::xml_node drawing = file.document_element();
  if (std::string(drawing.name()) != "svg") return {};
  const bool ours = is_ours(drawing.attribute("class").value());
  if (!Copy(prefix, ours).element(drawing, page.append_child("svg"), 1)) return {};
  std::ostringstream out;
  page.save(out, "", pugi::format_raw | pugi::format_no_declaration, pugi::encoding_utf8);
  return out.str();
}

std::string drawings_style() {
  return lines_style().css() + voyage_style().css();
}

}  // namespace icebow
