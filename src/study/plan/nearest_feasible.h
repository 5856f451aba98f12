// A feasible bow near one that is not, as a whole: advice margin by margin can break one margin by mending
// another.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "hullgen/bow/bow_volume.h"

namespace icebow {

struct NearestBow {
  BowParameters bow;  // feasible; angles and lengths to as few decimals as that allows
  std::vector<std::string>
      changes;  // "stem angle 10.76 -> 13.20 deg", by parameter; those that stay are left out
};

// The four angles, the bow length and the ship's length may change; 5 deg of an angle count as much as a
// tenth of a length, and the sum of squares is the least that NLopt's COBYLA finds over the closed-form
// margins. Nothing where dimensions are the matter (g6: no range of angles helps), or none is found within 30
// deg, half to twice the bow length and up to twice the ship's.
// With a displacement that is held, the dimension that keeps it follows, as in a study (spec_hold.h), and is
// told with the changes.
std::optional<NearestBow> nearest_feasible(const BowParameters& bow,
                                           const std::optional<HeldDisplacement>& held = {});

// "the nearest feasible bow as a whole: stem angle ..., bow length ..."; "" where there is none.
std::string nearest_feasible_words(const BowParameters& bow,
                                   const std::optional<HeldDisplacement>& held = {});

}  // namespace icebow
