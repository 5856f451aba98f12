#include "formula/guards.h"

#include <cmath>
#include <sstream>

#include "base/units.h"

namespace icebow {

std::string in_words(double value) {
  std::ostringstream text;
  text << value;
  return text.str();
}

std::string not_positive(std::initializer_list<NamedValue> values) {
  for (const NamedValue& v : values)
    if (!std::isfinite(v.value) || v.value <= 0.0)
      return std::string(v.name) + " is " + in_words(v.value) + ", must be positive";
  return "";
}

std::string negative(std::initializer_list<NamedValue> values) {
  for (const NamedValue& v : values)
    if (!std::isfinite(v.value) || v.value < 0.0)
      return std::string(v.name) + " is " + in_words(v.value) + ", must not be negative";
  return "";
}

std::string outside_degrees(const NamedValue& angle, double lower, double upper) {
  if (angle.value >= lower && angle.value <= upper) return "";
  return std::string(angle.name) + " " + in_words(degrees(angle.value)) + " deg is outside " +
         in_words(degrees(lower)) + " to " + in_words(degrees(upper)) + " deg";
}

}  // namespace icebow
