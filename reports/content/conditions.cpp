#include "reports/content/conditions.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>

#include "base/json_fields.h"
#include "base/units.h"
#include "reports/content/all_runs.h"
#include "reports/text/text_format.h"
#include "study/evaluate/result_keys.h"
#include "study/spec/document_keys.h"
#include "study/spec/read_study.h"

namespace icebow {
namespace {

constexpr double alike = 1.25;  // strengths whose ratio is below are one ice

struct Condition {
  const char* label;
  const char* pointer;
  const char* unit;
  int decimals;
  double factor;
  bool of_ship;  // the ranking compares unlike things where it differs
  bool of_scenario = false;
};

const Condition all_conditions[] = {
    {"Ice thickness", result_key::thickness, "m", 2, 1.0, true, true},
    {"Ship speed", result_key::speed, "kn", 2, 1.0 / metres_per_second_per_knot, true, true},
    {"Flexural strength, formula", result_key::flexural_strength, "kPa", 0, 1e-3, true, true},
    {"Elastic modulus, formula", result_key::elastic_modulus, "GPa", 2, 1e-9, true, true},
    {"Hull friction", result_key::friction, "", 2, 1.0, true, true},
    {"Ship length", result_key::ship_length, "m", 1, 1.0, true},
    {"Beam", result_key::ship_beam, "m", 1, 1.0, true},
    {"Draught", result_key::draught, "m", 1, 1.0, true},
    {"Model scale", result_key::lambda, "", 0, 1.0, false},
};

struct Span {
  double lowest = INFINITY, highest = -INFINITY;
  bool given() const { return lowest <= highest; }
};

Span span_of(const StudyResults& study, const char* pointer, double factor) {
  Span span;
  const auto add = [&](const Json& result) {
    const double value = number_at(result, pointer) * factor;
    if (!std::isfinite(value)) return;
    span.lowest = std::min(span.lowest, value);
    span.highest = std::max(span.highest, value);
  };
  for (const RankedDesign& row : study.ranking.rows) add(row.evaluation.result);
  for (const Json& result : study.confirmations) add(result);
  return span;
}

// "1.00 m", or "0.80 to 1.20 m" where the designs differ.
std::string span_in_words(const Span& span, int decimals, const std::string& unit,
                          const std::string& before = "") {
  if (!span.given()) return {};
  const std::string low = fixed(span.lowest, decimals), high = fixed(span.highest, decimals);
  return before + low + (low == high ? "" : " to " + high) + (unit.empty() ? "" : "\u00a0" + unit);
}

std::optional<Case> simulated_case(const StudyResults& study) {
  try {
    return read_study(study.document, study.name).baseline;
  } catch (const std::exception&) {
    return std::nullopt;  // a study file this program cannot read: the results stand on their own
  }
}

std::string water_in_words(const Water& water) {
  if (!water.buoyancy_and_gravity) return "none: the ice has neither weight nor lift";
  std::string words = "weight and lift";
  if (water.added_mass > 0.0)
    words += ", added mass of a layer " + fixed(water.added_mass, 1) + "\u00a0m deep";
  if (water.inertia == WaterInertia::plane) words += ", inertia of the water plane";
  if (water.drag > 0.0) words += ", drag coefficient " + fixed(water.drag, 1);
  if (water.added_mass == 0.0 && water.inertia != WaterInertia::plane) words += ", no added mass";
  if (water.drag == 0.0) words += ", no drag";
  return words;
}

std::string sheet_in_words(const Sheet& sheet) {
  std::string words = fixed(sheet.length, 0) + "\u00a0m by " + fixed(sheet.width, 0) + "\u00a0m";
  if (sheet.window_ahead > 0.0) words += ", a window that moves with the ship";
  if (sheet.half_model) words += ", port half with its mirror image";
  if (sheet.absorbing > 0.0) words += ", edges damped over " + fixed(sheet.absorbing, 1) + "\u00a0m";
  return words + (sheet.fixed == FixedEdges::none ? ", edges free" : ", edges held");
}

std::string model_in_words(const std::string& model) {
  if (model == "paper") return "by its toughness, as published";
  if (model == "calibrated") return "calibrated to its strengths by virtual tests";
  return model;
}

void add(std::vector<Fact>& facts, const std::string& label, const std::string& value) {
  if (!value.empty()) facts.push_back({label, value});
}

std::string seeds_in_words(const StudyResults& study, const Case& c) {
  const int runs = run_counts(study).most;
  const std::string last = std::to_string(c.seed + static_cast<unsigned>(runs) - 1);
  if (c.seed == 0 && runs > 1)
    return "none in the first run of a design, whose ice starts at rest; 1" +
           (runs > 2 ? " to " + last + " in the others" : std::string(" in the second"));
  if (c.seed == 0) return "none: the ice starts at rest";
  return std::to_string(c.seed) + (runs > 1 ? " to " + last : "");
}

// Full scale where nothing else is said.
void add_simulated(const StudyResults& study, Conditions& found) {
  const Span layers = span_of(study, result_key::layers, 1.0);
  if (!layers.given()) return;
  const Span strength = span_of(study, result_key::simulated_flexural_strength, 1e-3);
  const Span model_modulus = span_of(study, result_key::bond_modulus, 1e-9);
  const Span lambda = span_of(study, result_key::lambda, 1.0);
  std::string model;
  for (const RankedDesign& row : study.ranking.rows)
    if (model.empty()) model = text_at(row.evaluation.result, result_key::simulated_ice_model);
  for (const Json& result : study.confirmations)
    if (model.empty()) model = text_at(result, result_key::simulated_ice_model);
  auto& facts = found.simulated;
  add(facts, "Flexural strength, by a virtual beam test", span_in_words(strength, 0, "kPa"));
  const double scale = lambda.given() ? lambda.highest : 1.0;
  add(facts, "Elastic modulus of the bonds",
      span_in_words({model_modulus.lowest * scale, model_modulus.highest * scale}, 2, "GPa"));
  add(facts, "Ice model", model_in_words(model));
  add(facts, "Layers through the thickness", span_in_words(layers, 0, ""));
  const auto given = simulated_case(study);
  if (given) {
    add(facts, "Spacing of the particles",
        fixed(given->numerics.dx, 3) + "\u00a0m, model " +
            fixed(given->numerics.dx * 1e3 / given->lambda, 1) + "\u00a0mm");
    add(facts, "Water", water_in_words(given->water));
    add(facts, "Sheet", sheet_in_words(given->sheet));
    add(facts, "Ice against ice",
        given->numerics.floe_contact
            ? "pieces push each other, friction " + fixed(given->numerics.floe_friction, 2)
            : "pieces pass through each other");
    add(facts, "Seeds of the ice", seeds_in_words(study, *given));
  }
  found.ice = "Simulated ice: " +
              (strength.given() ? span_in_words(strength, 0, "kPa") + " in bending" : "strength not known") +
              (model.empty() ? "" : ", " + model_in_words(model)) + ", " + span_in_words(layers, 0, "layers");
}

// "Ship speed is 2.00 to 5.00 kn", of each condition that differs.
std::vector<std::string> differences(const StudyResults& study) {
  std::vector<std::string> words;
  for (const Condition& c : all_conditions) {
    const Span span = span_of(study, c.pointer, c.factor);
    if (c.of_ship && span.given() && fixed(span.lowest, c.decimals) != fixed(span.highest, c.decimals))
      words.push_back(std::string(c.label) + " is " + span_in_words(span, c.decimals, c.unit));
  }
  return words;
}

// "0.60 m of 500 kPa at 3 kn"; nothing where it is not known.
std::string ice_and_speed(const std::shared_ptr<const Case>& c) {
  if (!c) return {};
  return fixed(c->ice.h, 2) + "\u00a0m of " + fixed(c->flexural_strength / 1e3, 0) + "\u00a0kPa at " +
         fixed(c->V / metres_per_second_per_knot, 1) + "\u00a0kn";
}

// "thin (0.60 m of 500 kPa at 3 kn, weight 0.7) and thick (1.20 m of 500 kPa at 2 kn, weight 0.3)".
std::string scenarios_in_words(const StudyResults& study) {
  const Json& list = part_at(study.document, document_key::scenarios);
  if (!list.is_array() || list.empty()) return {};
  const auto given = simulated_case(study);
  std::vector<std::string> words;
  for (std::size_t n = 0; n < list.size(); ++n) {
    const double weight = number_at(list[n], document_key::scenario_weight);
    std::vector<std::string> of_it;
    if (given && n < given->scenarios.size()) of_it.push_back(ice_and_speed(given->scenarios[n].given));
    if (std::isfinite(weight)) of_it.push_back("weight " + csv_number(weight));
    std::string inside;
    for (const std::string& part : of_it) inside += (inside.empty() || part.empty() ? "" : ", ") + part;
    words.push_back(text_at(list[n], document_key::scenario_name) +
                    (inside.empty() ? "" : " (" + inside + ")"));
  }
  return listed(words, 8);
}

// The ice the cycle and the formula take.
std::string formula_ice(const StudyResults& study) {
  const Span strength = span_of(study, result_key::flexural_strength, 1e-3);
  const Span thickness = span_of(study, result_key::thickness, 1.0);
  if (!strength.given()) return {};
  return span_in_words(thickness, 2, "m") + " thick, " + span_in_words(strength, 0, "kPa");
}

}  // namespace

std::string unlike_ice_words(const Json& result) {
  const double simulated = number_at(result, result_key::simulated_flexural_strength);
  const double formula = number_at(result, result_key::flexural_strength);
  if (!(simulated > 0.0) || !(formula > 0.0)) return {};
  const double ratio = std::max(simulated / formula, formula / simulated);
  if (ratio < alike) return {};
  return "simulated in ice of " + fixed(simulated / 1e3, 0) + "\u00a0kPa, the formula in ice of " +
         fixed(formula / 1e3, 0) + "\u00a0kPa";
}

std::string over_scenarios(const Json& document) {
  const Json& list = part_at(document, document_key::scenarios);
  if (!list.is_array() || list.empty()) return {};
  return " over " + std::to_string(list.size()) + " scenarios, by their " +
         (text_at(document, document_key::over_scenarios) == "worst" ? "worst" : "weighted mean");
}

Conditions conditions(const StudyResults& study) {
  Conditions found;
  const std::string scenarios = scenarios_in_words(study);
  add(found.shared, "Scenarios", scenarios);
  for (const Condition& c : all_conditions)
    if (scenarios.empty() || !c.of_scenario)
      add(found.shared, c.label,
          span_in_words(span_of(study, c.pointer, c.factor), c.decimals, c.unit,
                        c.label == std::string("Model scale") ? "1\u2009:\u2009" : ""));
  add_simulated(study, found);
  for (const RankedDesign& row : study.ranking.rows)
    if (found.unlike_ices.empty()) found.unlike_ices = unlike_ice_words(row.evaluation.result);
  const std::string formula = scenarios.empty() ? formula_ice(study) : "";
  if (!scenarios.empty()) found.ice = "Loads" + over_scenarios(study.document) + ": " + scenarios + ".";
  if (found.ice.empty() && !formula.empty())
    found.ice = "Ice: " + formula + " in bending.";
  else if (!found.unlike_ices.empty())
    found.ice += ". The formula's ice has " +
                 span_in_words(span_of(study, result_key::flexural_strength, 1e-3), 0, "kPa") +
                 ": their loads are of unlike ices.";
  else if (!found.ice.empty() && scenarios.empty())
    found.ice += formula.empty() ? "." : "; the formula takes " + formula + ".";
  const std::vector<std::string> unlike = differences(study);
  if (!unlike.empty())
    found.unlike_ships = "The ranking compares unlike cases: " + listed(unlike, unlike.size()) + ".";
  return found;
}

}  // namespace icebow
