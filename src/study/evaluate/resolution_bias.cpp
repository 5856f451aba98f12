#include "study/evaluate/resolution_bias.h"

#include <cmath>

#include "base/errors.h"
#include "study/spec/spec_hints.h"

namespace icebow {

extern const char* const resolution_table;  // resolution_table.cpp.in

namespace {

const char* const file = "studies/convergence/bias.json";
const char* const strengths[] = {"toughness", "stretch", "calibration"};        // as GivenStrength
const char* const contacts[] = {"relocation", "paper", "penalty", "crushing"};  // as ContactRule

template <std::size_t n>
int index_of(const char* const (&words)[n], const Json& entry, const char* key, const std::string& at) {
  const std::string word = entry.value(key, std::string());
  std::string allowed;
  for (std::size_t i = 0; i < n; ++i) {
    if (word == words[i]) return static_cast<int>(i);
    allowed += std::string(i ? ", " : "") + words[i];
  }
  throw InputError(file, {{at + "/" + key, "is \"" + word + "\", must be one of " + allowed}});
}

double number_in(const Json& entry, const char* key, double lowest, double highest, const std::string& at) {
  const auto value = entry.find(key);
  if (value != entry.end() && value->is_number() && value->get<double>() >= lowest &&
      value->get<double>() <= highest)
    return value->get<double>();
  throw InputError(file, {{at + "/" + key, "is " + (value == entry.end() ? "missing" : value->dump()) +
                                               ", allowed " + brief(lowest) + " to " + brief(highest)}});
}

// Loads of 2 to 4 layers go with the sheet's flexural strength (docs/validation.md, "Seeds, resolution").
const char* without_limit(GivenStrength strength) {
  return strength == GivenStrength::toughness
             ? ". Ice of one toughness gets stronger, and its load higher, as the "
               "lattice gets finer, so far without a limit. Compare "
               "designs of one number of layers"
             : "";
}

std::string percent(double share) {
  return std::to_string(std::lround(100.0 * std::abs(share)));
}

}  // namespace

GivenStrength given_strength(const Case& c) {
  if (c.ice_model == IceModel::calibrated) return GivenStrength::calibration;
  return c.ice.s0 > 0.0 ? GivenStrength::stretch : GivenStrength::toughness;
}

std::vector<ResolutionBias> parse_bias_table(const Json& table) {
  if (!table.is_object() || table.value("format", 0) != 1 || !table.contains("entries") ||
      !table.at("entries").is_array())
    throw InputError(file, {{"", "must be {\"format\": 1, \"entries\": [...]}"}});
  std::vector<ResolutionBias> result;
  for (const Json& entry : table.at("entries")) {
    const std::string at = "/entries/" + std::to_string(result.size());
    if (!entry.is_object()) throw InputError(file, {{at, "must be an object"}});
    ResolutionBias bias;
    bias.layers = static_cast<int>(number_in(entry, "layers", 1, 50, at));
    bias.strength = static_cast<GivenStrength>(index_of(strengths, entry, "strength", at));
    bias.contact = static_cast<ContactRule>(index_of(contacts, entry, "contact", at));
    bias.relative = number_in(entry, "load_over_limit", 0.01, 100, at) - 1.0;
    bias.ci95 = number_in(entry, "ci95", 0.0, 100, at);
    result.push_back(bias);
  }
  return result;
}

const std::vector<ResolutionBias>& bias_table() {
  static const std::vector<ResolutionBias> table = parse_bias_table(parse_json(resolution_table, file));
  return table;
}

Json resolution_bias_json(const Case& c, const std::vector<ResolutionBias>& table) {
  const int layers = static_cast<int>(std::lround(c.ice.h / c.numerics.dx));
  const GivenStrength strength = given_strength(c);
  for (const ResolutionBias& bias : table) {
    if (bias.layers != layers || bias.strength != strength || bias.contact != c.numerics.contact) continue;
    return {{"known", true},
            {"relative", bias.relative},
            {"ci95", bias.ci95},
            {"sentence", "resolution bias: loads of " + std::to_string(layers) + " layers are " +
                             percent(bias.relative) + " % " + (bias.relative < 0.0 ? "below" : "above") +
                             " the limit of fine lattices, \u00b1 " + percent(bias.ci95) +
                             " % (95 %; of the published conventional bow)"}};
  }
  return {{"known", false},
          {"relative", nullptr},
          {"ci95", nullptr},
          {"sentence", "resolution bias: not known for this spacing (" + std::to_string(layers) +
                           " layers, strength by " + strengths[static_cast<int>(strength)] + ", contact " +
                           contacts[static_cast<int>(c.numerics.contact)] + ")" + without_limit(strength)}};
}

}  // namespace icebow
