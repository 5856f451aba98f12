// The water's reaction to a block's columns; included by kernel_impl.h. In double precision whatever the
// fields' is.
#include <cmath>

#include "solver/kernel/kernel_vector.h"
#include "solver/kernel/water_columns.h"

namespace icebow {
namespace {

// Beyond this part of its thickness a column is longer or shorter than any ice that still is a plate.
inline constexpr double most_crushed = 0.3;
// Ice that has moved by so many thicknesses is part of the plane; by one more, no longer.
inline constexpr double in_plane = 0.5;

// Doubles from a field of either precision.
template <class Real>
inline Simd<double>::V load_double(const Real* p) {
#if ICEBOW_VECTOR_BYTES == 64
  // GCC converts halves of a vector and puts them together.
  if constexpr (sizeof(Real) == sizeof(float)) return (Simd<double>::V)_mm512_cvtps_pd(_mm256_loadu_ps(p));
#endif
  typedef Real From __attribute__((vector_size(sizeof(Real) * Simd<double>::lanes)));
  From from;
  std::memcpy(&from, p, sizeof from);
  return __builtin_convertvector(from, Simd<double>::V);
}
template <class Real>
inline void add_double(Real* p, Simd<double>::V v) {
#if ICEBOW_VECTOR_BYTES == 64
  if constexpr (sizeof(Real) == sizeof(float)) {
    _mm256_storeu_ps(p, _mm256_add_ps(_mm256_loadu_ps(p), _mm512_cvtpd_ps((__m512d)v)));
    return;
  }
#endif
  typedef Real To __attribute__((vector_size(sizeof(Real) * Simd<double>::lanes)));
  To to;
  std::memcpy(&to, p, sizeof to);
  to += __builtin_convertvector(v, To);
  std::memcpy(p, &to, sizeof to);
}

inline Simd<double>::V root(Simd<double>::V x) {
  for (int l = 0; l < Simd<double>::lanes; ++l) x[l] = std::sqrt(x[l]);
  return x;
}
inline Simd<double>::V size_of(Simd<double>::V x) {
  return Simd<double>::max(x, -x);
}
inline Simd<double>::V share_of_one(Simd<double>::V x) {
  return Simd<double>::min(Simd<double>::max(x, Simd<double>::V{}), Simd<double>::splat(1.0));
}

// The columns as pieces of plate: normals, and the shares of their lower and higher faces that are wet.
struct Plates {
  Simd<double>::V n[3], wet_low, wet_high, share;
  Simd<double>::Mask whole;  // not crushed
};

template <class Real>
inline Plates plates(const WaterFields<Real>& f, const WaterLaw& w, int lane0) {
  using S = Simd<double>;
  using V = S::V;
  const std::ptrdiff_t last = (f.layers - 1) * f.layer + lane0;
  const double height = (f.layers - 1) * w.dx, upright = f.layers == 1 ? 1.0 : height;
  V low[3], high[3], normal[3];
  for (int c = 0; c < 3; ++c) {
    low[c] = load_double(f.u[c] + lane0);
    high[c] = load_double(f.u[c] + last);
    normal[c] = high[c] - low[c];
  }
  normal[2] += upright;
  const V length = root(normal[0] * normal[0] + normal[1] * normal[1] + normal[2] * normal[2]);
  Plates p;
  p.whole = f.layers == 1 ? length == length : size_of(length - height) <= most_crushed * height;
  const V per_length = 1.0 / length;
  const double per_dx = 1.0 / w.dx;
  for (int c = 0; c < 3; ++c) p.n[c] = normal[c] * per_length;
  const V face = 0.5 * w.dx * size_of(p.n[2]), z_first = w.z0 + low[2], z_last = (w.z0 + height) + high[2];
  p.wet_low = share_of_one((face - S::min(z_first, z_last)) * per_dx);
  p.wet_high = share_of_one((-face - S::max(z_first, z_last)) * per_dx);
  p.share = V{};
  if (!w.plane) return p;
  V moved2 = {};
  for (int c = 0; c < 3; ++c) moved2 += (low[c] + high[c]) * (low[c] + high[c]);
  const V moved = root(moved2) * (0.5 / w.thickness);
  p.share = p.wet_low * p.n[2] * p.n[2] * share_of_one((1.0 + in_plane) - moved);
  return p;
}

// What the water does to the block's columns without the plane: (M + m) a' = M (a + strike / dt) - drag, eq.
// (41); the strike itself has been. `mobile` has a bit a column.
template <class Real>
void water_columns(const WaterFields<Real>& f, const WaterLaw& w, unsigned mobile,
                   const WaterStrikes* strikes, WaterColumns& out) {
  using S = Simd<double>;
  using V = S::V;
  const S::Mask bits = S::lane_bits();
  const double per_dx = 1.0 / w.dx, per_layer = 1.0 / f.layers, per_dt = per_layer / w.dt;
  for (int lane0 = 0; lane0 < block; lane0 += S::lanes) {
    const Plates p = plates(f, w, lane0);
    V speed[3] = {}, acceleration[3] = {};
    for (int k = 0; k < f.layers; ++k) {
      for (int c = 0; c < 3; ++c) {
        speed[c] += load_double(f.v[c] + k * f.layer + lane0);
        acceleration[c] += load_double(f.acceleration[c] + k * f.layer + lane0);
      }
      const V z = (w.z0 + k * w.dx) + load_double(f.u[2] + k * f.layer + lane0);
      acceleration[2] += w.lift * share_of_one(0.5 - z * per_dx) - w.gravity;
    }
    V strike = {}, v = {}, a = {};
    for (int c = 0; c < 3; ++c) {
      v += p.n[c] * speed[c];
      a += p.n[c] * acceleration[c];
      if (strikes) strike += p.n[c] * S::load(strikes->delta_v[c] + lane0);
    }
    v *= per_layer;
    a *= per_layer;
    strike *= per_dt;
    const V m = w.added_mass * p.wet_low * (1.0 - p.share), drag = (0.5 * w.drag) * (p.wet_low + p.wet_high);
    const V mass = w.mass * f.layers + m;
    const V change = -(m * (a + strike) + drag * size_of(v) * v) / mass;
    const S::Mask acts = p.whole & ((m != 0.0) | (drag != 0.0) | (p.share != 0.0)) &
                         S::expand((mobile >> lane0) & ((1u << S::lanes) - 1u), bits);
    for (int c = 0; c < 3; ++c) S::store(out.n[c] + lane0, S::keep(p.n[c], acts));
    S::store(out.mass + lane0, S::keep(mass, acts));
    S::store(out.share + lane0, S::keep(p.share, acts));
    S::store(out.v + lane0, S::keep(v, acts));
    S::store(out.a + lane0, S::keep(a, acts));
    S::store(out.reached + lane0, S::keep(a + strike + change, acts));
    S::store(out.change + lane0, S::keep(change, acts));
  }
}

// Adds it to the particles' accelerations; returns the energy that the water takes [J].
template <class Real>
double water_push(const WaterFields<Real>& f, const WaterLaw& w, const WaterColumns& columns) {
  using S = Simd<double>;
  using V = S::V;
  double joules = 0.0;
  for (int lane0 = 0; lane0 < block; lane0 += S::lanes) {
    const V change = S::load(columns.change + lane0), a = S::load(columns.a + lane0),
            v = S::load(columns.v + lane0);
    for (int c = 0; c < 3; ++c) {
      const V along = change * S::load(columns.n[c] + lane0);
      for (int k = 0; k < f.layers; ++k) add_double(f.acceleration[c] + k * f.layer + lane0, along);
    }
    const V work = (w.mass * f.layers * w.dt) * change * (v + 0.5 * w.dt * (a + change));
    for (int l = 0; l < S::lanes; ++l) joules -= work[l];
  }
  return joules;
}

}  // namespace
}  // namespace icebow
