// Blocks of columns near cracks as patches of ice with a box each: what may touch is looked for patch by
// patch.
#pragma once

#include <array>
#include <vector>

#include "base/communicator.h"
#include "solver/ice/bond_query.h"
#include "solver/ice/sheet.h"

namespace icebow {

// All ranks' patches, and behind them mirror images of those near the symmetry plane of a half model.
class Patches {
 public:
  struct Patch {
    int j, b;    // column of the lattice (below 0: the image of -1 - j), block of the sheet
    int number;  // of its first particle among all ranks'; an image has its original's
    bool image, cracked;
    float lower[3], upper[3];  //!< box of its particles [m]
  };
  // Collective. Images of what is nearer than `within` [m] to the plane.
  Patches(const Communicator& comm, const IceSheet& sheet, double within);

  // visit(patch, patch) for those of which particles may be nearer than `within` to each other, without
  // bonds: the first is this rank's; once where both are. A patch meets itself.
  template <class Visit>
  void for_each_meeting(double within, Visit visit) const;

  int particles() const { return layers_ * block; }  // of a patch
  // [layer][x, y, z][lane], far away where there is none.
  const float* places(const Patch& p) const {
    return &places_[(&p - patches_.data()) * std::size_t(3 * particles())];
  }
  BondQuery::Place in_lattice(const Patch& p, int particle) const {
    return {p.b * block + particle % block, p.j, particle / block};
  }
  bool is_own(const Patch& p) const { return !p.image && is_own(p.number); }
  bool is_own(int number) const { return number >= first_ && number < first_ + own() * particles(); }
  int first() const { return first_; }  // number of the first own particle
  int own() const { return own_; }      // patches: the columns one after the other
  const Patch& own_patch(int n) const { return patches_[first_ / particles() + n]; }

 private:
  std::vector<double> own_numbers(const Communicator& comm, const IceSheet& sheet);
  void add(const Lattice& lattice, const double* numbers);
  void add_images(double within);
  void find_box(Patch& patch) const;

  int layers_, own_ = 0, first_ = 0;
  std::vector<Patch> patches_;
  std::vector<float> places_;
  std::vector<int> by_y_;  // patches by the lower ends of their boxes across the course
};

// Ice that hangs together: no particle of the one can touch one of the other.
inline bool hang_together(const Patches::Patch& a, const Patches::Patch& b) {
  return !a.cracked && !b.cracked && std::abs(a.j - b.j) < reach && std::abs(a.b - b.b) <= 1;
}

inline bool boxes_meet(const Patches::Patch& a, const Patches::Patch& b, int axis, float within) {
  return a.lower[axis] <= b.upper[axis] + within && b.lower[axis] <= a.upper[axis] + within;
}

template <class Visit>
void Patches::for_each_meeting(double distance, Visit visit) const {
  const float within = static_cast<float>(distance);
  for (auto at = by_y_.begin(); at != by_y_.end(); ++at) {
    const Patch& a = patches_[*at];
    for (auto next = at; next != by_y_.end() && patches_[*next].lower[1] <= a.upper[1] + within; ++next) {
      const Patch& b = patches_[*next];
      if (!boxes_meet(a, b, 0, within) || !boxes_meet(a, b, 2, within) || hang_together(a, b)) continue;
      if (is_own(a)) {
        visit(a, b);
      } else if (is_own(b)) {
        visit(b, a);
      }
    }
  }
}

}  // namespace icebow
