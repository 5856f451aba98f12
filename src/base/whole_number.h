// A whole number out of a list of doubles that a file keeps.
#pragma once

#include <cmath>
#include <cstdint>
#include <string>

#include "base/errors.h"

namespace icebow {

constexpr double most_whole = 9007199254740992.0;  // 2^53: larger ones are not all doubles

// Throws RuntimeError with `trouble` for a fraction, no number, and one outside of `least` ... `most`.
inline std::int64_t whole_number(double value, double least, double most, const std::string& trouble) {
  if (!(value >= least && value <= most && std::floor(value) == value)) throw RuntimeError(trouble);
  return static_cast<std::int64_t>(value);
}

}  // namespace icebow
