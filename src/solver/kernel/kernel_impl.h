// Included by kernel_<name>.cpp with ICEBOW_VECTOR_BYTES defined: see kernel.h.
#include <algorithm>
#include <cstddef>

#include "solver/kernel/breaking_impl.h"
#include "solver/kernel/column_impl.h"
#include "solver/kernel/family_impl.h"
#include "solver/kernel/kernel.h"
#include "solver/kernel/kernel_vector.h"
#include "solver/kernel/linear_impl.h"
#include "solver/kernel/near_impl.h"
#include "solver/kernel/water_impl.h"
// After the water, whose root it takes.
#include "solver/kernel/floe_impl.h"

namespace icebow {
namespace {

template <class Real, bool masked, bool per_lane>
Extremes<Real> theta_by_law(const RowFields<Real>& f, const FamilyTables<Real>& t, const BondLaw<Real>& law,
                            int b) {
  switch (law_of(f.state[b])) {
    case calm:
      return family_theta<Real, calm, masked, per_lane>(f, t, law, b);
    case bent:
      return family_theta<Real, bent, masked, per_lane>(f, t, law, b);
    default:
      return family_theta<Real, wide, masked, per_lane>(f, t, law, b);
  }
}

template <class Real>
Extremes<Real> theta_by_state(const RowFields<Real>& f, const FamilyTables<Real>& t, const BondLaw<Real>& law,
                              int b) {
  if (t.ends[b]) return theta_by_law<Real, true, true>(f, t, law, b);
  if (f.state[b] & cracked) return theta_by_law<Real, true, false>(f, t, law, b);
  return theta_by_law<Real, false, false>(f, t, law, b);
}

// The law for bonds of which |e| is largest so far: one that serves. A block goes back to a shorter one where
// it is well within its range.
template <class Real>
BlockLaw law_for(typename Simd<Real>::V largest, const BondLaw<Real>& law, BlockLaw now) {
  using S = Simd<Real>;
  if (S::any(largest > law.e_small)) return wide;
  if (now == wide && S::any(largest > law.e_small / 2)) return wide;
  if (S::any(largest > law.e_calm)) return bent;
  if (now != calm && S::any(largest > law.e_calm / 2)) return bent;
  return calm;
}

// A column of the passes.
template <class Real>
struct Column {
  const ColumnFields<Real>& fields;
  const RowFields<Real>* rows;  // [layer]
  const FamilyTables<Real>* tables;
  int nz;
  const BondLaw<Real>& law;
};

template <class Real>
BlockLaw law_of_block(const Column<Real>& c, int b) {
  BlockLaw now = calm;
  for (int k = 0; k < c.nz; ++k) now = std::max(now, law_of(c.rows[k].state[b]));
  return now;
}

template <class Real>
bool is_cracked(const Column<Real>& c, int b) {
  unsigned all = 0;
  for (int k = 0; k < c.nz; ++k) all |= c.rows[k].state[b];
  return all & cracked;
}

// Whether a block of this law is summed for all layers at once.
template <class Real>
bool at_once(const Column<Real>& c, BlockLaw law) {
  return law != wide && c.fields.weights[law] && c.nz <= most_column_layers;
}

// A block by one of the passes over all layers: `of_law` picks those of theta or of the force.
template <class Real, class OfLaw>
auto run_column(const Column<Real>& c, int b, BlockLaw law, OfLaw of_law) {
  const ColumnWeights<Real>& weights = *c.fields.weights[law][b];
  const std::uint16_t* const there = c.rows[0].there + std::ptrdiff_t(b) * c.rows[0].there_per_block;
  const auto& passes = of_law(column_passes<Real>[law][c.nz - 1]);
  return passes[weights.masked || is_cracked(c, b)][weights.per_lane](c.fields.fields, weights, there, b);
}

// Breaks what is overstrained in a block's layers. Returns whether they must be summed again.
template <class Real, bool by_stress>
bool break_in_block(const Column<Real>& c, int b, Broken& broken) {
  bool changed = false;
  for (int k = 0; k < c.nz; ++k)
    changed |= break_bonds<Real, by_stress>(c.rows[k], c.tables[k], c.law, b, broken);
  return changed;
}

// theta of a block by a law.
template <class Real>
Extremes<Real> theta_of_block(const Column<Real>& c, int b, BlockLaw now) {
  using S = Simd<Real>;
  if (at_once(c, now))
    return run_column(
        c, b, now, [](const auto& p) -> const auto& { return p.theta; });
  Extremes<Real> all;
  for (int k = 0; k < c.nz; ++k) {
    const Extremes<Real> e = theta_by_state(c.rows[k], c.tables[k], c.law, b);
    all = {S::max(all.high, e.high), S::min(all.low, e.low)};
  }
  return all;
}

template <class Real>
void follow_law(const Column<Real>& c, int b, BlockLaw law) {
  for (int k = 0; k < c.nz; ++k) {
    std::uint8_t& state = c.rows[k].state[b];
    state = static_cast<std::uint8_t>((state & cracked) | law);
  }
}

template <class Real>
void block_theta(const Column<Real>& c, int b, Broken& broken) {
  using S = Simd<Real>;
  if (c.rows[0].crush[b]) break_in_block<Real, false>(c, b, broken);
  BlockLaw now = law_of_block(c, b);
  follow_law(c, b, now);
  for (bool asked = false;;) {
    const Extremes<Real> e = theta_of_block(c, b, now);
    // A little less than what breaks: what decides is another sum, of the same terms.
    if (!asked && __builtin_expect(S::any(e.high > c.law.e_break * Real(0.999)), 0)) {
      asked = true;
      if (break_in_block<Real, false>(c, b, broken)) continue;
    }
    const BlockLaw before = now;
    now = law_for<Real>(S::max(e.high, -e.low), c.law, before);
    follow_law(c, b, now);
    S::store(c.fields.strain + std::ptrdiff_t(b) * block, e.high);
    if (now <= before) return;
  }
}

template <class Real>
Broken dilatation(const ColumnFields<Real>& fields, const RowFields<Real>* rows,
                  const FamilyTables<Real>* tables, int nz, const BondLaw<Real>& law) {
  Broken broken;
  const Column<Real> column{fields, rows, tables, nz, law};
  for (int b = 0; b < rows[0].blocks; ++b)
    if (!rows[0].linear[b]) block_theta(column, b, broken);
  return broken;
}

template <class Real, bool masked, bool per_lane>
typename Simd<Real>::V force_by_law(const RowFields<Real>& f, const FamilyTables<Real>& t,
                                    const BondLaw<Real>& law, int b) {
  switch (law_of(f.state[b])) {
    case calm:
      return family_force<Real, calm, masked, per_lane>(f, t, law, b);
    case bent:
      return family_force<Real, bent, masked, per_lane>(f, t, law, b);
    default:
      return family_force<Real, wide, masked, per_lane>(f, t, law, b);
  }
}

template <class Real>
typename Simd<Real>::V force_by_state(const RowFields<Real>& f, const FamilyTables<Real>& t,
                                      const BondLaw<Real>& law, int b) {
  if (t.ends[b]) return force_by_law<Real, true, true>(f, t, law, b);
  if (f.state[b] & cracked) return force_by_law<Real, true, false>(f, t, law, b);
  return force_by_law<Real, false, false>(f, t, law, b);
}

// Acceleration of a block; the most that theta of both ends of its bonds can be.
template <class Real>
typename Simd<Real>::V force_of_block(const Column<Real>& c, int b) {
  const BlockLaw law = law_of(c.rows[0].state[b]);
  if (at_once(c, law))
    return run_column(
        c, b, law, [](const auto& p) -> const auto& { return p.force; });
  typename Simd<Real>::V both = {};
  for (int k = 0; k < c.nz; ++k)
    both = Simd<Real>::max(both, force_by_state(c.rows[k], c.tables[k], c.law, b));
  return both;
}

// Whether stresses may be near what breaks a bond: a little less, for what decides is another sum of the same
// terms. First by what they are at most, then by the largest one.
template <class Real>
bool is_near_breaking(const Column<Real>& c, int b, typename Simd<Real>::V both) {
  using S = Simd<Real>;
  const Real limit = Real(0.999) * 2 / c.law.stress_per_stretch,
             theta_as_strain = 2 * c.law.stress_per_theta / c.law.stress_per_stretch;
  const typename S::V strain = S::load(c.fields.strain + std::ptrdiff_t(b) * block);
  if (theta_as_strain >= 0 && !S::any(strain + theta_as_strain * both > limit)) return false;
  for (int k = 0; k < c.nz; ++k)
    if (S::any(family_stress(c.rows[k], c.tables[k], c.law, b) > limit)) return true;
  return false;
}

template <class Real>
void block_force(const Column<Real>& c, int b, Broken& broken) {
  const typename Simd<Real>::V both = force_of_block(c, b);
  if (!(c.law.stress_per_stretch > 0) || !is_near_breaking(c, b, both)) return;
  if (break_in_block<Real, true>(c, b, broken)) force_of_block(c, b);
}

template <class Real>
Broken force(const ColumnFields<Real>& fields, const RowFields<Real>* rows, const FamilyTables<Real>* tables,
             int nz, const BondLaw<Real>& law) {
  Broken broken;
  const Column<Real> column{fields, rows, tables, nz, law};
  for (int b = 0; b < rows[0].blocks; ++b)
    if (!rows[0].linear[b]) block_force(column, b, broken);
  return broken;
}

template <class Real>
Broken look_closer(const ColumnFields<Real>& fields, const RowFields<Real>* rows,
                   const FamilyTables<Real>* tables, int nz, const BondLaw<Real>& law, int b) {
  Broken broken;
  const Column<Real> column{fields, rows, tables, nz, law};
  if (break_in_block<Real, true>(column, b, broken)) force_of_block(column, b);
  return broken;
}

template <class Real>
void negative(const Real* numbers, int words, std::uint16_t* out) {
  using S = Simd<Real>;
  const typename S::Mask bits = S::lane_bits();
  for (int w = 0; w < words; ++w) {
    unsigned word = 0;
    for (int lane0 = 0; lane0 < block; lane0 += S::lanes) {
      const typename S::Mask below = S::load(numbers + std::ptrdiff_t(w) * block + lane0) < typename S::V{};
      if (S::any(below)) word |= S::compress(below, bits) << lane0;
    }
    out[w] = static_cast<std::uint16_t>(word);
  }
}

template <class Real>
void drift(const DriftRow<Real>& r, const DriftSettings& d) {
  using S = Simd<Real>;
  using V = typename S::V;
  const Real dt = static_cast<Real>(d.dt), gravity = static_cast<Real>(d.gravity),
             lift = static_cast<Real>(d.lift), inverse_dx = static_cast<Real>(d.inverse_dx),
             hull_step = static_cast<Real>(d.dt * d.V);
  for (int b = 0; b < r.blocks; ++b) {
    V fastest = {};
    for (int x = b * block; x < (b + 1) * block; x += S::lanes) {
      const V mobile = S::load(r.mobile + x);
      const V depth = (-(S::load(r.u[2] + x) + r.z)) * inverse_dx + Real(0.5);
      const V submerged = S::min(S::max(depth, V{}), S::splat(1));
      const V weight_and_lift = lift * submerged - gravity;
      V way2 = {};
      for (int c = 0; c < 3; ++c) {
        V a = S::load(r.acceleration[c] + x);
        if (c == 2) a += weight_and_lift;
        const V v = (S::load(r.v[c] + x) + dt * a) * mobile;
        S::store(r.v[c] + x, v);
        // Neumaier-style compensated sum: steps of 1e-5 m on displacements of a metre.
        const V u = S::load(r.u[c] + x);
        const V step = dt * v + S::load(r.residual[c] + x), way = c == 0 ? step - hull_step : step;
        const V sum = u + step;
        S::store(r.residual[c] + x, step - (sum - u));
        S::store(r.u[c] + x, sum);
        way2 += way * way;
      }
      fastest = S::max(fastest, way2);
    }
    r.travelled2[b] = S::largest(fastest);
  }
}

template <class Real>
constexpr Passes<Real> passes() {
  return {dilatation<Real>,
          force<Real>,
          look_closer<Real>,
          negative<Real>,
          drift<Real>,
          water_columns<Real>,
          water_push<Real>,
          {linear_passes<Real, 1>(), linear_passes<Real, 2>(), linear_passes<Real, 3>(),
           linear_passes<Real, 4>(), linear_passes<Real, 5>()},
          flatness<Real>};
}

}  // namespace
}  // namespace icebow
