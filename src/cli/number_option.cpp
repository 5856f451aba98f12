#include "cli/number_option.h"

#include <charconv>

#include "base/errors.h"
#include "study/spec/spec_hints.h"

namespace icebow {

double number_option(const Arguments& arguments, const std::string& option, double fallback, double lower,
                     double upper, const std::string& unit) {
  if (!arguments.has(option)) return fallback;
  const std::string given = arguments.value(option);
  double value = 0.0;
  const char* end = given.data() + given.size();
  const auto read = std::from_chars(given.data(), end, value);
  if (read.ec == std::errc() && read.ptr == end && value >= lower && value <= upper) return value;
  throw InputError(option + " " + given + ": give a number from " + brief(lower) + " to " + brief(upper) +
                   " " + unit);
}

}  // namespace icebow
