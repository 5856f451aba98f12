#include "cli/cost_text.h"

#include <algorithm>
#include <cmath>

#include "cli/text_table.h"
#include "study/look/study_cost.h"
#include "study/run/race_loop.h"
#include "study/spec/spec_hints.h"

namespace icebow {
namespace {

constexpr double measured_for = 5.0;  //!< [s]

std::string bytes(double number) {
  return number < 1e9 ? brief(std::round(number / 1e5) / 10.0) + " MB"
                      : brief(std::round(number / 1e8) / 10.0) + " GB";
}

std::string cost_words(const std::string& what, int number, const DesignCost& cost,
                       const Execution& execution) {
  const double minutes = cost.core_s / 60.0, hours = cost.core_s * number / 3600.0;
  std::string text = "  " + std::to_string(number) + " " + what + ": ";
  text += minutes < 0.1 ? decimals(cost.core_s, 3) + " s" : decimals(minutes, 1) + " min";
  text += " of a core each";
  if (execution.ranks_per_design > 1)
    text += " (" + decimals(minutes / execution.ranks_per_design, 1) + " min by " +
            std::to_string(execution.ranks_per_design) + " ranks)";
  return text + ", " + decimals(hours, 2) + " core hours, " + bytes(cost.bytes * number) + "\n";
}

// Voyages in a moving window cost by the metre.
std::string race_words(const StudySpec& spec, const StudyCost& cost) {
  const Case& c = spec.baseline;
  const double longest = longest_voyage(spec.decide, c);
  std::string text = "  the race's other legs come on top: all voyages as far as it may sail, " +
                     brief(longest) + " m, take " +
                     decimals(cost.design.core_s * cost.designs * longest / c.advance / 3600.0, 1) +
                     " core hours";
  if (spec.decide.budget_core_hours > 0.0)
    text += "; none is sailed on once " + brief(spec.decide.budget_core_hours) +
            " are spent (decide.budget_core_h)";
  return text + "\n";
}

std::string words_on(const StudyCost& cost, const StudySpec& spec, const std::string& of) {
  if (!cost.unknown.empty()) return "cost: not known: " + cost.unknown + "\n";
  std::string text = "cost, at most, by what this machine took for " + of + ":\n";
  text += cost_words(spec.decide.given   ? "first legs"
                     : cost.designs == 1 ? "design"
                                         : "designs",
                     cost.designs, cost.design, spec.execution);
  if (cost.confirmations > 0)
    text += cost_words("simulations", cost.confirmations, cost.confirmation, spec.execution);
  const double checkpoint = std::max(cost.design.checkpoint, cost.confirmation.checkpoint);
  if (checkpoint > 0.0)
    text += "  and " + bytes(checkpoint) + " for the checkpoint of each that is under way\n";
  if (spec.decide.given) text += race_words(spec, cost);
  if (cost.programs) text += "  programs of your own were not started: their time is not in it\n";
  return text;
}

}  // namespace

std::string cost_text(const StudySpec& spec, const StudyPlan& plan) {
  return words_on(study_cost(spec, plan, measured_for), spec, "the file's own design");
}

std::string cost_text(const StudySpec& spec, const Design& design) {
  return words_on(design_cost(spec, design, measured_for), spec, "this design");
}

}  // namespace icebow
