// Particles without a bond that may come near each other: looked for again only where ice has moved or
// cracked since.
#pragma once

#include <cstdint>
#include <vector>

#include "solver/contact/patches.h"
#include "solver/ice/sheet.h"

namespace icebow {

class CandidatePairs {
 public:
  // Two particles by their patches' places in Patches::all(); the first is this rank's.
  struct Candidate {
    int patch_a, patch_b;
    NearPair particles;
  };
  // Pairs nearer than `within` [m].
  explicit CandidatePairs(double within) : within_(within) {}

  // All those pairs, each once, and others that are a little further apart.
  const std::vector<Candidate>& find(const IceSheet& sheet, const Patches& patches);
  // The ice has been renumbered: nothing is known of it any more.
  void forget() { seen_.clear(); }

 private:
  // A patch as it was when it was looked at.
  struct Seen {
    Patches::Patch patch;
    std::int64_t bonds;  // IceSheet::bond_mark() of an own one
    bool anew;           // looked at now
  };
  std::vector<int> known(const Lattice& lattice, const Patches& patches) const;
  void look_at(const IceSheet& sheet, const Patches& patches);
  void keep_found(const std::vector<int>& now);
  void search(const IceSheet& sheet, const Patches& patches);

  double within_;
  std::vector<Seen> seen_;        // of each patch
  std::vector<float> places_;     // Patches::places() of these
  std::vector<Candidate> found_;  // by these
};

}  // namespace icebow
