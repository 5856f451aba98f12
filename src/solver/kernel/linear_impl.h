// The linear passes over a block of a column; included by kernel_impl.h.
#pragma once

#include <algorithm>
#include <type_traits>
#include <utility>

#include "solver/kernel/kernel.h"
#include "solver/kernel/kernel_vector.h"
#include "solver/kernel/linear_weights.h"

namespace icebow {
namespace {

// Displacements of a block's surroundings, relative to the block's own: sums over a family then lose no
// digits where a floe has moved far.
template <class Real>
class Nearby {
 public:
  using S = Simd<Real>;
  using V = typename S::V;
  Nearby(const LinearFields<Real>& f, int nz, int b) {
    const std::ptrdiff_t middle = std::ptrdiff_t(b) * block + block / 2 + (nz / 2) * f.layer;
    for (int c = 0; c < 3; ++c) {
      minus_own_[c] = S::splat(-f.u[c][middle]);
      u_[c] = f.u[c];
    }
    theta_ = f.theta;
    layer_ = f.layer;
  }
  std::ptrdiff_t layer() const { return layer_; }
  V operator()(int c, std::ptrdiff_t at) const { return S::load(u_[c] + at) + minus_own_[c]; }
  V sum(int c, std::ptrdiff_t a, std::ptrdiff_t b) const { return (*this)(c, a) + (*this)(c, b); }
  V difference(int c, std::ptrdiff_t a, std::ptrdiff_t b) const {
    return S::load(u_[c] + a) - S::load(u_[c] + b);
  }
  V theta(std::ptrdiff_t at) const { return S::load(theta_ + at); }

 private:
  const Real* u_[3];
  const Real* theta_;
  std::ptrdiff_t layer_;
  V minus_own_[3];
};

#define ICEBOW_INLINE inline __attribute__((always_inline))

// Calls visit(layer) for the layers 0 .. nz - 1 with the layer as a constant: every sum stays in a register.
template <class Visit, int... l>
ICEBOW_INLINE void for_each_of(std::integer_sequence<int, l...>, Visit visit) {
  (visit(std::integral_constant<int, l>()), ...);
}
template <int nz, class Visit>
ICEBOW_INLINE void for_layers(Visit visit) {
  for_each_of(std::make_integer_sequence<int, nz>(), visit);
}

// Constants of a block's class in the order of use.
template <class Real, bool per_lane>
struct Stream {
  const Real* next;
  ICEBOW_INLINE typename Simd<Real>::V take() {
    const typename Simd<Real>::V v = Simd<Real>::template constant<per_lane>(next, 0);
    next += per_lane ? block : 1;
    return v;
  }
};

// e of the bonds of a layer `distance` below, from what all layers share: in_plane + distance up.
template <class Real, int distance>
ICEBOW_INLINE typename Simd<Real>::V slanted(typename Simd<Real>::V in_plane, typename Simd<Real>::V up) {
  if constexpr (distance == 0) return in_plane;
  if constexpr (distance == 1) return in_plane + up;
  if constexpr (distance == -1) return in_plane - up;
  return in_plane + Real(distance) * up;
}

constexpr bool bonded(int l, int m, int dk) {
  return l - m <= dk && m - l <= dk;
}

// What the bonds to a group's columns, and to their mirror images, add to theta.
template <class Real, int nz, int dk, bool per_lane, bool mirrored>
ICEBOW_INLINE void theta_of_group(const Nearby<Real>& w, const LinearGroup<Real>& g, std::ptrdiff_t x,
                                  Stream<Real, per_lane>& stream, typename Simd<Real>::V (&theta)[nz]) {
  using V = typename Simd<Real>::V;
  V sum[nz] = {};
  Stream<Real, per_lane> weights = stream;
  for (const auto& column : g.columns) {
    for_layers<nz>([&](auto m) __attribute__((always_inline)) {
      const std::ptrdiff_t row = x + m() * w.layer(), right = row + column.offset, left = row + column.mirror;
      V in_plane, up;
      if constexpr (mirrored) {
        in_plane = column.di * w.difference(0, right, left) + column.dj * w.sum(1, right, left);
        up = w.sum(2, right, left);
      } else {
        in_plane = column.di * w(0, right) + column.dj * w(1, right);
        up = w(2, right);
      }
      for_layers<nz>([&](auto l) __attribute__((always_inline)) {
        if constexpr (bonded(l(), m(), dk)) sum[l] += weights.take() * slanted<Real, m() - l()>(in_plane, up);
      });
    });
  }
  stream = weights;
  for (int l = 0; l < nz; ++l) theta[l] += sum[l];
}

// Calls visit(dk) for the group's dk, as a constant.
template <int nz, class Visit>
inline void with_layers(int dk, Visit visit) {
  constexpr int most = nz - 1 < reach ? nz - 1 : reach;
  if (dk == 0) visit(std::integral_constant<int, 0>());
  if constexpr (most >= 1) {
    if (dk == 1) visit(std::integral_constant<int, 1>());
  }
  if constexpr (most >= 2) {
    if (dk == 2) visit(std::integral_constant<int, 2>());
  }
  if constexpr (most >= 3) {
    if (dk == 3) visit(std::integral_constant<int, 3>());
  }
}

template <class Real, int nz, bool per_lane>
void linear_theta(const LinearFields<Real>& f, const LinearWeights<Real>& weights, int b) {
  using S = Simd<Real>;
  using V = typename S::V;
  const Nearby<Real> w(f, nz, b);
  for (int lane0 = 0; lane0 < block; lane0 += S::lanes) {
    const std::ptrdiff_t x = std::ptrdiff_t(b) * block + lane0;
    Stream<Real, per_lane> stream{weights.dilatation.data() + (per_lane ? lane0 : 0)},
        own{weights.own_dilatation.data() + (per_lane ? lane0 : 0)};
    V theta[nz] = {};
    for (const auto& g : *weights.groups) {
      with_layers<nz>(g.dk, [&](auto dk) {
        if constexpr (!per_lane) {
          if (g.mirrored) return theta_of_group<Real, nz, dk(), false, true>(w, g, x, stream, theta);
        }
        theta_of_group<Real, nz, dk(), per_lane, false>(w, g, x, stream, theta);
      });
    }
    for (int l = 0; l < nz; ++l) {
      for (int c = 0; c < 3; ++c) theta[l] -= own.take() * w(c, x + l * f.layer);
      S::store(f.theta + x + l * f.layer, theta[l]);
    }
  }
}

// Forces along x, y, z of the particles of a column.
template <class Real, int nz>
struct Forces {
  typename Simd<Real>::V x[nz] = {}, y[nz] = {}, z[nz] = {};
  typename Simd<Real>::V theta = {};  // the largest seen
};

template <class Real, int distance>
ICEBOW_INLINE void add_slanted(typename Simd<Real>::V& sum, typename Simd<Real>::V t) {
  sum = slanted<Real, distance>(sum, t);
}

template <class Real, int nz, int dk, bool per_lane>
ICEBOW_INLINE void force_of_group(const Nearby<Real>& w, const LinearGroup<Real>& g, std::ptrdiff_t x,
                                  Stream<Real, per_lane>& stream, Forces<Real, nz>& total) {
  using V = typename Simd<Real>::V;
  Forces<Real, nz> f = total;
  Stream<Real, per_lane> weights = stream;
  for (const auto& column : g.columns) {
    for_layers<nz>([&](auto m) __attribute__((always_inline)) {
      const std::ptrdiff_t at = x + m() * w.layer() + column.offset;
      const V in_plane = column.di * w(0, at) + column.dj * w(1, at), up = w(2, at), theta = w.theta(at);
      f.theta = Simd<Real>::max(f.theta, theta);
      for_layers<nz>([&](auto l) __attribute__((always_inline)) {
        if constexpr (bonded(l(), m(), dk)) {
          const V distortion = weights.take(), pressure = weights.take();
          const V t = distortion * slanted<Real, m() - l()>(in_plane, up) + pressure * theta;
          f.x[l] += column.di * t;
          f.y[l] += column.dj * t;
          add_slanted<Real, m() - l()>(f.z[l], t);
        }
      });
    });
  }
  stream = weights;
  total = f;
}

// Of the bonds at +di and -di: what they have in common pushes along y and z, their difference along x.
template <class Real, int nz, int dk>
ICEBOW_INLINE void force_of_mirrored(const Nearby<Real>& w, const LinearGroup<Real>& g, std::ptrdiff_t x,
                                     Stream<Real, false>& stream, Forces<Real, nz>& total) {
  using V = typename Simd<Real>::V;
  Forces<Real, nz> f = total;
  Stream<Real, false> weights = stream;
  for (const auto& column : g.columns) {
    for_layers<nz>([&](auto m) __attribute__((always_inline)) {
      const std::ptrdiff_t row = x + m() * w.layer(), right = row + column.offset, left = row + column.mirror;
      const V x_right = w(0, right), x_left = w(0, left), y_right = w(1, right), y_left = w(1, left),
              z_right = w(2, right), z_left = w(2, left), theta_right = w.theta(right),
              theta_left = w.theta(left);
      f.theta = Simd<Real>::max(f.theta, Simd<Real>::max(theta_right, theta_left));
      const V in_plane = column.di * (x_right - x_left) + column.dj * (y_right + y_left),
              up = z_right + z_left, theta = theta_right + theta_left;
      const V in_plane_odd = column.di * (x_right + x_left) + column.dj * (y_right - y_left),
              up_odd = z_right - z_left, theta_odd = theta_right - theta_left;
      for_layers<nz>([&](auto l) __attribute__((always_inline)) {
        if constexpr (bonded(l(), m(), dk)) {
          const V distortion = weights.take(), pressure = weights.take();
          const V t = distortion * slanted<Real, m() - l()>(in_plane, up) + pressure * theta;
          f.x[l] += column.di *
                    (distortion * slanted<Real, m() - l()>(in_plane_odd, up_odd) + pressure * theta_odd);
          f.y[l] += column.dj * t;
          add_slanted<Real, m() - l()>(f.z[l], t);
        }
      });
    });
  }
  stream = weights;
  total = f;
}

template <class Real, int nz, bool per_lane>
Real linear_force(const LinearFields<Real>& fields, const LinearWeights<Real>& weights, int b) {
  using S = Simd<Real>;
  using V = typename S::V;
  const Nearby<Real> w(fields, nz, b);
  V largest = {};
  for (int lane0 = 0; lane0 < block; lane0 += S::lanes) {
    const std::ptrdiff_t x = std::ptrdiff_t(b) * block + lane0;
    Stream<Real, per_lane> stream{weights.force.data() + (per_lane ? lane0 : 0)},
        own{weights.own_force.data() + (per_lane ? lane0 : 0)};
    Forces<Real, nz> f;
    for (const auto& g : *weights.groups) {
      with_layers<nz>(g.dk, [&](auto dk) {
        if constexpr (!per_lane) {
          if (g.mirrored) return force_of_mirrored<Real, nz, dk()>(w, g, x, stream, f);
        }
        force_of_group<Real, nz, dk(), per_lane>(w, g, x, stream, f);
      });
    }
    for (int l = 0; l < nz; ++l) {
      const std::ptrdiff_t at = x + l * fields.layer;
      const V u0 = w(0, at), u1 = w(1, at), u2 = w(2, at), theta = w.theta(at);
      const V xx = own.take(), yy = own.take(), zz = own.take(), xy = own.take(), xz = own.take(),
              yz = own.take(), p0 = own.take(), p1 = own.take(), p2 = own.take();
      S::store(fields.acceleration[0] + at, f.x[l] - (xx * u0 + xy * u1 + xz * u2) + p0 * theta);
      S::store(fields.acceleration[1] + at, f.y[l] - (xy * u0 + yy * u1 + yz * u2) + p1 * theta);
      S::store(fields.acceleration[2] + at, f.z[l] - (xz * u0 + yz * u1 + zz * u2) + p2 * theta);
    }
    largest = S::max(largest, f.theta);
  }
  return S::largest(largest);
}

// Largest sums of squared displacement differences between nearest neighbours, of all lanes within a bond's
// reach of block b: within this column, and between it and the next one. Stops where the former is beyond the
template <class Real>
std::uint8_t flatness(const LinearFields<Real>& f, int nz, int b, const Real* has_next, Real limit) {
  using S = Simd<Real>;
  using V = typename S::V;
  constexpr int first = -reach, last = block + reach;
  V across = {};
  for (int lane = first; lane < last; lane += S::lanes) {
    const std::ptrdiff_t x = std::ptrdiff_t(b) * block + std::min(lane, last - S::lanes);
    const V next = S::load(has_next + x);
    for (int k = 0; k < nz; ++k) {
      V in_column = {}, to_next = {};
      for (int c = 0; c < 3; ++c) {
        const Real* const u = f.u[c] + x + k * f.layer;
        const V own = S::load(u), ahead = (S::load(u + 1) - own) * next, port = S::load(u + f.column) - own;
        in_column += ahead * ahead;
        to_next += port * port;
        if (k + 1 < nz) {
          const V up = S::load(u + f.layer) - own;
          in_column += up * up;
        }
      }
      if (S::any(!(in_column <= limit))) return 0;
      across = S::max(across, to_next);
    }
  }
  return S::any(!(across <= limit)) ? flat_within : flat_within | flat_across;
}

template <class Real, int nz>
constexpr LinearPasses<Real> linear_passes() {
  return {linear_theta<Real, nz, false>, linear_theta<Real, nz, true>, linear_force<Real, nz, false>,
          linear_force<Real, nz, true>};
}

}  // namespace
}  // namespace icebow
