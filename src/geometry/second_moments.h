// Length and direction of a set of equal squares from its second moments.
#pragma once

#include <algorithm>
#include <cmath>

namespace icebow {

// Sides of the rectangle with the same second moments.
struct MainAxes {
  double length = 0.0, width = 0.0;  //!< [m]
  double direction = 0.0;            //!< of the length to the x axis, -pi/2 .. pi/2 [rad]
};

class SecondMoments {
 public:
  void add(double x, double y) {
    if (n_ == 0.0) x0_ = x, y0_ = y;  // near the middle, so that little cancels
    x -= x0_, y -= y0_;
    n_ += 1.0;
    x_ += x, y_ += y;
    xx_ += x * x, xy_ += x * y, yy_ += y * y;
  }
  double x() const { return x0_ + x_ / n_; }  // of the centre
  double y() const { return y0_ + y_ / n_; }

  // The squares have this side, and at least one was added. A rectangle of sides a, b has a^2/12, b^2/12.
  MainAxes axes(double side) const {
    const double own = side * side / 12.0, mx = x_ / n_, my = y_ / n_;
    const double xx = xx_ / n_ - mx * mx + own, yy = yy_ / n_ - my * my + own, xy = xy_ / n_ - mx * my;
    const double mean = 0.5 * (xx + yy), radius = std::hypot(0.5 * (xx - yy), xy);
    return {std::sqrt(12.0 * (mean + radius)), std::sqrt(12.0 * std::max(mean - radius, own)),
            0.5 * std::atan2(2.0 * xy, xx - yy)};
  }

 private:
  double n_ = 0.0, x0_ = 0.0, y0_ = 0.0, x_ = 0.0, y_ = 0.0, xx_ = 0.0, xy_ = 0.0, yy_ = 0.0;
};

}  // namespace icebow
