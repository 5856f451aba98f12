#include <iostream>

#include "base/units.h"
#include "cli/commands.h"
#include "cli/study_choice.h"
#include "cli/text_table.h"
#include "study/evaluate/evaluator_inputs.h"
#include "study/evaluate/result_json.h"
#include "study/spec/spec_hints.h"

namespace icebow {
namespace {

std::string for_people(const std::string& design, const LindqvistInputs& in, const LindqvistResult& r) {
  const auto kilonewtons = [](double newtons) { return decimals(newtons / 1e3, 1); };
  std::string text = design + ": Lindqvist 1989, full scale, ice " + brief(in.h) + " m, " + brief(in.V) +
                     " m/s (" + brief(in.V / metres_per_second_per_knot) + " kn), flexural strength " +
                     brief(in.sigma_f / 1e3) + " kPa, friction " + brief(in.mu) + "\n\n";
  if (r.valid) {
    text += text_table({{"part", "kN"},
                        {"crushing", kilonewtons(r.crushing)},
                        {"bending", kilonewtons(r.bending)},
                        {"submersion", kilonewtons(r.submersion)},
                        {"breaking at speed", kilonewtons(r.breaking)},
                        {"total at speed", kilonewtons(r.total)}});
  }
  if (!r.caution.empty()) text += "caution: " + r.caution + "\n";
  return text;
}

}  // namespace

int run_resistance(const Communicator&, const Arguments& arguments) {
  const ChosenDesign chosen = choose_design(load_study(arguments), arguments);
  const LindqvistInputs inputs = lindqvist_inputs(chosen.description);
  const LindqvistResult result = lindqvist(inputs);
  if (arguments.has("--json")) {
    std::cout << Json{{"design", chosen.design.name},
                      {"lindqvist", lindqvist_json(result, inputs)},
                      {"inputs", lindqvist_inputs_json(inputs)}}
                     .dump(2)
              << "\n";
  } else {
    std::cout << for_people(chosen.design.name, inputs, result);
  }
  if (result.valid) return exit_code::ok;
  std::cerr << chosen.design.name << ": the formula does not apply: " << result.reason << "\n";
  return exit_code::failure;
}

}  // namespace icebow
