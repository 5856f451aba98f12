// A block of one row by its families: dilatation, force and stress of 16 particles, bond by bond; included by
// kernel_impl.h.
#pragma once

#include <cstddef>

#include "solver/kernel/column_impl.h"
#include "solver/kernel/kernel.h"
#include "solver/kernel/kernel_vector.h"

namespace icebow {
namespace {

// A fit of the block's law at e.
template <BlockLaw which, class Real>
inline const auto& fits_of(const BondLaw<Real>& law) {
  if constexpr (which == calm) return law.calm;
  if constexpr (which == bent) return law.small;
  if constexpr (which == wide) return law.wide;
}

// Beyond the ends of its range a law goes on as at the ends.
template <BlockLaw which, class Real>
inline typename Simd<Real>::V fit_argument(typename Simd<Real>::V e, const BondLaw<Real>& law) {
  if constexpr (which != wide) return e;
  return Simd<Real>::min(Simd<Real>::max(e, Simd<Real>::splat(law.e_min)), Simd<Real>::splat(law.e_max));
}

// Minus y of a bond, seen from the particle at its other end, and e = q / L^2: q = (-eta) . (-y - xi). From
// the other end both eta and xi change their signs, and e is the same to the bit.
template <class Real>
struct Bond {
  typename Simd<Real>::V minus_y[3];
  typename Simd<Real>::V e;
};
template <class Real>
inline Bond<Real> bond_at(const FamilyRow<Real>& row, const FamilyBond<Real>& fb, const Real* const (&u)[3],
                          const typename Simd<Real>::V (&centre)[3]) {
  using S = Simd<Real>;
  using V = typename S::V;
  const V xi[3] = {S::splat(fb.xi_x), S::splat(row.xi_y), S::splat(row.xi_z)};
  Bond<Real> bond;
  V q = {};
  for (int c = 0; c < 3; ++c) {
    const V minus_eta = centre[c] - S::load(u[c] + fb.neighbour);
    bond.minus_y[c] = minus_eta - xi[c];
    const V sum = bond.minus_y[c] - xi[c];
    q = c == 0 ? minus_eta * sum : minus_eta * sum + q;
  }
  bond.e = q * fb.inverse_L2;
  return bond;
}

// e alone, in the fewest operations: along z (eta + 2 xi).eta as two products, else as one.
template <class Real>
inline typename Simd<Real>::V strain_at(const FamilyRow<Real>& row, const FamilyBond<Real>& fb,
                                        const Real* const (&u)[3],
                                        const typename Simd<Real>::V (&centre)[3]) {
  using S = Simd<Real>;
  using V = typename S::V;
  const V x = centre[0] - S::load(u[0] + fb.neighbour), y = centre[1] - S::load(u[1] + fb.neighbour),
          z = centre[2] - S::load(u[2] + fb.neighbour);
  V q = x * (x - 2 * fb.xi_x);
  q = y * (y - 2 * row.xi_y) + q;
  q = z * (-2 * row.xi_z) + q;
  q = z * z + q;
  return q * fb.inverse_L2;
}

// Calls visit(row, bond, weights, number) for a family's bonds, in their order.
template <class Real, bool per_lane, class Visit>
inline __attribute__((always_inline)) void for_family(const FamilyTables<Real>& t, int b, int lane0,
                                                      Visit visit) {
  const Real* weight = per_lane ? t.ends[b] + lane0 : t.interior;
  const FamilyBond<Real>* fb = t.bond;
  for (const FamilyRow<Real>* row = t.row; row != t.row + t.rows; ++row) {
    const FamilyRow<Real> common = *row;
    for (const FamilyBond<Real>* const end = fb + row->bonds; fb != end; ++fb) {
      visit(common, *fb, weight, fb - t.bond);
      weight += family_weights * (per_lane ? block : 1);
    }
  }
}

// theta of a block of a row; the extremes of e over its bonds.
template <class Real, BlockLaw which, bool masked, bool per_lane>
Extremes<Real> family_theta(const RowFields<Real>& f, const FamilyTables<Real>& t, const BondLaw<Real>& law,
                            int b) {
  using S = Simd<Real>;
  using V = typename S::V;
  const auto& fits = fits_of<which>(law);
  const typename S::template Polynomial<std::extent_v<decltype(fits.G)>> G(fits.G);
  const std::uint16_t* const there = f.there + std::ptrdiff_t(b) * f.there_per_block;
  Extremes<Real> extremes;
  for (int lane0 = 0; lane0 < block; lane0 += S::lanes) {
    const std::ptrdiff_t x = std::ptrdiff_t(b) * block + lane0;
    const Real* const u[3] = {f.u[0] + x, f.u[1] + x, f.u[2] + x};
    const V centre[3] = {S::load(u[0]), S::load(u[1]), S::load(u[2])};
    V sum = {}, high = extremes.high, low = extremes.low;
    for_family<Real, per_lane>(
        t, b, lane0, [&](const auto& row, const auto& fb, const Real* weight, [[maybe_unused]] auto n) {
          V e = strain_at(row, fb, u, centre);
          if constexpr (masked) e = S::keep_lanes(e, part_of<S::lanes>(there[t.word[n].place], lane0));
          const V w = S::template constant<per_lane>(weight, half_dilatation);
          if constexpr (which == calm && LawDegrees<Real>::calm == 0) {
            sum += w * e;
          } else {
            sum += w * (e * G(fit_argument<which>(e, law)));
          }
          high = S::max(high, e);
          low = S::min(low, e);
        });
    S::store(f.theta + x, sum);
    extremes = {high, low};
  }
  return extremes;
}

// Acceleration of a block of a row; the most that theta of both ends of a bond can be.
template <class Real, BlockLaw which, bool masked, bool per_lane>
typename Simd<Real>::V family_force(const RowFields<Real>& f, const FamilyTables<Real>& t,
                                    const BondLaw<Real>& law, int b) {
  using S = Simd<Real>;
  using V = typename S::V;
  const auto& fits = fits_of<which>(law);
  constexpr int n = std::extent_v<std::remove_reference_t<decltype(fits.R)>>;
  const typename S::template Polynomial<n> R(fits.R), H(fits.H);
  const std::uint16_t* const there = f.there + std::ptrdiff_t(b) * f.there_per_block;
  V largest = {};
  for (int lane0 = 0; lane0 < block; lane0 += S::lanes) {
    const std::ptrdiff_t x = std::ptrdiff_t(b) * block + lane0;
    const Real* const u[3] = {f.u[0] + x, f.u[1] + x, f.u[2] + x};
    const Real* const theta = f.theta + x;
    const V centre[3] = {S::load(u[0]), S::load(u[1]), S::load(u[2])}, own_theta = S::load(theta);
    V sum[3] = {}, high = largest;
    for_family<Real, per_lane>(
        t, b, lane0, [&](const auto& row, const auto& fb, const Real* weight, [[maybe_unused]] auto number) {
          const Bond<Real> bond = bond_at(row, fb, u, centre);
          const V both = own_theta + S::load(theta + fb.neighbour);
          high = S::max(high, both);
          V press = both * S::template constant<per_lane>(weight, pressure);
          V distort = bond.e * S::template constant<per_lane>(weight, half_distortion);
          if constexpr (n > 1) {
            const V e = fit_argument<which>(bond.e, law);
            press *= R(e);
            distort *= H(e);
          }
          V scale = distort + press;
          if constexpr (masked)
            scale = S::keep_lanes(scale, part_of<S::lanes>(there[t.word[number].place], lane0));
          for (int c = 0; c < 3; ++c) sum[c] -= scale * bond.minus_y[c];
        });
    for (int c = 0; c < 3; ++c) S::store(f.acceleration[c] + x, sum[c]);
    largest = high;
  }
  return largest;
}

// What the stresses of a block's bonds are at most, s being at most e/2, over that of a bond with e = 1.
template <class Real>
typename Simd<Real>::V family_stress(const RowFields<Real>& f, const FamilyTables<Real>& t,
                                     const BondLaw<Real>& law, int b) {
  using S = Simd<Real>;
  using V = typename S::V;
  const std::uint16_t* const there = f.there + std::ptrdiff_t(b) * f.there_per_block;
  const V theta_as_strain = S::splat(2 * law.stress_per_theta / law.stress_per_stretch);
  V largest = {};
  for (int lane0 = 0; lane0 < block; lane0 += S::lanes) {
    const std::ptrdiff_t x = std::ptrdiff_t(b) * block + lane0;
    const Real* const u[3] = {f.u[0] + x, f.u[1] + x, f.u[2] + x};
    const Real* const theta = f.theta + x;
    const V centre[3] = {S::load(u[0]), S::load(u[1]), S::load(u[2])}, own_theta = S::load(theta);
    V high = largest;
    for_family<Real, false>(t, b, lane0, [&](const auto& row, const auto& fb, const Real*, auto number) {
      const V both = own_theta + S::load(theta + fb.neighbour);
      const V stress = theta_as_strain * both + strain_at(row, fb, u, centre);
      high = S::max(high, S::keep_lanes(stress, part_of<S::lanes>(there[t.word[number].place], lane0)));
    });
    largest = high;
  }
  return largest;
}

}  // namespace
}  // namespace icebow
