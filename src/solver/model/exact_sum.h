// Sums that do not depend on the order of their terms, so neither on the number of ranks: whole multiples of
// a quantum in 64-bit integers.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>

#include "base/communicator.h"
#include "base/vec.h"

namespace icebow {

// Rounded, halves to even; at most 1e13, so that no sum overflows: a value that is no number counts as that.
inline std::int64_t whole_multiples(double value, double quantum) {
  constexpr double most = 1e13;
  const double count = value / quantum;
  if (!(std::abs(count) < most)) return static_cast<std::int64_t>(count < 0.0 ? -most : most);
  return std::llrint(count);
}

// Impulse and angular impulse of the ice on the hull over one sampling interval.
class ExactImpulse {
 public:
  using Counts = std::array<std::int64_t, 6>;

  // Resolution 2^-36 of the momentum m V of a particle that moves with the ship: sums of 10^8 such terms
  // still fit.
  ExactImpulse(double particle_mass, double V, double dx)
      : linear_(std::ldexp(particle_mass * V, -36)), angular_(linear_ * dx) {}

  void add(const Vec3& impulse, const Vec3& arm) {
    const Vec3 moment(arm.y() * impulse.z() - arm.z() * impulse.y(),
                      arm.z() * impulse.x() - arm.x() * impulse.z(),
                      arm.x() * impulse.y() - arm.y() * impulse.x());
    for (int c = 0; c < 3; ++c) {
      counts_[c] += std::llrint(impulse[c] / linear_);
      counts_[c + 3] += std::llrint(moment[c] / angular_);
    }
  }
  Counts& counts() { return counts_; }
  const Counts& counts() const { return counts_; }
  double linear() const { return linear_; }
  double angular() const { return angular_; }

 private:
  double linear_, angular_;
  Counts counts_{};
};

}  // namespace icebow
