#include "study/evaluate/resolution_bias.h"

#include <cmath>

namespace icebow {
namespace {

const char* const strengths[] = {"toughness", "stretch", "calibration"};        // as GivenStrength
const char* const contacts[] = {"relocation", "paper", "penalty", "crushing"};  // as ContactRule

// Loads of 2 to 4 layers go with the sheet's flexural strength (docs/validation.md, "Seeds, resolution").
const char* without_limit(GivenStrength strength) {
  return strength == GivenStrength::toughness
             ? ". Ice of one toughness gets stronger, and its load higher, as the "
               "lattice gets finer, so far without a limit. Compare "
               "designs of one number of layers"
             : "";
}

}  // namespace

GivenStrength given_strength(const Case& c) {
  if (c.ice_model == IceModel::calibrated) return GivenStrength::calibration;
  return c.ice.s0 > 0.0 ? GivenStrength::stretch : GivenStrength::toughness;
}

Json resolution_bias_json(const Case& c) {
  const long layers = std::lround(c.ice.h / c.numerics.dx);
  const GivenStrength strength = given_strength(c);
  return {{"known", false},
          {"relative", nullptr},
          {"ci95", nullptr},
          {"sentence", "resolution bias: not known for this spacing (" + std::to_string(layers) +
                           " layers, strength by " + strengths[static_cast<int>(strength)] + ", contact " +
                           contacts[static_cast<int>(c.numerics.contact)] + ")" + without_limit(strength)}};
}

}  // namespace icebow
