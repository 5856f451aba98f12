// Pairs of particles that may touch: near each other, without a bond, wherever in the lattice they come from.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "base/collective.h"
#include "base/communicator.h"
#include "base/vec.h"
#include "solver/contact/candidate_pairs.h"
#include "solver/contact/patches.h"
#include "solver/ice/sheet.h"

namespace icebow {

class ContactPairs {
 public:
  enum Kind : std::uint8_t {
    both,     // two own particles: once for both
    alone,    // the second is another rank's
    mirrored  // the mirror image of the second at the symmetry plane of a half model, which is another's or
              // own
  };
  struct Pair {
    int first, second;
    Kind kind;
  };

  // Pairs nearer than `within` [m].
  ContactPairs(const Communicator& comm, double within)
      : comm_(comm), within_(within), candidates_(within), borrowed_(comm, 0) {}

  // The ice has been renumbered since pairs were found.
  void forget() { candidates_.forget(); }
  // All collective.
  void find(const IceSheet& sheet);
  // Where the particles of the pairs are now. What other ranks need of it may be sent before, as soon as this
  // rank's particles have moved.
  void send(const IceSheet& sheet);
  void refresh(const IceSheet& sheet);

  const std::vector<Pair>& all() const { return all_; }  // in no order that means anything
  // The particles of the pairs: own ones by their place in the fields, then those of other ranks.
  int own() const { return static_cast<int>(own_.size()); }
  std::size_t address(int n) const { return own_[n].address; }
  const Vec3& position(int n) const { return position_[n]; }
  // v: the sheet's velocities.
  template <class Real>
  Vec3 velocity(const Real* const (&v)[3], int n) const {
    if (n >= own()) return borrowed_velocity_[n - own()];
    const std::size_t p = own_[n].address;
    return {v[0][p], v[1][p], v[2][p]};
  }

 private:
  struct Own {
    Vec3 reference;  //!< place in the sheet [m]
    std::size_t address;
  };
  void keep_used(const IceSheet& sheet, const Patches& patches);
  std::vector<double> wanted(const Patches& patches) const;
  void number_own(const IceSheet& sheet, const Patches& patches, std::vector<int>& place);
  template <class Real>
  void place_own(const IceSheet& sheet);
  template <class Real>
  void send_lent(const IceSheet& sheet);
  void take_borrowed();

  Communicator comm_;
  double within_;
  CandidatePairs candidates_;
  std::vector<Pair> all_;
  std::vector<Own> own_;
  std::vector<Vec3> position_, borrowed_velocity_;
  std::vector<int> lent_;  // own ones that other ranks need
  EverywhereGather borrowed_;
};

}  // namespace icebow
