// Numbers and words of a JSON tree in which any key may be absent: every look-up has an answer.
#pragma once

#include <cmath>
#include <limits>
#include <string>

#include "base/json.h"

namespace icebow {

// JSON has no number for what is not finite.
inline Json finite_or_null(double value) {
  return std::isfinite(value) ? Json(value) : Json(nullptr);
}

// null where it is absent, and where `pointer` is none, like "/a~b" of a name that somebody else chose.
inline const Json& part_at(const Json& json, const std::string& pointer) {
  static const Json nothing;
  try {
    const Json::json_pointer at(pointer);
    return json.contains(at) ? json.at(at) : nothing;
  } catch (const Json::exception&) {
    return nothing;
  }
}

// `pointer` like "/metrics/full_scale/mean_load_N". NaN where it is absent, null or no number.
inline double number_at(const Json& json, const std::string& pointer) {
  const Json& value = part_at(json, pointer);
  return value.is_number() ? value.get<double>() : std::numeric_limits<double>::quiet_NaN();
}

inline std::string text_at(const Json& json, const std::string& pointer) {
  const Json& value = part_at(json, pointer);
  return value.is_string() ? value.get<std::string>() : std::string();
}

inline bool is_false_at(const Json& json, const std::string& pointer) {
  const Json& value = part_at(json, pointer);
  return value.is_boolean() && !value.get<bool>();
}

}  // namespace icebow
