// Vectors of ICEBOW_VECTOR_BYTES as GCC's and Clang's portable vector types, so one text serves every
// instruction set. Included by kernel_impl.h alone; everything is in an unnamed namespace: two widths must
// never share a symbol.
#pragma once

#include <cstdint>
#include <cstring>
#include <type_traits>
#if ICEBOW_VECTOR_BYTES > 16
#include <immintrin.h>
#endif

#include "solver/lattice/lattice.h"

namespace icebow {
namespace {

template <class Real>
struct Simd {
  static constexpr int lanes = ICEBOW_VECTOR_BYTES / sizeof(Real);
  using Int = std::conditional_t<sizeof(Real) == 4, std::int32_t, std::int64_t>;
  typedef Real V __attribute__((vector_size(ICEBOW_VECTOR_BYTES)));
  typedef Int Mask __attribute__((vector_size(ICEBOW_VECTOR_BYTES)));
  static_assert(block % lanes == 0);

  static V load(const Real* p) {
    V v;
    std::memcpy(&v, p, sizeof v);
    return v;
  }
  static void store(Real* p, V v) { std::memcpy(p, &v, sizeof v); }
  static V splat(Real x) { return x - V{}; }
  static V max(V a, V b) { return a > b ? a : b; }
  static Real largest(V v) {
#if ICEBOW_VECTOR_BYTES == 64
    if constexpr (sizeof(Real) == 4) {
      const __m256 of8 =
          _mm256_max_ps(_mm512_castps512_ps256((__m512)v), _mm512_extractf32x8_ps((__m512)v, 1));
      const __m128 of4 = _mm_max_ps(_mm256_castps256_ps128(of8), _mm256_extractf128_ps(of8, 1)),
                   of2 = _mm_max_ps(of4, _mm_movehl_ps(of4, of4));
      return _mm_cvtss_f32(_mm_max_ss(of2, _mm_movehdup_ps(of2)));
    }
#endif
    Real part[lanes];
    store(part, v);
    for (int half = lanes / 2; half > 0; half /= 2)
      for (int l = 0; l < half; ++l) part[l] = part[l] > part[l + half] ? part[l] : part[l + half];
    return part[0];
  }
  static V min(V a, V b) {
    return a < b ? a : b;
  }
  // max(a, |b|), a >= 0.
  static V larger_magnitude(V a, V b) {
#if ICEBOW_VECTOR_BYTES == 64
    constexpr int of_magnitudes = 0xb;
    if constexpr (sizeof(Real) == 4) {
      return (V)_mm512_range_ps((__m512)a, (__m512)b, of_magnitudes);
    } else {
      return (V)_mm512_range_pd((__m512d)a, (__m512d)b, of_magnitudes);
    }
#else
    return max(a, max(b, -b));
#endif
  }
  static V keep(V v, Mask mask) {
    return (V)((Mask)v & mask);
  }
  // v where the lane's bit is set, else 0.
  static V keep_lanes(V v, unsigned word) {
#if ICEBOW_VECTOR_BYTES == 64
    if constexpr (sizeof(Real) == 4) {
      return (V)_mm512_maskz_mov_ps(static_cast<__mmask16>(word), (__m512)v);
    } else {
      return (V)_mm512_maskz_mov_pd(static_cast<__mmask8>(word), (__m512d)v);
    }
#else
    return keep(v, expand(word, lane_bits()));
#endif
  }

  static Mask lane_bits() {
    Mask bits;
    for (int l = 0; l < lanes; ++l) bits[l] = Int(1) << l;
    return bits;
  }
  // Lane l of the mask is all ones where bit l of the word is set.
  static Mask expand(unsigned word, Mask bits) {
    return ((static_cast<Int>(word) - Mask{}) & bits) != 0;
  }
  static unsigned compress(Mask mask, Mask bits) {
    const Mask set = mask & bits;
    unsigned word = 0;
    for (int l = 0; l < lanes; ++l) word |= static_cast<unsigned>(set[l]);
    return word;
  }
  static bool any(Mask mask) {
#if ICEBOW_VECTOR_BYTES == 64
    if constexpr (sizeof(Real) == 4) {
      return _mm512_movepi32_mask((__m512i)mask) != 0;
    } else {
      return _mm512_movepi64_mask((__m512i)mask) != 0;
    }
#elif ICEBOW_VECTOR_BYTES == 32
    return _mm256_movemask_epi8((__m256i)mask) != 0;
#else
    std::uint64_t part[sizeof(Mask) / 8], all = 0;
    std::memcpy(part, &mask, sizeof mask);
    for (std::uint64_t p : part) all |= p;
    return all != 0;
#endif
  }

  // A fit with its coefficients repeated for all lanes.
  template <int n>
  struct Polynomial {
    explicit Polynomial(const Real (&coefficients)[n]) {
      for (int power = 0; power < n; ++power) c[power] = splat(coefficients[power]);
    }
    V operator()(V e) const {
      V p = c[n - 1];
      for (int power = n - 2; power >= 0; --power) p = p * e + c[power];
      return p;
    }
    V c[n];
  };

  // Constant of a slot for one vector: the same for all lanes in the interior, one for each lane near the
  // ends.
  template <bool per_lane>
  static V constant(const Real* slot, int which, int vector = 0) {
    if constexpr (per_lane) return load(slot + which * block + vector * lanes);
    return splat(slot[which]);
  }
};

}  // namespace
}  // namespace icebow
