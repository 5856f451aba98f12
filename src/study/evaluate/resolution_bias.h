// By how much the mean load of a lattice differs from that of an infinitely fine one, where that was
// measured.
#pragma once

#include <string>
#include <vector>

#include "base/json.h"
#include "study/spec/study_spec.h"

namespace icebow {

// What is the same in all lattices: ice of one toughness is the stronger, the finer its lattice is.
enum class GivenStrength { toughness, stretch, calibration };
GivenStrength given_strength(const Case& c);

struct ResolutionBias {
  int layers = 0;
  GivenStrength strength = GivenStrength::toughness;
  ContactRule contact = ContactRule::relocation;
  double relative = 0.0;  // load / extrapolated limit - 1
  double ci95 = 0.0;      // half width of its 95 % interval
};

// The table compiled in: studies/convergence/bias.json, {"format": 1, "entries": [{"layers", "strength",
// "contact", "load_over_limit", "ci95"}]}, written by studies/convergence/extrapolate.py. Throws InputError
// for a table of another form.
std::vector<ResolutionBias> parse_bias_table(const Json& table);
const std::vector<ResolutionBias>& bias_table();

// {"known", "relative", "ci95", "sentence"} for a case's lattice; null numbers where it is not known.
Json resolution_bias_json(const Case& c, const std::vector<ResolutionBias>& table = bias_table());

}  // namespace icebow
