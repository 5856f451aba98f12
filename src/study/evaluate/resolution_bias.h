// By how much the mean load of a lattice differs from the load of an infinitely fine one.
#pragma once

#include "base/json.h"
#include "study/spec/study_spec.h"

namespace icebow {

// What is the same in all lattices: ice of one toughness is the stronger, the finer its lattice is.
enum class GivenStrength { toughness, stretch, calibration };
GivenStrength given_strength(const Case& c);

// {"known": false, "relative": null, "ci95": null, "sentence"}: no lattice's bias has been measured yet
// (docs/theory.md, "Resolution").
Json resolution_bias_json(const Case& c);

}  // namespace icebow
