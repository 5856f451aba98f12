#include "cycle/ice_strip.h"

#include <algorithm>
#include <cmath>

namespace icebow::cycle {
namespace {

constexpr double sliver = 1e-9;  // [m] shorter intervals are rounding

bool touch(const Interval& a, const Interval& b) {
  return a.from < b.to && b.from < a.to;
}

using Marks = std::vector<std::vector<char>>;  // [strip - first][interval]: hangs on the sheet

// One pass over neighbours; whether anything was found to hang on the sheet.
bool spread(const std::vector<IceStrip>& ice, Marks& held, int first, int from, int to) {
  bool changed = false;
  const auto at = [&](int strip) -> const std::vector<Interval>& {
    return ice[static_cast<std::size_t>(strip)].intervals();
  };
  const int by = from < to ? 1 : -1;
  for (int strip = from + by; strip != to + by; strip += by) {
    auto& mine = held[static_cast<std::size_t>(strip - first)];
    const auto& theirs = held[static_cast<std::size_t>(strip - by - first)];
    for (std::size_t i = 0; i < mine.size(); ++i) {
      for (std::size_t j = 0; j < theirs.size() && !mine[i]; ++j)
        if (theirs[j] && touch(at(strip)[i], at(strip - by)[j])) mine[i] = 1, changed = true;
    }
  }
  return changed;
}

}  // namespace

bool IceStrip::holds(double x) const {
  return std::any_of(intervals_.begin(), intervals_.end(),
                     [&](const Interval& i) { return x >= i.from && x < i.to; });
}

void IceStrip::trim(double x) {
  std::size_t gone = 0;
  while (gone < intervals_.size() && intervals_[gone].to <= x + sliver) ++gone;
  intervals_.erase(intervals_.begin(), intervals_.begin() + static_cast<std::ptrdiff_t>(gone));
  if (!intervals_.empty()) intervals_.front().from = std::max(intervals_.front().from, x);
}

double IceStrip::cut(double from, double to) {
  double removed = 0.0;
  std::vector<Interval> left;
  for (const Interval& i : intervals_) {
    const double a = std::max(i.from, from), b = std::min(i.to, to);
    if (b <= a) {
      left.push_back(i);
      continue;
    }
    removed += b - a;
    if (a - i.from > sliver) left.push_back({i.from, a, i.memory});
    if (i.to - b > sliver) left.push_back({b, i.to, 0.0});
  }
  intervals_ = std::move(left);
  return removed;
}

double drop_islands(std::vector<IceStrip>& ice, const std::vector<double>& width, int first, int last) {
  Marks held;
  for (int strip = first; strip <= last; ++strip) {
    const auto& intervals = ice[static_cast<std::size_t>(strip)].intervals();
    auto& mine = held.emplace_back(intervals.size(), char{0});
    for (std::size_t i = 0; i < intervals.size(); ++i)  // beyond the range all is held
      mine[i] = std::isinf(intervals[i].to) || (strip == first && first > 0) ||
                (strip == last && last + 1 < static_cast<int>(ice.size()));
  }
  while (spread(ice, held, first, first, last) | spread(ice, held, first, last, first)) {
  }
  double area = 0.0;
  for (int strip = first; strip <= last; ++strip) {
    auto& intervals = ice[static_cast<std::size_t>(strip)].intervals();
    const auto& mine = held[static_cast<std::size_t>(strip - first)];
    std::size_t kept = 0;
    for (std::size_t i = 0; i < intervals.size(); ++i) {
      if (mine[i])
        intervals[kept++] = intervals[i];
      else
        area += (intervals[i].to - intervals[i].from) * width[static_cast<std::size_t>(strip)];
    }
    intervals.resize(kept);
  }
  return area;
}

}  // namespace icebow::cycle
