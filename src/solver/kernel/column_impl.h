// The passes over a block of a column, all layers at once, by the laws of low degree; included by
// kernel_impl.h.
#pragma once

#include <array>
#include <cstddef>
#include <type_traits>

#include "solver/kernel/column_weights.h"
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

// Degree of a block's law, of the two that these passes have.
template <class Real, BlockLaw which>
constexpr int column_degree = which == calm ? LawDegrees<Real>::calm : LawDegrees<Real>::small;

// Of e over the bonds of a block.
template <class Real>
struct Extremes {
  typename Simd<Real>::V high = {}, low = {};
};

// What is read of a block's bonds one after the other, the same for all lanes or not, and their bits.
template <class Real, bool per_lane>
struct ColumnStream {
  Stream<Real, false> common;
  Stream<Real, per_lane> lanes;
  const std::uint16_t* there;
};

// What a bond adds to theta; the extremes of e, of a calm block the largest |e|. Both from q = e L^2.
template <class Real, BlockLaw which, bool per_lane>
ICEBOW_INLINE void add_column_theta(typename Simd<Real>::V q, ColumnStream<Real, per_lane>& w,
                                    typename Simd<Real>::V& sum, Extremes<Real>& extremes) {
  using S = Simd<Real>;
  using V = typename S::V;
  const V e = q * w.common.take();
  if constexpr (which == calm) {
    extremes.high = S::larger_magnitude(extremes.high, e);
  } else {
    extremes.high = S::max(extremes.high, e);
    extremes.low = S::min(extremes.low, e);
  }
  V series = w.common.take();
  for (int power = column_degree<Real, which>; power > 0; --power) series = series * q + w.common.take();
  if constexpr (per_lane) q *= w.lanes.take();
  sum += q * series;
}

// A bond's force over y. both: theta of its two ends.
template <class Real, BlockLaw which, bool per_lane>
ICEBOW_INLINE typename Simd<Real>::V column_scale(typename Simd<Real>::V q, typename Simd<Real>::V both,
                                                  ColumnStream<Real, per_lane>& w) {
  using V = typename Simd<Real>::V;
  constexpr int degree = column_degree<Real, which>;
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

constexpr bool column_bonded(int l, int m, int dk, bool own) {
  return l - m <= dk && m - l <= dk && !(own && l == m);
}

// The particles of a block's column.
template <class Real, int nz>
struct ColumnCentre {
  ColumnCentre(const LinearFields<Real>& f, std::ptrdiff_t x, Real dx) {
    for (int l = 0; l < nz; ++l)
      for (int c = 0; c < 3; ++c) u[l][c] = Simd<Real>::load(f.u[c] + x + l * f.layer);
    for (int dk = -reach; dk <= reach; ++dk) xi_z[dk + reach] = dk * dx;
  }
  typename Simd<Real>::V u[nz][3];
  Real xi_z[2 * reach + 1];
};

template <class Real, int nz, BlockLaw which, int dk, bool own, bool masked, bool per_lane>
ICEBOW_INLINE void column_theta_of(const LinearFields<Real>& f, const ColumnCentre<Real, nz>& centre,
                                   const ColumnGroup<Real>& g, std::ptrdiff_t x, int lane0,
                                   ColumnStream<Real, per_lane>& stream, typename Simd<Real>::V (&theta)[nz],
                                   Extremes<Real>& extremes) {
  using S = Simd<Real>;
  using V = typename S::V;
  ColumnStream<Real, per_lane> w = stream;
  Extremes<Real> most = extremes;
  V sum[nz];
  for (int l = 0; l < nz; ++l) sum[l] = theta[l];
  for (const auto& column : g.columns) {
    const V twice_x = S::splat(2 * column.xi_x), twice_y = S::splat(2 * column.xi_y);
    for_layers<nz>([&](auto m) __attribute__((always_inline)) {
      const std::ptrdiff_t at = x + m() * f.layer + column.offset;
      const V ux = S::load(f.u[0] + at), uy = S::load(f.u[1] + at), uz = S::load(f.u[2] + at);
      for_layers<nz>([&](auto l) __attribute__((always_inline)) {
        if constexpr (column_bonded(l(), m(), dk, own)) {
          const V ex = centre.u[l()][0] - ux, ey = centre.u[l()][1] - uy, ez = centre.u[l()][2] - uz;
          V q = ex * (ex - twice_x);
          q = ey * (ey - twice_y) + q;
          if constexpr (l() == m()) {
            q = ez * ez + q;
          } else {
            q = ez * (ez - 2 * centre.xi_z[m() - l() + reach]) + q;
          }
          if constexpr (masked) q = S::keep_lanes(q, part_of<S::lanes>(*w.there++, lane0));
          add_column_theta<Real, which>(q, w, sum[l()], most);
        }
      });
    });
  }
  stream = w;
  extremes = most;
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

// theta of a block of all layers; the extremes of e over its bonds.
template <class Real, int nz, BlockLaw which, bool masked, bool per_lane>
Extremes<Real> column_theta(const LinearFields<Real>& f, const ColumnWeights<Real>& weights,
                            const std::uint16_t* there, int b) {
  using S = Simd<Real>;
  Extremes<Real> extremes;
  for (int lane0 = 0; lane0 < block; lane0 += S::lanes) {
    const std::ptrdiff_t x = std::ptrdiff_t(b) * block + lane0;
    const ColumnCentre<Real, nz> centre(f, x, weights.dx);
    ColumnStream<Real, per_lane> stream{
        {weights.dilatation.data()}, {weights.dilatation_lanes.data() + (per_lane ? lane0 : 0)}, there};
    typename S::V theta[nz] = {};
    for (const ColumnGroup<Real>& g : *weights.groups) {
      with_group<nz>(
          g, [&](auto dk, auto own) __attribute__((always_inline)) {
            column_theta_of<Real, nz, which, dk(), own(), masked>(f, centre, g, x, lane0, stream, theta,
                                                                  extremes);
          });
    }
    for (int l = 0; l < nz; ++l) S::store(f.theta + x + l * f.layer, theta[l]);
  }
  if constexpr (which == calm) extremes.low = -extremes.high;
  return extremes;
}

template <class Real, int nz>
struct ColumnForces {
  typename Simd<Real>::V on[nz][3] = {};
  typename Simd<Real>::V theta = {};  // the largest of the neighbours
};

template <class Real, int nz, BlockLaw which, int dk, bool own, bool masked, bool per_lane>
ICEBOW_INLINE void column_force_of(const LinearFields<Real>& f, const ColumnCentre<Real, nz>& centre,
                                   const typename Simd<Real>::V (&theta)[nz], const ColumnGroup<Real>& g,
                                   std::ptrdiff_t x, int lane0, ColumnStream<Real, per_lane>& stream,
                                   ColumnForces<Real, nz>& total) {
  using S = Simd<Real>;
  using V = typename S::V;
  ColumnStream<Real, per_lane> w = stream;
  ColumnForces<Real, nz> sum = total;
  for (const auto& column : g.columns) {
    const V xi_x = S::splat(column.xi_x), xi_y = S::splat(column.xi_y);
    for_layers<nz>([&](auto m) __attribute__((always_inline)) {
      const std::ptrdiff_t at = x + m() * f.layer + column.offset;
      const V ux = S::load(f.u[0] + at), uy = S::load(f.u[1] + at), uz = S::load(f.u[2] + at),
              other = S::load(f.theta + at);
      sum.theta = S::max(sum.theta, other);
      for_layers<nz>([&](auto l) __attribute__((always_inline)) {
        if constexpr (column_bonded(l(), m(), dk, own)) {
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
          V scale = column_scale<Real, which>(q, theta[l()] + other, w);
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
template <class Real, int nz, BlockLaw which, bool masked, bool per_lane>
typename Simd<Real>::V column_force(const LinearFields<Real>& f, const ColumnWeights<Real>& weights,
                                    const std::uint16_t* there, int b) {
  using S = Simd<Real>;
  using V = typename S::V;
  V both = {};
  for (int lane0 = 0; lane0 < block; lane0 += S::lanes) {
    const std::ptrdiff_t x = std::ptrdiff_t(b) * block + lane0;
    const ColumnCentre<Real, nz> centre(f, x, weights.dx);
    V theta[nz], own = {};
    for (int l = 0; l < nz; ++l) {
      theta[l] = S::load(f.theta + x + l * f.layer);
      own = S::max(own, theta[l]);
    }
    ColumnStream<Real, per_lane> stream{
        {weights.force.data()}, {weights.force_lanes.data() + (per_lane ? lane0 : 0)}, there};
    ColumnForces<Real, nz> forces;
    for (const ColumnGroup<Real>& g : *weights.groups) {
      with_group<nz>(
          g, [&](auto dk, auto own_column) __attribute__((always_inline)) {
            column_force_of<Real, nz, which, dk(), own_column(), masked>(f, centre, theta, g, x, lane0,
                                                                         stream, forces);
          });
    }
    for (int l = 0; l < nz; ++l)
      for (int c = 0; c < 3; ++c) S::store(f.acceleration[c] + x + l * f.layer, forces.on[l][c]);
    both = S::max(both, own + forces.theta);
  }
  return both;
}

// The sums of more layers would not fit into a processor's registers.
inline constexpr int most_column_layers = 3;

// Of a law: bits looked at, weights of each particle.
template <class Real>
struct ColumnPasses {
  using Theta = Extremes<Real> (*)(const LinearFields<Real>&, const ColumnWeights<Real>&,
                                   const std::uint16_t*, int);
  using Force = typename Simd<Real>::V (*)(const LinearFields<Real>&, const ColumnWeights<Real>&,
                                           const std::uint16_t*, int);
  Theta theta[2][2];
  Force force[2][2];
};
template <class Real, int nz, BlockLaw which>
constexpr ColumnPasses<Real> column_passes_of() {
  return {{{column_theta<Real, nz, which, false, false>, nullptr},
           {column_theta<Real, nz, which, true, false>, column_theta<Real, nz, which, true, true>}},
          {{column_force<Real, nz, which, false, false>, nullptr},
           {column_force<Real, nz, which, true, false>, column_force<Real, nz, which, true, true>}}};
}
// By law, calm or bent, and layers less one.
template <class Real>
inline constexpr ColumnPasses<Real> column_passes[2][most_column_layers] = {
    {column_passes_of<Real, 1, calm>(), column_passes_of<Real, 2, calm>(), column_passes_of<Real, 3, calm>()},
    {column_passes_of<Real, 1, bent>(), column_passes_of<Real, 2, bent>(),
     column_passes_of<Real, 3, bent>()}};

}  // namespace
}  // namespace icebow
