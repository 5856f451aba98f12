// The passes over a calm block of a column, all layers at once; included by kernel_impl.h.
#pragma once

#include <array>
#include <cstddef>
#include <type_traits>

#include "solver/kernel/calm_columns.h"
#include "solver/kernel/kernel.h"
#include "solver/kernel/kernel_vector.h"
#include "solver/kernel/linear_impl.h"

namespace icebow {
namespace {

// Bits of `lanes` particles within those of a block.
template <int lanes>
inline unsigned part_of(unsigned word, int lane0) {
  return (word >> lane0) & ((1u << lanes) - 1u);
}

// What is read of a block's bonds one after the other, the same for all lanes or not, and their bits.
template <class Real, bool per_lane>
struct CalmStream {
  Stream<Real, false> common;
  Stream<Real, per_lane> lanes;
  const std::uint16_t* there;
};

// What a bond adds to theta; the largest |e|. Both from q = e L^2.
template <class Real, bool per_lane>
ICEBOW_INLINE void add_calm_theta(typename Simd<Real>::V q, CalmStream<Real, per_lane>& w,
                                  typename Simd<Real>::V& sum, typename Simd<Real>::V& largest) {
  using V = typename Simd<Real>::V;
  largest = Simd<Real>::larger_magnitude(largest, q * w.common.take());
  V series = w.common.take();
  for (int power = LawDegrees<Real>::calm; power > 0; --power) series = series * q + w.common.take();
  if constexpr (per_lane) q *= w.lanes.take();
  sum += q * series;
}

// A bond's force over y. both: theta of its two ends.
template <class Real, bool per_lane>
ICEBOW_INLINE typename Simd<Real>::V calm_scale(typename Simd<Real>::V q, typename Simd<Real>::V both,
                                                CalmStream<Real, per_lane>& w) {
  using V = typename Simd<Real>::V;
  constexpr int degree = LawDegrees<Real>::calm;
  if constexpr (per_lane) {
    const V press = both * w.lanes.take(), distort = q * w.lanes.take();
    V R = w.common.take();
    for (int power = degree; power > 0; --power) R = R * q + w.common.take();
    V H = w.common.take();
    for (int power = degree; power > 0; --power) H = H * q + w.common.take();
    return press * R + distort * H;
  } else {
    const V press = both * w.common.take();
    V series = w.common.take();
    for (int power = degree; power > 0; --power) {
      const V R = w.common.take(), H = w.common.take();
      series = series * q + (R * press + H);
    }
    return series * q + press;
  }
}

constexpr bool calm_bonded(int l, int m, int dk, bool own) {
  return l - m <= dk && m - l <= dk && !(own && l == m);
}

// The particles of a block's column.
template <class Real, int nz>
struct CalmCentre {
  CalmCentre(const LinearFields<Real>& f, std::ptrdiff_t x, Real dx) {
    for (int l = 0; l < nz; ++l)
      for (int c = 0; c < 3; ++c) u[l][c] = Simd<Real>::load(f.u[c] + x + l * f.layer);
    for (int dk = -reach; dk <= reach; ++dk) xi_z[dk + reach] = dk * dx;
  }
  typename Simd<Real>::V u[nz][3];
  Real xi_z[2 * reach + 1];
};

template <class Real, int nz, int dk, bool own, bool masked, bool per_lane>
ICEBOW_INLINE void calm_theta_of(const LinearFields<Real>& f, const CalmCentre<Real, nz>& centre,
                                 const ColumnGroup<Real>& g, std::ptrdiff_t x, int lane0,
                                 CalmStream<Real, per_lane>& stream, typename Simd<Real>::V (&theta)[nz],
                                 typename Simd<Real>::V& largest) {
  using S = Simd<Real>;
  using V = typename S::V;
  CalmStream<Real, per_lane> w = stream;
  V sum[nz], most = largest;
  for (int l = 0; l < nz; ++l) sum[l] = theta[l];
  for (const auto& column : g.columns) {
    const V twice_x = S::splat(2 * column.xi_x), twice_y = S::splat(2 * column.xi_y);
    for_layers<nz>([&](auto m) __attribute__((always_inline)) {
      const std::ptrdiff_t at = x + m() * f.layer + column.offset;
      const V ux = S::load(f.u[0] + at), uy = S::load(f.u[1] + at), uz = S::load(f.u[2] + at);
      for_layers<nz>([&](auto l) __attribute__((always_inline)) {
        if constexpr (calm_bonded(l(), m(), dk, own)) {
          const V ex = centre.u[l()][0] - ux, ey = centre.u[l()][1] - uy, ez = centre.u[l()][2] - uz;
          V q = ex * (ex - twice_x);
          q = ey * (ey - twice_y) + q;
          if constexpr (l() == m()) {
            q = ez * ez + q;
          } else {
            q = ez * (ez - 2 * centre.xi_z[m() - l() + reach]) + q;
          }
          if constexpr (masked) q = S::keep_lanes(q, part_of<S::lanes>(*w.there++, lane0));
          add_calm_theta(q, w, sum[l()], most);
        }
      });
    });
  }
  stream = w;
  largest = most;
  for (int l = 0; l < nz; ++l) theta[l] = sum[l];
}

// Calls visit(dk, own) for the group, both as constants.
template <int nz, class Real, class Visit>
ICEBOW_INLINE void with_group(const ColumnGroup<Real>& g, Visit visit) {
  constexpr int most = nz - 1 < reach ? nz - 1 : reach;
  if (g.own) return visit(std::integral_constant<int, most>(), std::true_type());
  with_layers<nz>(
      g.dk, [&](auto dk) __attribute__((always_inline)) { visit(dk, std::false_type()); });
}

// theta of a block of all layers; the largest |e| of its bonds.
template <class Real, int nz, bool masked, bool per_lane>
typename Simd<Real>::V calm_theta(const LinearFields<Real>& f, const CalmWeights<Real>& weights,
                                  const std::uint16_t* there, int b) {
  using S = Simd<Real>;
  typename S::V largest = {};
  for (int lane0 = 0; lane0 < block; lane0 += S::lanes) {
    const std::ptrdiff_t x = std::ptrdiff_t(b) * block + lane0;
    const CalmCentre<Real, nz> centre(f, x, weights.dx);
    CalmStream<Real, per_lane> stream{
        {weights.dilatation.data()}, {weights.dilatation_lanes.data() + (per_lane ? lane0 : 0)}, there};
    typename S::V theta[nz] = {};
    for (const ColumnGroup<Real>& g : *weights.groups) {
      with_group<nz>(
          g, [&](auto dk, auto own) __attribute__((always_inline)) {
            calm_theta_of<Real, nz, dk(), own(), masked>(f, centre, g, x, lane0, stream, theta, largest);
          });
    }
    for (int l = 0; l < nz; ++l) S::store(f.theta + x + l * f.layer, theta[l]);
  }
  return largest;
}

template <class Real, int nz>
struct CalmForces {
  typename Simd<Real>::V on[nz][3] = {};
  typename Simd<Real>::V theta = {};  // the largest of the neighbours
};

template <class Real, int nz, int dk, bool own, bool masked, bool per_lane>
ICEBOW_INLINE void calm_force_of(const LinearFields<Real>& f, const CalmCentre<Real, nz>& centre,
                                 const typename Simd<Real>::V (&theta)[nz], const ColumnGroup<Real>& g,
                                 std::ptrdiff_t x, int lane0, CalmStream<Real, per_lane>& stream,
                                 CalmForces<Real, nz>& total) {
  using S = Simd<Real>;
  using V = typename S::V;
  CalmStream<Real, per_lane> w = stream;
  CalmForces<Real, nz> sum = total;
  for (const auto& column : g.columns) {
    const V xi_x = S::splat(column.xi_x), xi_y = S::splat(column.xi_y);
    for_layers<nz>([&](auto m) __attribute__((always_inline)) {
      const std::ptrdiff_t at = x + m() * f.layer + column.offset;
      const V ux = S::load(f.u[0] + at), uy = S::load(f.u[1] + at), uz = S::load(f.u[2] + at),
              other = S::load(f.theta + at);
      sum.theta = S::max(sum.theta, other);
      for_layers<nz>([&](auto l) __attribute__((always_inline)) {
        if constexpr (calm_bonded(l(), m(), dk, own)) {
          // Minus eta, minus y.
          const V ex = centre.u[l()][0] - ux, ey = centre.u[l()][1] - uy, ez = centre.u[l()][2] - uz;
          const V yx = ex - xi_x, yy = ey - xi_y;
          V q = ex * (yx - xi_x), yz = ez;
          q = ey * (yy - xi_y) + q;
          if constexpr (l() == m()) {
            q = ez * ez + q;
          } else {
            const Real xi_z = centre.xi_z[m() - l() + reach];
            yz = ez - xi_z;
            q = ez * (yz - xi_z) + q;
          }
          V scale = calm_scale(q, theta[l()] + other, w);
          if constexpr (masked) scale = S::keep_lanes(scale, part_of<S::lanes>(*w.there++, lane0));
          sum.on[l()][0] -= scale * yx;
          sum.on[l()][1] -= scale * yy;
          sum.on[l()][2] -= scale * yz;
        }
      });
    });
  }
  stream = w;
  total = sum;
}

// Acceleration of a block of all layers; the most that theta of both ends of a bond can be.
template <class Real, int nz, bool masked, bool per_lane>
typename Simd<Real>::V calm_force(const LinearFields<Real>& f, const CalmWeights<Real>& weights,
                                  const std::uint16_t* there, int b) {
  using S = Simd<Real>;
  using V = typename S::V;
  V both = {};
  for (int lane0 = 0; lane0 < block; lane0 += S::lanes) {
    const std::ptrdiff_t x = std::ptrdiff_t(b) * block + lane0;
    const CalmCentre<Real, nz> centre(f, x, weights.dx);
    V theta[nz], own = {};
    for (int l = 0; l < nz; ++l) {
      theta[l] = S::load(f.theta + x + l * f.layer);
      own = S::max(own, theta[l]);
    }
    CalmStream<Real, per_lane> stream{
        {weights.force.data()}, {weights.force_lanes.data() + (per_lane ? lane0 : 0)}, there};
    CalmForces<Real, nz> forces;
    for (const ColumnGroup<Real>& g : *weights.groups) {
      with_group<nz>(
          g, [&](auto dk, auto own_column) __attribute__((always_inline)) {
            calm_force_of<Real, nz, dk(), own_column(), masked>(f, centre, theta, g, x, lane0, stream,
                                                                forces);
          });
    }
    for (int l = 0; l < nz; ++l)
      for (int c = 0; c < 3; ++c) S::store(f.acceleration[c] + x + l * f.layer, forces.on[l][c]);
    both = S::max(both, own + forces.theta);
  }
  return both;
}

template <class Real>
using CalmPass = typename Simd<Real>::V (*)(const LinearFields<Real>&, const CalmWeights<Real>&,
                                            const std::uint16_t*, int);

// The sums of more layers would not fit into a processor's registers.
constexpr int most_calm_layers = 3;

// By: bits looked at, weights of each particle.
template <class Real>
struct CalmPasses {
  CalmPass<Real> theta[2][2], force[2][2];
};
template <class Real, int nz>
constexpr CalmPasses<Real> calm_passes_of() {
  return {{{calm_theta<Real, nz, false, false>, nullptr},
           {calm_theta<Real, nz, true, false>, calm_theta<Real, nz, true, true>}},
          {{calm_force<Real, nz, false, false>, nullptr},
           {calm_force<Real, nz, true, false>, calm_force<Real, nz, true, true>}}};
}
template <class Real>
inline constexpr CalmPasses<Real> calm_passes[most_calm_layers] = {
    calm_passes_of<Real, 1>(), calm_passes_of<Real, 2>(), calm_passes_of<Real, 3>()};

}  // namespace
}  // namespace icebow
