// Blocks of columns near cracks as patches of ice with a box each: what may touch is looked for patch by
// patch.
#pragma once

#include <array>
#include <vector>

#include "base/communicator.h"
#include "base/vec.h"
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

  const std::vector<Patch>& all() const { return patches_; }

  int particles() const { return layers_ * block; }  // of a patch
  // [layer][x, y, z][lane], far away where there is none.
  const float* places(const Patch& p) const {
    return &places_[(&p - patches_.data()) * std::size_t(3 * particles())];
  }
  Vec3 place(int patch, int particle) const {
    const float* const x =
        &places_[(std::size_t(patch) * layers_ + particle / block) * 3 * block + particle % block];
    return {x[0], x[block], x[2 * block]};
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
};

}  // namespace icebow
