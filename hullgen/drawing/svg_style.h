// How a drawing looks, by the classes of its elements: as CSS, and as plain attributes for readers without
// it.
#pragma once

#include <string>
#include <vector>

namespace icebow {

enum class DrawnFor { screen, print };

// A colour that a rule's declarations name "$name".
struct StyleColour {
  std::string name, screen, plain;  // plain: "#rrggbb"
};

// Later rules hold over earlier ones. Empty: any group, any class. `element` "svg" is the drawing itself.
struct StyleRule {
  std::string group, element, of, declarations;  // "stroke:$ink;stroke-width:1.1"
};

class SvgStyle {
 public:
  // `screen_root` is CSS ahead of the rules' own.
  SvgStyle(std::string drawing, std::vector<StyleRule> rules, std::vector<StyleColour> colours = {},
           std::string screen_root = "");

  const std::string& drawing() const { return drawing_; }  // class of the <svg> element
  // The text of a <style> element, with the screen's colours.
  std::string css() const;
  // What the rules amount to for an element of these classes (apart by spaces) within a group, with plain
  // colours: ' stroke="#1d2b36" stroke-width="1.1"', or nothing.
  std::string attributes(const std::string& element, const std::string& classes,
                         const std::string& group = "") const;
  bool knows(const std::string& style_class) const;

 private:
  std::string coloured(std::string words, std::string StyleColour::*value) const;

  std::string drawing_;
  std::vector<StyleRule> rules_;
  std::vector<StyleColour> colours_;
  std::string screen_root_;
};

}  // namespace icebow
