// Two runs with the same record, bit for bit.
#pragma once

#include <catch2/catch.hpp>
#include <cmath>
#include <cstring>

#include "solver/model/history.h"

namespace icebow {

// Both of no damage at all: NaN.
inline bool same_number(double a, double b) {
  return a == b || (std::isnan(a) && std::isnan(b));
}

inline void check_same_record(const History& a, const History& b) {
  static_assert(sizeof(HistoryRow) == 20 * sizeof(double), "no gaps between the fields that are compared");
  REQUIRE(a.rows.size() == b.rows.size());
  for (std::size_t n = 0; n < b.rows.size(); ++n) {
    const HistoryRow &x = a.rows[n], &y = b.rows[n];
    INFO("sample " << n << " of " << b.rows.size());
    CHECK(x.broken_bonds == y.broken_bonds);
    CHECK(std::memcmp(&x.F, &y.F, sizeof x.F) == 0);
    CHECK(std::memcmp(&x, &y, sizeof x) == 0);  // NaN where a number was not evaluated
  }
}

}  // namespace icebow
