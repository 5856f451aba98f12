#include "solver/contact/contact_pairs.h"

#include <algorithm>

namespace icebow {

void ContactPairs::find(const IceSheet& sheet) {
  all_.clear();
  const Patches patches(comm_, sheet, within_);
  const double within2 = within_ * within_;
  for (const CandidatePairs::Candidate& c : candidates_.find(sheet, patches)) {
    const auto [in_a, in_b] = c.particles;
    if (!((patches.place(c.patch_b, in_b) - patches.place(c.patch_a, in_a)).squaredNorm() < within2))
      continue;
    const Patches::Patch &a = patches.all()[c.patch_a], &b = patches.all()[c.patch_b];
    all_.push_back({a.number + in_a, b.number + in_b, patches.is_own(b) ? both : b.image ? mirrored : alone});
  }
  keep_used(sheet, patches);
  refresh(sheet);
}

// Other ranks' particles that this one needs, by their numbers.
std::vector<double> ContactPairs::wanted(const Patches& patches) const {
  std::vector<double> needed;
  for (const Pair& pair : all_)
    if (!patches.is_own(pair.second)) needed.push_back(pair.second);
  std::sort(needed.begin(), needed.end());
  needed.erase(std::unique(needed.begin(), needed.end()), needed.end());
  return needed;
}

// Who lends which particles to others; and from numbers among all patches' particles to those of own_ and
// what is behind them.
void ContactPairs::keep_used(const IceSheet& sheet, const Patches& patches) {
  std::vector<double> all_wanted = comm_.gather_everywhere(wanted(patches));
  std::sort(all_wanted.begin(), all_wanted.end());
  all_wanted.erase(std::unique(all_wanted.begin(), all_wanted.end()), all_wanted.end());
  shared_ = !all_wanted.empty();

  constexpr int used = 0;
  std::vector<int> place(std::size_t(patches.own()) * patches.particles(), -1);
  const auto own_place = [&](int number) -> int& { return place[number - patches.first()]; };
  for (const Pair& pair : all_) {
    own_place(pair.first) = used;
    if (patches.is_own(pair.second)) own_place(pair.second) = used;
  }
  for (const double n : all_wanted)
    if (patches.is_own(int(n))) own_place(int(n)) = used;
  number_own(sheet, patches, place);

  lent_.clear();
  for (const double n : all_wanted)
    if (patches.is_own(int(n))) lent_.push_back(own_place(int(n)));
  for (Pair& pair : all_) {
    pair.first = own_place(pair.first);
    if (patches.is_own(pair.second)) {
      pair.second = own_place(pair.second);
    } else {
      const auto at = std::lower_bound(all_wanted.begin(), all_wanted.end(), double(pair.second));
      pair.second = own() + static_cast<int>(at - all_wanted.begin());
    }
  }
  position_.assign(own_.size() + all_wanted.size(), Vec3::Zero());
  borrowed_velocity_.assign(all_wanted.size(), Vec3::Zero());
}

// Particles with a place at all, in the order of their addresses.
void ContactPairs::number_own(const IceSheet& sheet, const Patches& patches, std::vector<int>& place) {
  own_.clear();
  const Lattice& lattice = sheet.lattice;
  const Layout& layout = sheet.layout;
  for (int begin = 0, end = 0; begin < patches.own(); begin = end) {
    const int j = patches.own_patch(begin).j;
    while (end < patches.own() && patches.own_patch(end).j == j) ++end;
    for (int k = 0; k < layout.nz; ++k) {
      for (int n = begin; n < end; ++n) {
        const int i = patches.own_patch(n).b * block;
        for (int l = 0; l < block; ++l) {
          int& at = place[n * patches.particles() + k * block + l];
          if (at < 0) continue;
          at = own();
          own_.push_back({Vec3(lattice.x(i + l), lattice.y(j), lattice.z(k)),
                          layout.row(j - layout.j0, k) + (i + l - layout.i0)});
        }
      }
    }
  }
}

template <class Real>
void ContactPairs::place_own(const IceSheet& sheet) {
  const Real* const u[3] = {sheet.u[0].data<Real>(), sheet.u[1].data<Real>(), sheet.u[2].data<Real>()};
  for (std::size_t n = 0; n < own_.size(); ++n) {
    const std::size_t p = own_[n].address;
    position_[n] = own_[n].reference + Vec3(u[0][p], u[1][p], u[2][p]);
  }
}

void ContactPairs::refresh(const IceSheet& sheet) {
  if (sheet.precision == Precision::fp64) {
    place_own<double>(sheet);
    if (shared_) exchange<double>(sheet);
  } else {
    place_own<float>(sheet);
    if (shared_) exchange<float>(sheet);
  }
}

template <class Real>
void ContactPairs::exchange(const IceSheet& sheet) {
  const Real* const all[3] = {sheet.v[0].data<Real>(), sheet.v[1].data<Real>(), sheet.v[2].data<Real>()};
  std::vector<double> lent;
  for (const int n : lent_) {
    const Vec3 &x = position_[n], v = velocity(all, n);
    lent.insert(lent.end(), {x.x(), x.y(), x.z(), v.x(), v.y(), v.z()});
  }
  // In rank order, as the patches are: `wanted` of all ranks, one after the other.
  const std::vector<double> borrowed = comm_.gather_everywhere(lent);
  for (std::size_t n = 0; n < borrowed.size() / 6; ++n) {
    const double* v = &borrowed[6 * n];
    position_[own_.size() + n] = Vec3(v[0], v[1], v[2]);
    borrowed_velocity_[n] = Vec3(v[3], v[4], v[5]);
  }
}

}  // namespace icebow
