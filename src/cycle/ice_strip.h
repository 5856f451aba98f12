// The level ice as intervals along the course, strip by strip.
#pragma once

#include <limits>
#include <vector>

namespace icebow::cycle {

struct Interval {
  double from = 0.0, to = 0.0;  //!< [m] along the course
  double memory = 0.0;          //!< deepest the hull has come into this edge [m]; 0 = not touched
};

// Ice from x = 0 on, without end ahead.
class IceStrip {
 public:
  static constexpr double ahead = std::numeric_limits<double>::infinity();

  IceStrip() : intervals_{{0.0, ahead, 0.0}} {}

  std::vector<Interval>& intervals() { return intervals_; }
  const std::vector<Interval>& intervals() const { return intervals_; }

  bool holds(double x) const;
  // What lies before x is gone.
  void trim(double x);
  // Takes the ice between the two places out; returns its length [m].
  double cut(double from, double to);

 private:
  std::vector<Interval> intervals_;  // ascending, apart
};

// Takes out intervals between `first` and `last` that hang on nothing that goes on ahead; returns the area
// [m^2].
double drop_islands(std::vector<IceStrip>& ice, const std::vector<double>& width, int first, int last);

}  // namespace icebow::cycle
