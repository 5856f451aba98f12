// Small study files, and the mistakes that the reader finds in them.
#pragma once

#include <catch2/catch.hpp>
#include <cmath>
#include <string>
#include <vector>

#include "base/errors.h"
#include "base/json.h"
#include "study/spec/read_study.h"

namespace icebow {

inline Json minimal() {
  return Json::parse(R"({"icebow_study": 1,
    "bow": {"family": "straight_parallel_buttocks", "length_m": 147.2, "beam_m": 23.0, "draft_m": 8.0, "depth_m": 13.5,
            "bow_length_m": 32.5, "stem_deg": 24.35, "waterline_deg": 22.0, "buttock_deg": 28.0, "flare_deg": 33.0},
    "ice": {"thickness_m": 1.0},
    "operation": {"speed_kn": 4.0}})");
}

inline Json with(const std::string& patch) {
  Json document = minimal();
  document.merge_patch(Json::parse(patch));
  return document;
}

inline std::vector<Mistake> mistakes_of(const Json& document) {
  try {
    read_study(document, "t.json");
  } catch (const InputError& e) {
    return e.mistakes();
  }
  return {};
}

inline Mistake only_mistake(const Json& document) {
  const auto mistakes = mistakes_of(document);
  REQUIRE(mistakes.size() == 1);
  return mistakes[0];
}

inline void check_ulps(double value, double expected) {
  CHECK(std::abs(value - expected) <= 2.3e-16 * 2 * std::abs(expected));  // but for the last two places
}

}  // namespace icebow
