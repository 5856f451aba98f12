// Words for inputs a formula cannot take.
#pragma once

#include <initializer_list>
#include <string>

namespace icebow {

struct NamedValue {
  const char* name;
  double value;
};

// "" where every value is finite and positive, else e.g. "h is -0.5, must be positive". NaN does not pass.
std::string not_positive(std::initializer_list<NamedValue> values);
// "" where every value is finite and not negative.
std::string negative(std::initializer_list<NamedValue> values);
// "" inside [lower, upper], else e.g. "stem 14 deg is outside 15 to 45 deg". All in radians.
std::string outside_degrees(const NamedValue& angle, double lower, double upper);
// Six significant digits.
std::string in_words(double value);

}  // namespace icebow
