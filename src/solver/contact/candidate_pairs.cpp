#include "solver/contact/candidate_pairs.h"

#include <algorithm>
#include <cstdlib>
#include <numeric>
#include <utility>

#include "solver/ice/bond_query.h"

namespace icebow {
namespace {

// Of the distance within which pairs are wanted: how much further apart candidates may be. Patches that move
// with the ship are looked at every fourth time.
constexpr double slack = 0.4;
// What a patch's particles may move until it is looked at again: with room for rounding less than half of
// that.
constexpr double way = 0.49 * slack;

// Ice that hangs together: no particle of the one can touch one of the other.
bool hang_together(const Patches::Patch& a, const Patches::Patch& b) {
  return !a.cracked && !b.cracked && std::abs(a.j - b.j) < reach && std::abs(a.b - b.b) <= 1;
}

bool boxes_meet(const Patches::Patch& a, const Patches::Patch& b, int axis, float within) {
  return a.lower[axis] <= b.upper[axis] + within && b.lower[axis] <= a.upper[axis] + within;
}

// No number where either is none; without a branch.
float larger(float a, float b) {
  return (a >= b) | (a != a) ? a : b;
}

// Squared way of the patch's fastest particle; what is nowhere has not moved.
float moved2(const float* from, const float* to, int layers) {
  float most[block] = {};
  for (int k = 0; k < layers; ++k) {
    float sum[block] = {};
    for (int c = 0; c < 3; ++c) {
      const float *const x0 = from + (3 * k + c) * block, *const x1 = to + (3 * k + c) * block;
      for (int l = 0; l < block; ++l) {
        const float d = x1[l] == x0[l] ? 0.0F : x1[l] - x0[l];
        sum[l] += d * d;
      }
    }
    for (int l = 0; l < block; ++l) most[l] = larger(most[l], sum[l]);
  }
  float all = 0.0F;
  for (const float of_lane : most) all = larger(all, of_lane);
  return all;
}

}  // namespace

// For each patch of now its place among those seen, or -1.
std::vector<int> CandidatePairs::known(const Lattice& lattice, const Patches& patches) const {
  const auto key = [&](const Patches::Patch& p) {
    return std::size_t(p.j + lattice.ny) * lattice.blocks() + p.b;
  };
  std::vector<int> place(2 * std::size_t(lattice.ny) * lattice.blocks(), -1), result;
  for (std::size_t n = 0; n < seen_.size(); ++n) place[key(seen_[n].patch)] = static_cast<int>(n);
  for (const Patches::Patch& p : patches.all()) result.push_back(place[key(p)]);
  return result;
}

void CandidatePairs::look_at(const IceSheet& sheet, const Patches& patches) {
  const std::vector<int> before = known(sheet.lattice, patches);
  const std::size_t size = 3 * std::size_t(patches.particles());
  const float most = static_cast<float>(way * within_);
  std::vector<Seen> seen;
  std::vector<float> places(before.size() * size);
  std::vector<int> now(seen_.size(), -1);
  for (std::size_t n = 0; n < before.size(); ++n) {
    const Patches::Patch& p = patches.all()[n];
    const float* const at = patches.places(p);
    const int old = before[n];
    const std::int64_t bonds =
        patches.is_own(p) ? sheet.bond_mark(p.j - sheet.layout.j0, p.b - sheet.layout.i0 / block) : 0;
    const bool same = old >= 0 && seen_[old].patch.cracked == p.cracked && seen_[old].bonds == bonds &&
                      moved2(&places_[old * size], at, sheet.layout.nz) < most * most;
    seen.push_back(same ? Seen{seen_[old].patch, bonds, false} : Seen{p, bonds, true});
    std::copy_n(same ? &places_[old * size] : at, size, &places[n * size]);
    if (same) now[old] = static_cast<int>(n);
  }
  keep_found(now);
  seen_.swap(seen);
  places_.swap(places);
}

// Those of which neither patch is looked at anew; `now`: where seen patches are.
void CandidatePairs::keep_found(const std::vector<int>& now) {
  const auto is_out = [&](const Candidate& c) { return now[c.patch_a] < 0 || now[c.patch_b] < 0; };
  found_.erase(std::remove_if(found_.begin(), found_.end(), is_out), found_.end());
  for (Candidate& c : found_) {
    c.patch_a = now[c.patch_a];
    c.patch_b = now[c.patch_b];
  }
}

void CandidatePairs::search(const IceSheet& sheet, const Patches& patches) {
  const float within = static_cast<float>((1.0 + slack) * within_);
  const BondQuery bonds(sheet);
  const std::size_t size = 3 * std::size_t(patches.particles());
  std::vector<NearPair> near(std::size_t(patches.particles()) * patches.particles());
  const auto visit = [&](int a, int b) {
    const Patches::Patch &pa = seen_[a].patch, &pb = seen_[b].patch;
    const int found = sheet.kernel.near_pairs({&places_[a * size], pa.lower, pa.upper},
                                              {&places_[b * size], pb.lower, pb.upper}, sheet.layout.nz,
                                              within * within, a == b, near.data());
    for (int n = 0; n < found; ++n) {
      if (!bonds.alive(patches.in_lattice(pa, near[n].a), patches.in_lattice(pb, near[n].b)))
        found_.push_back({a, b, near[n]});
    }
  };
  std::vector<int> by_y(seen_.size());  // by the lower ends of the boxes across the course
  std::iota(by_y.begin(), by_y.end(), 0);
  std::sort(by_y.begin(), by_y.end(),
            [this](int a, int b) { return seen_[a].patch.lower[1] < seen_[b].patch.lower[1]; });
  for (auto at = by_y.begin(); at != by_y.end(); ++at) {
    const Seen& a = seen_[*at];
    const float end = a.patch.upper[1] + within;
    for (auto next = at; next != by_y.end() && seen_[*next].patch.lower[1] <= end; ++next) {
      const Seen& b = seen_[*next];
      if ((!a.anew && !b.anew) || !boxes_meet(a.patch, b.patch, 0, within) ||
          !boxes_meet(a.patch, b.patch, 2, within) || hang_together(a.patch, b.patch))
        continue;
      if (patches.is_own(patches.all()[*at])) {
        visit(*at, *next);
      } else if (patches.is_own(patches.all()[*next])) {
        visit(*next, *at);
      }
    }
  }
}

const std::vector<CandidatePairs::Candidate>& CandidatePairs::find(const IceSheet& sheet,
                                                                   const Patches& patches) {
  if (seen_.empty()) found_.clear();
  look_at(sheet, patches);
  search(sheet, patches);
  return found_;
}

}  // namespace icebow
