// Pairs of particles that may touch: near each other, without a bond, wherever in the lattice they come from.
#pragma once

#include <cstddef>
#include <vector>

#include "base/communicator.h"
#include "base/vec.h"
#include "solver/ice/sheet.h"

namespace icebow {

class ContactPairs {
 public:
  struct Particle {
    Vec3 position, velocity;
  };
  struct Of {             // an own particle and its partners [begin, end)
    std::size_t address;  // in the fields
    int particle;
    int begin, end;
  };

  // Pairs nearer than `within` [m].
  ContactPairs(const Communicator& comm, double within) : comm_(comm), within_(within) {}

  // Both collective.
  void find(const IceSheet& sheet);
  void refresh(const IceSheet& sheet);  // where the particles of the pairs are now

  const std::vector<Of>& all() const { return all_; }
  const Particle& particle(int n) const { return particles_[n]; }
  // The mirror image of one at the symmetry plane of a half model.
  Particle partner(int n) const {
    Particle p = particles_[partners_[n].particle];
    if (partners_[n].image) {
      p.position.y() = -p.position.y();
      p.velocity.y() = -p.velocity.y();
    }
    return p;
  }

 private:
  struct Partner {
    int particle;  // in particles_
    bool image;
  };
  struct Own {
    int i, j, k;
    std::size_t address;
  };
  struct Candidate {
    int i, j, k;    // in the lattice; j below 0: the image of column -1 - j
    Vec3 position;  //!< [m]
    bool image;
    int origin;  // in the list of all ranks' candidates; of an image that of its original
  };
  std::vector<Candidate> candidates(const std::vector<double>& everyone, bool half) const;
  void pair_up(const IceSheet& sheet, const std::vector<Candidate>& all, int first);
  void keep_used(int first);
  static Particle state(const IceSheet& sheet, const Own& own);

  Communicator comm_;
  double within_;
  std::vector<Of> all_;
  std::vector<Partner> partners_;
  std::vector<Own> own_;             // this rank's; those that pairs use once they are found
  std::vector<Particle> particles_;  // own ones, then those of other ranks
  std::vector<int> lent_;            // own ones that other ranks need
  bool shared_ = false;              // whether any rank needs another's
};

}  // namespace icebow
