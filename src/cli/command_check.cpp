#include <algorithm>
#include <cmath>
#include <iostream>

#include "base/errors.h"
#include "base/json_fields.h"
#include "base/printable.h"
#include "base/units.h"
#include "cli/commands.h"
#include "cli/study_choice.h"
#include "cli/text_table.h"
#include "solver/lattice/lattice.h"
#include "solver/run/simulation.h"
#include "study/evaluate/calibration.h"
#include "study/look/study_cost.h"
#include "study/plan/feasible_box.h"
#include "study/plan/nearest_feasible.h"
#include "study/plan/variable_ranges.h"
#include "study/spec/case_hull.h"
#include "study/spec/document_keys.h"
#include "study/spec/spec_hints.h"
#include "study/spec/spec_hold.h"
#include "study/spec/spec_method.h"

namespace icebow {
namespace {

constexpr std::size_t most_listed = 30;

std::string range_of(const Variable& v) {
  if (v.values.empty())
    return brief(v.lower) + " to " + brief(v.upper) +
           (v.levels > 0 ? " in " + std::to_string(v.levels) + " levels" : "");
  if (!v.words.empty()) return listed(v.words);
  std::vector<std::string> words;
  for (const double value : v.values) words.push_back(brief(value));
  return listed(words);
}

std::string method_lines(const StudySpec& spec, const StudyPlan& plan) {
  std::string text = "method: " + method_name(spec.method.type);
  if (spec.method.type == MethodType::optimise) {
    const Algorithm* algorithm = find_algorithm(spec.method.algorithm);
    text += " by " + spec.method.algorithm + " (" + algorithm->meaning + "), up to " +
            std::to_string(spec.method.max_evaluations) + " points" +
            (plan.proposals < spec.method.max_evaluations ? ", the baseline among them" : "");
  }
  text += ", ranked by " + spec.rank_by;
  if (spec.second.given())
    text += ", against " + std::string(spec.second.largest ? "largest " : "smallest ") + spec.second.by;
  text += "\n";
  for (const Variable& v : spec.method.variables) text += "  " + v.pointer + ": " + range_of(v) + "\n";
  const Json& derived = part_at(spec.document, document_key::derived);
  for (const auto& [pointer, expression] : derived.items())  // none of null
    text += "  " + pointer + " = " + printable(expression.get<std::string>()) + "\n";
  return text;
}

// A design as far as it is known without a mesh.
std::string verdict_on(const PlannedDesign& planned) {
  if (!planned.design.given) return "cannot be evaluated: " + planned.design.mistake;
  const Case& c = *planned.design.given;
  const BowFeasibility f = check_feasibility(c);
  if (f.feasible) return "";
  const std::string nearest =
      c.own.given() ? "" : nearest_feasible_words(c.bow, held_displacement(planned.design.document));
  return "infeasible: " + f.reason + (nearest.empty() ? "" : "; " + nearest);
}

// What mending a hull of the user's own took, and what may be wrong with it.
std::string hull_lines(const Case& c) {
  if (!c.own.given()) return "";
  std::string text;
  for (const std::string& words : in_words(c.own.imported->repairs))
    text += "hull: repaired: " + words + "\n";
  for (const std::string& words : c.own.imported->repairs.warnings) text += "hull: warning: " + words + "\n";
  return text;
}

// Which part of the variables' box is feasible, and bounds that are.
std::string box_lines(const FeasibleBox& box) {
  if (box.tried == 0) return "";
  std::string text = "feasible: " + std::to_string(box.feasible) + " of " + std::to_string(box.tried) +
                     " points of the whole box\n";
  if (!box.held.empty() && box.feasible > 0)
    text += "  there " + box.held + ", which keeps the displacement, is " + brief(box.held_lower) + " to " +
            brief(box.held_upper) + "\n";
  if (box.feasible == box.tried) return text;
  if (box.variables.empty()) return text + "  no smaller box was found that is feasible as a whole\n";
  text += "  all of " + std::to_string(box.tried_inside) + " points tried are feasible within\n";
  for (const Variable& v : box.variables)
    text += "  " + v.pointer + ": " + brief(v.lower) + " to " + brief(v.upper) + "\n";
  return text;
}

int infeasible(const StudyPlan& plan) {
  return static_cast<int>(
      std::count_if(plan.designs.begin(), plan.designs.end(), [](const PlannedDesign& planned) {
        return planned.design.given && !check_feasibility(*planned.design.given).feasible;
      }));
}

std::string design_lines(const StudyPlan& plan) {
  const int no = infeasible(plan);
  const std::string all = std::to_string(plan.designs.size());
  std::string text = "designs: " + all + "\n";
  if (no > 0) text += "  " + std::to_string(no) + " of " + all + " infeasible\n";
  for (std::size_t k = 0; k < plan.designs.size() && k < most_listed; ++k) {
    const PlannedDesign& planned = plan.designs[k];
    text += "  " + std::to_string(k + 1) + "  " + planned.design.name;
    for (const auto& [pointer, value] : planned.design.parameters)
      text += "  " + pointer + " " + brief(value);
    const std::string verdict = verdict_on(planned);
    text += (verdict.empty() ? "" : "  (" + verdict + ")") + "\n";
  }
  if (plan.designs.size() > most_listed)
    text += "  ... and " + std::to_string(plan.designs.size() - most_listed) + " more\n";
  for (const std::string& note : plan.notes) text += "  note: " + note + "\n";
  return text;
}

std::string operation_line(const Case& c) {
  return "operation: " + brief(c.V / metres_per_second_per_knot) + " kn in " + brief(c.ice.h) +
         " m of ice, advance " + brief(c.advance) + " m, metrics from " + brief(c.steady_from) +
         " m on (full scale; simulated at 1:" + brief(c.lambda) + ")\n";
}

// Rows are computed in blocks: what the last block lacks of them is paid for, and a window is made to fill
// it.
std::string block_line(const Scenario& s, const RunSize& size, double lambda) {
  const double dx = s.numerics.dx;
  const auto asked = static_cast<int>(std::lround(s.sheet.length / dx));
  const int filled = (size.nx + block - 1) / block * block;
  const auto metres = [&](int particles) { return decimals(particles * dx * lambda, 2) + " m"; };
  if (asked != size.nx) {
    return "  the window is " + metres(size.nx) + " long, not " + metres(asked) + ": it moves by blocks of " +
           std::to_string(block) + " particles\n";
  }
  if (filled == size.nx) return "";
  return "  along the course the last block of " + std::to_string(block) + " particles has " +
         std::to_string(block - (filled - size.nx)) + " of them: a sheet of " + metres(filled) +
         " takes as long, one of " + metres(filled - block) + " less\n";
}

// The size of one run, of the file's own design; a bow that cannot be made, or a run that cannot, is said in
// words.
std::string size_line(const Case& c) {
  const Hull hull = make_hull(c);
  if (hull.status != HullStatus::ok) return "the file's own design has no hull: " + hull.reason + "\n";
  const Scenario scenario = simulated_scenario(Communicator::serial(), c);
  const RunSize size = run_size(scaled(hull.mesh, 1.0 / c.lambda), scenario);
  const double particles = 1.0 * size.nx * size.ny * size.nz;
  return "one run: " + std::to_string(size.nx) + " x " + std::to_string(size.ny) + " x " +
         std::to_string(size.nz) + " = " + decimals(particles, 0) + " particles" +
         (scenario.sheet.half_model ? " (port half), " : ", ") + std::to_string(size.steps) + " steps of " +
         brief(size.dt) + " s (stability limit " + brief(size.dt_limit) + " s)\n" +
         block_line(scenario, size, c.lambda);
}

// Of the points that the study would try within its ranges, or of points all over them.
bool nothing_is_feasible(const StudySpec& spec, const StudyPlan& plan, const FeasibleBox& box) {
  if (spec.method.type == MethodType::optimise) return box.tried > 0 && box.feasible == 0;
  std::vector<Evaluation> expected;
  for (const PlannedDesign& planned : plan.designs) {
    const bool no = planned.design.given && !check_feasibility(*planned.design.given).feasible;
    Evaluation e;
    e.parameters = planned.design.parameters;
    e.status = no ? EvaluationStatus::infeasible : EvaluationStatus::running;
    expected.push_back(e);
  }
  return nothing_feasible(spec, expected);
}

std::string decide_lines(const StudySpec& spec) {
  if (!spec.decide.given) return "";
  std::string text = "then a race: voyages are sailed on until the design that leads is at most " +
                     brief(100.0 * spec.decide.best_within) +
                     " % above the lowest mean load, at a confidence of " +
                     brief(100.0 * spec.decide.confidence) + " %";
  if (spec.decide.budget_core_hours > 0.0)
    text += ", or until " + brief(spec.decide.budget_core_hours) + " core hours are spent";
  return text + "\n";
}

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

// What the study takes, by a measurement of some seconds.
std::string cost_lines(const StudySpec& spec, const StudyPlan& plan) {
  constexpr double seconds = 5.0;
  const StudyCost cost = study_cost(spec, plan, seconds);
  if (!cost.unknown.empty()) return "cost: not known: " + cost.unknown + "\n";
  std::string text = "cost, at most, by what this machine took for the file's own design:\n";
  text += cost_words("designs", cost.designs, cost.design, spec.execution);
  if (cost.confirmations > 0)
    text += cost_words("simulations", cost.confirmations, cost.confirmation, spec.execution);
  const double checkpoint = std::max(cost.design.checkpoint, cost.confirmation.checkpoint);
  if (checkpoint > 0.0)
    text += "  and " + bytes(checkpoint) + " for the checkpoint of each that is under way\n";
  if (spec.decide.given) text += "  each leg of the race comes on top\n";
  if (cost.programs) text += "  programs of your own were not started: their time is not in it\n";
  return text;
}

}  // namespace

int run_check(const Communicator&, const Arguments& arguments) {
  const StudySpec spec = load_study(arguments);
  const StudyPlan plan = plan_study(spec);
  const FeasibleBox box = feasible_box(spec);
  std::string text = spec.file + ": no mistakes\n" + printable(spec.name) + "\n";
  if (!spec.purpose.empty()) text += "purpose: " + printable(spec.purpose) + "\n";
  text += hull_lines(spec.baseline) + design_lines(plan) + method_lines(spec, plan) + box_lines(box) +
          operation_line(spec.baseline);
  for (const CaseScenario& scenario : spec.baseline.scenarios)
    text += "scenario " + printable(scenario.name) + ", weight " + brief(scenario.weight) + ": " +
            operation_line(*scenario.given);
  text += std::string("evaluators:") + (spec.use_lindqvist ? " lindqvist" : "") +
          (spec.use_cycle ? " cycle" : "") + (spec.use_peridynamics ? " peridynamics" : "");
  for (const ProgramEvaluator& program : spec.programs) text += " " + program.name + " (a program)";
  text += "\n";
  if (spec.confirm.given())
    text += "then the best " + std::to_string(spec.confirm.best) + " and " +
            std::to_string(spec.confirm.spread) + " of the others by peridynamics\n";
  text += decide_lines(spec);
  const bool simulates = spec.use_peridynamics || spec.confirm.given();
  if (simulates && spec.baseline.scenarios.empty()) text += size_line(spec.baseline);
  for (const CaseScenario& scenario : spec.baseline.scenarios)
    if (simulates) text += "scenario " + printable(scenario.name) + ": " + size_line(*scenario.given);
  if (arguments.has("--cost")) text += cost_lines(spec, plan);
  std::cout << text;
  if (!nothing_is_feasible(spec, plan, box)) return exit_code::ok;
  std::cerr << spec.file << ": nothing is feasible: the study would rank no design of its method\n";
  return exit_code::nothing_feasible;
}

}  // namespace icebow
