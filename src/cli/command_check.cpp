#include <algorithm>
#include <cmath>
#include <iostream>

#include "base/child_process.h"
#include "base/errors.h"
#include "base/json_fields.h"
#include "base/printable.h"
#include "base/units.h"
#include "cli/commands.h"
#include "cli/cost_text.h"
#include "cli/study_choice.h"
#include "cli/text_table.h"
#include "solver/lattice/lattice.h"
#include "solver/run/simulation.h"
#include "study/evaluate/calibration.h"
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
std::string verdict_on(const Design& design) {
  if (!design.given) return "cannot be evaluated: " + design.mistake;
  const Case& c = *design.given;
  const BowFeasibility f = check_feasibility(c);
  if (f.feasible) return "";
  const std::string nearest =
      c.own.given() ? "" : nearest_feasible_words(c.bow, held_displacement(design.document));
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

// "/bow/family flat  /bow/stem_deg 22": a design's place in the study.
std::string place_of(const StudySpec& spec, const Design& design) {
  std::string text;
  for (const Variable& v : spec.method.variables)
    if (!v.words.empty()) text += "  " + v.pointer + " " + text_at(design.document, v.pointer);
  for (const auto& [pointer, value] : design.parameters) text += "  " + pointer + " " + brief(value);
  return text;
}

std::string design_lines(const StudySpec& spec, const StudyPlan& plan) {
  const int no = infeasible(plan);
  const std::string all = std::to_string(plan.designs.size());
  std::string text = "designs: " + all + "\n";
  if (no > 0) text += "  " + std::to_string(no) + " of " + all + " infeasible\n";
  for (std::size_t k = 0; k < plan.designs.size() && k < most_listed; ++k) {
    const PlannedDesign& planned = plan.designs[k];
    text += "  " + std::to_string(k + 1) + "  " + planned.design.name + place_of(spec, planned.design);
    const std::string verdict = verdict_on(planned.design);
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

// The size of one run; a bow that cannot be made, or a run that cannot, is said in
// words.
std::string size_line(const Case& c) {
  const Hull hull = make_hull(c);
  if (hull.status != HullStatus::ok) return "there is no hull, and no run: " + hull.reason + "\n";
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

std::string head(const StudySpec& spec) {
  return spec.file + ": no mistakes\n" + printable(spec.name) + "\n" +
         (spec.purpose.empty() ? "" : "purpose: " + printable(spec.purpose) + "\n");
}

// A program that is not here may be where the study runs.
std::string found_here(const std::string& program) {
  return can_be_started(program) ? "" : ", " + printable(program) + ", which is not found on this machine";
}

std::string evaluator_lines(const StudySpec& spec) {
  std::string text = std::string("evaluators:") + (spec.use_lindqvist ? " lindqvist" : "") +
                     (spec.use_cycle ? " cycle" : "") + (spec.use_peridynamics ? " peridynamics" : "");
  for (const ProgramEvaluator& program : spec.programs)
    text += " " + program.name + " (a program" + found_here(program.command.at(0)) + ")";
  text += "\n";
  const std::vector<std::string>& launcher = spec.execution.launcher;
  if (!launcher.empty() && !can_be_started(launcher.front()))
    text += "launcher: " + found_here(launcher.front()).substr(2) + "\n";
  return text;
}

// The conditions of each scenario, and the size of its run.
std::string condition_lines(const Case& c) {
  std::string text = operation_line(c);
  for (const CaseScenario& scenario : c.scenarios)
    text += "scenario " + printable(scenario.name) + ", weight " + brief(scenario.weight) + ": " +
            operation_line(*scenario.given);
  return text;
}

std::string size_lines(const StudySpec& spec, const Case& c) {
  if (!spec.use_peridynamics && !spec.confirm.given()) return "";
  if (c.scenarios.empty()) return size_line(c);
  std::string text;
  for (const CaseScenario& scenario : c.scenarios)
    text += "scenario " + printable(scenario.name) + ": " + size_line(*scenario.given);
  return text;
}

int check_study(const StudySpec& spec, bool cost) {
  const StudyPlan plan = plan_study(spec);
  const FeasibleBox box = feasible_box(spec);
  std::string text = head(spec) + hull_lines(spec.baseline) + design_lines(spec, plan) +
                     method_lines(spec, plan) + box_lines(box) + condition_lines(spec.baseline) +
                     evaluator_lines(spec);
  if (spec.confirm.given())
    text += "then the best " + std::to_string(spec.confirm.best) + " and " +
            std::to_string(spec.confirm.spread) + " of the others by peridynamics\n";
  text += decide_lines(spec) + size_lines(spec, spec.baseline);
  if (cost) text += cost_text(spec, plan);
  std::cout << text;
  if (!nothing_is_feasible(spec, plan, box)) return exit_code::ok;
  std::cerr << spec.file << ": nothing is feasible: the study would rank no design of its method\n";
  return exit_code::nothing_feasible;
}

int check_design(const StudySpec& spec, const ChosenDesign& chosen, bool cost) {
  const Design& design = chosen.design;
  const std::string verdict = verdict_on(design);
  std::string text = head(spec) + hull_lines(chosen.description) + "design: " + design.name +
                     place_of(spec, design) + "\n  " + (verdict.empty() ? "feasible" : verdict) + "\n" +
                     condition_lines(chosen.description) + evaluator_lines(spec);
  if (verdict.empty()) text += size_lines(spec, chosen.description);
  if (verdict.empty() && cost) text += cost_text(spec, design);
  std::cout << text;
  if (verdict.empty()) return exit_code::ok;
  std::cerr << spec.file << ": the design " << design.name << " is " << verdict << "\n";
  return exit_code::nothing_feasible;
}

}  // namespace

int run_check(const Communicator&, const Arguments& arguments) {
  const StudySpec spec = load_study(arguments);
  const bool cost = arguments.has("--cost");
  return arguments.has("--design") ? check_design(spec, choose_design(spec, arguments), cost)
                                   : check_study(spec, cost);
}

}  // namespace icebow
