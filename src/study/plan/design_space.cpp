#include "study/plan/design_space.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <map>

#include "base/errors.h"
#include "base/json_fields.h"
#include "base/sha256.h"
#include "base/text.h"
#include "study/evaluate/evaluation.h"
#include "study/evaluate/evaluation_key.h"
#include "study/plan/confirmation.h"
#include "study/plan/feasible_points.h"
#include "study/plan/model_notes.h"
#include "study/plan/repeats.h"
#include "study/plan/sampling.h"
#include "study/plan/variable_ranges.h"
#include "study/spec/case_hull.h"
#include "study/spec/held_document.h"
#include "study/spec/spec_hold.h"

namespace icebow {
namespace {

// What is swept where designs are confirmed later: everything but the simulation.
void leave_out_simulation(Json& document) {
  Json& list = document.at("evaluators");
  list.erase(std::remove(list.begin(), list.end(), Json("peridynamics")), list.end());
}

// The values that a document gives the variables of the study's method, and the dimension that keeps its
// displacement.
std::map<std::string, double> parameters_of(const StudySpec& spec, const Json& document) {
  std::map<std::string, double> parameters;
  for (const Variable& variable : spec.method.variables) {
    const double value = number_at(document, variable.pointer);
    if (std::isfinite(value)) parameters[variable.pointer] = value;
  }
  const std::string held = held_pointer(document);
  if (!held.empty()) parameters[held] = number_at(document, held);
  return parameters;
}

// A design of a race goes by its first leg.
PlannedDesign with_key(const StudySpec& spec, Design design) {
  if (!design.given) {
    const std::string key = sha256("rejected by the reader\n" + json_text(design.document));
    return {std::move(design), key, ""};
  }
  const std::string one_leg = evaluation_key(*design.given, design.asked);
  if (!design.asked.peridynamics) return {std::move(design), one_leg, ""};
  const std::string sailed_on = sha256("sailed on\n" + one_leg);
  if (!spec.decide.given) return {std::move(design), one_leg, sailed_on};
  const double first_leg = design.given->advance;
  return {sailed_to(std::move(design), first_leg), sailed_on, one_leg};
}

PlannedDesign planned(const StudySpec& spec, const std::string& name, Json document) {
  hold_displacement(document);
  std::map<std::string, double> parameters = parameters_of(spec, document);
  return with_key(spec, read_design(name, std::move(document), std::move(parameters)));
}

PlannedDesign swept(const StudySpec& spec, const std::string& name, Json document) {
  if (spec.confirm.given()) leave_out_simulation(document);
  return planned(spec, name, std::move(document));
}

// The study document without its other designs, of which it may have many.
Json document_of_one(const StudySpec& spec) {
  Json document = Json::object();
  for (const auto& [key, value] : spec.document.items())
    if (key != "designs" && key != "method") document[key] = value;
  return document;
}

std::vector<std::vector<double>> grid(const Method& method) {
  std::vector<std::vector<double>> levels;
  for (const Variable& v : method.variables) {
    levels.push_back(v.values.empty() ? equally_spaced(v.lower, v.upper, v.levels) : v.values);
  }
  return full_factorial(levels);
}

// The values of the baseline, but for one variable.
std::vector<std::vector<double>> one_at_a_time(const StudySpec& spec) {
  const std::vector<double> baseline = start_point(spec);
  std::vector<std::vector<double>> points;
  for (std::size_t i = 0; i < baseline.size(); ++i) {
    const Variable& v = spec.method.variables[i];
    for (const double value : v.values.empty() ? equally_spaced(v.lower, v.upper, v.levels) : v.values) {
      points.push_back(baseline);
      points.back()[i] = value;
    }
  }
  return points;
}

// Each number of samples that it grew from, then all.
std::vector<std::vector<double>> hypercube(int dimension, const Method& method) {
  std::vector<int> numbers = method.extends;
  numbers.push_back(method.samples);
  auto points = latin_hypercube(dimension, numbers.front(), method.seed);
  for (const int samples : numbers) points = augmented_hypercube(std::move(points), samples, method.seed);
  return points;
}

std::vector<std::vector<double>> unit_points(const Method& method) {
  const int dimension = static_cast<int>(method.variables.size());
  switch (method.type) {
    case MethodType::latin_hypercube:
      return hypercube(dimension, method);
    case MethodType::sobol:
      return sequence(Sequence::sobol, dimension, method.samples);
    case MethodType::halton:
      return sequence(Sequence::halton, dimension, method.samples);
    case MethodType::morris:
      return morris(dimension, method.samples, method.seed);
    case MethodType::central_composite:
      return central_composite(dimension);
    case MethodType::box_behnken:
      return box_behnken(dimension);
    default:
      return {};
  }
}

std::vector<std::vector<double>> method_points(const StudySpec& spec, std::vector<std::string>& notes) {
  const Method& method = spec.method;
  if (method.type == MethodType::grid) return grid(method);
  if (method.type == MethodType::table) return method.rows;
  if (method.type == MethodType::one_at_a_time) return one_at_a_time(spec);
  auto points = in_units(unit_points(method), method.variables);
  if (!method.replace_infeasible) return points;
  std::string note;
  replace_infeasible(
      method, points, [&](const std::vector<double>& x) { return is_feasible_point(spec, x); }, note);
  if (!note.empty()) notes.push_back(note);
  return points;
}

class Plan {
 public:
  explicit Plan(const StudySpec& spec) : spec_(spec) {}
  void add(const PlannedDesign& design) {
    for (PlannedDesign& run : runs_of(spec_, design)) add_run(std::move(run));
  }
  StudyPlan plan;

 private:
  void add_run(PlannedDesign p) {
    const auto [first, is_new] = names_.emplace(p.key, p.design.name);
    if (!is_new) {
      if (run_name(p.design.name).number > 1) return;
      plan.notes.push_back(p.design.name + " is the same as " + first->second + ": evaluated once");
      return;
    }
    plan.designs.push_back(std::move(p));
  }

  const StudySpec& spec_;
  std::map<std::string, std::string> names_;  // by key
};

}  // namespace

Design baseline_of(const StudySpec& spec) {
  return {"baseline",
          document_of_one(spec),
          parameters_of(spec, spec.document),
          {spec.use_lindqvist, spec.use_peridynamics, spec.use_cycle, spec.programs,
           evaluators_of(spec.document).hydrostatics},
          spec.baseline,
          ""};
}

StudyPlan plan_study(const StudySpec& spec) {
  Plan plan(spec);
  if (spec.use_peridynamics || spec.confirm.given())
    plan.plan.notes = model_notes(spec.baseline, spec.confirm.given());
  const std::string hold = hold_in_words(spec.document);
  if (!hold.empty()) plan.plan.notes.push_back(hold);
  for (std::string& note : notes_on_ranges(spec)) plan.plan.notes.push_back(std::move(note));
  const Json own = document_of_one(spec);
  if (spec.include_baseline)
    plan.add(spec.confirm.given() ? swept(spec, "baseline", own) : with_key(spec, baseline_of(spec)));
  for (const NamedDesign& named : spec.designs) {
    Json document = own;
    document.merge_patch(named.set);
    plan.add(swept(spec, named.name, std::move(document)));
  }
  int n = 0;
  for (const std::vector<double>& x : method_points(spec, plan.plan.notes)) {
    plan.add(design_at(spec, numbered_name(++n), x));
  }
  if (spec.method.type == MethodType::optimise) {
    const bool starts_at_baseline =
        spec.include_baseline && is_within(spec.method.variables, parameters_of(spec, spec.document));
    plan.plan.proposals = spec.method.max_evaluations - (starts_at_baseline ? 1 : 0);
  }
  return plan.plan;
}

PlannedDesign design_at(const StudySpec& spec, const std::string& name, const std::vector<double>& x) {
  Json document = document_of_one(spec);
  for (std::size_t i = 0; i < x.size(); ++i) {
    const Variable& v = spec.method.variables[i];
    Json& value = document[Json::json_pointer(v.pointer)];
    if (v.words.empty())
      value = rounded(x[i]);
    else
      value = v.words[static_cast<std::size_t>(std::lround(x[i]))];
  }
  return swept(spec, name, std::move(document));
}

bool is_feasible_point(const StudySpec& spec, const std::vector<double>& x) {
  const std::optional<Case> given = design_at(spec, "", x).design.given;
  return given && check_feasibility(*given).feasible;
}

std::vector<PlannedDesign> runs_of(const StudySpec& spec, const PlannedDesign& design) {
  std::vector<PlannedDesign> runs = {design};
  if (!design.design.asked.peridynamics) return runs;  // the others would be the same
  for (int number = 2; number <= spec.repeats; ++number) {
    runs.push_back(planned(spec, repeat_name(design.design.name, number),
                           repeat_document(design.design.document, number)));
  }
  return runs;
}

std::vector<PlannedDesign> confirmations(const StudySpec& spec, const Design& design) {
  Json document = design.document;
  document["evaluators"] = {"cycle", "peridynamics"};  // the cycle over the way that the simulation counts
  return runs_of(spec, planned(spec, confirmation_name(design.name), std::move(document)));
}

void note_choices(const StudySpec& spec, const Design& design, Evaluation& evaluation) {
  for (const Variable& v : spec.method.variables) {
    if (v.words.empty()) continue;
    if (!evaluation.result.is_object()) evaluation.result = Json::object();
    evaluation.result["choices"][v.pointer] = text_at(design.document, v.pointer);
  }
}

std::vector<double> start_point(const StudySpec& spec) {
  std::vector<double> start;
  for (const Variable& variable : spec.method.variables) {
    const auto word =
        std::find(variable.words.begin(), variable.words.end(), text_at(spec.document, variable.pointer));
    if (word != variable.words.end()) {
      start.push_back(static_cast<double>(word - variable.words.begin()));
      continue;
    }
    const double value = number_at(spec.document, variable.pointer);
    start.push_back(std::isfinite(value) ? value : 0.5 * (variable.lower + variable.upper));
  }
  return start;
}

std::string numbered_name(int n) {
  return text("d%03d", n);
}

double rounded(double value) {
  return std::strtod(text("%.10g", value).c_str(), nullptr);
}

}  // namespace icebow
