#include "solver/contact/contact_pairs.h"

#include <algorithm>

namespace icebow {
namespace {

constexpr std::size_t of_borrowed = 6;  // numbers: place, velocity

}  // namespace

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
  borrowed_ = EverywhereGather(comm_, of_borrowed * lent_.size());
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

// Place and velocity of each that is lent.
template <class Real>
void ContactPairs::send_lent(const IceSheet& sheet) {
  std::vector<double> lent;
  for (const int n : lent_) {
    const std::size_t p = own_[n].address;
    for (int c = 0; c < 3; ++c) lent.push_back(own_[n].reference[c] + sheet.u[c].data<Real>()[p]);
    for (int c = 0; c < 3; ++c) lent.push_back(sheet.v[c].data<Real>()[p]);
  }
  borrowed_.start(lent);
}

void ContactPairs::send(const IceSheet& sheet) {
  if (borrowed_.size() == 0) return;
  if (sheet.precision == Precision::fp64) {
    send_lent<double>(sheet);
  } else {
    send_lent<float>(sheet);
  }
}

// In rank order, as the patches are: `wanted` of all ranks, one after the other.
void ContactPairs::take_borrowed() {
  const std::vector<double>& all = borrowed_.finish();
  for (std::size_t n = 0; n < all.size() / of_borrowed; ++n) {
    const double* const at = &all[of_borrowed * n];
    position_[own_.size() + n] = Vec3(at[0], at[1], at[2]);
    borrowed_velocity_[n] = Vec3(at[3], at[4], at[5]);
  }
}

void ContactPairs::refresh(const IceSheet& sheet) {
  if (!borrowed_.under_way()) send(sheet);
  if (sheet.precision == Precision::fp64) {
    place_own<double>(sheet);
  } else {
    place_own<float>(sheet);
  }
  if (borrowed_.under_way()) take_borrowed();
}

}  // namespace icebow
