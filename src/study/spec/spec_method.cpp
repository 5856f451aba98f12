#include "study/spec/spec_method.h"

#include <algorithm>
#include <cmath>

#include "base/json_fields.h"
#include "study/spec/spec_hints.h"
#include "study/spec/spec_table.h"
#include "study/spec/spec_variables.h"

namespace icebow {
namespace {

constexpr double most_designs = 100000;
constexpr int most_learnt = 1000;

// Keys of "method" that are no single values.
const std::vector<std::string> lists = {"variables", "extends", "columns", "rows"};

const std::vector<MethodInfo>& types() {
  static const std::vector<MethodInfo> all = {
      {"list", MethodType::list, {}, {}},
      {"grid", MethodType::grid, {"variables"}, {"min", "max", "levels", "values"}},
      {"one_at_a_time", MethodType::one_at_a_time, {"variables"}, {"min", "max", "levels", "values"}},
      {"latin_hypercube",
       MethodType::latin_hypercube,
       {"variables", "samples", "seed", "extends", "replace_infeasible"},
       {"min", "max", "values"}},
      {"sobol", MethodType::sobol, {"variables", "samples", "replace_infeasible"}, {"min", "max", "values"}},
      {"halton",
       MethodType::halton,
       {"variables", "samples", "replace_infeasible"},
       {"min", "max", "values"}},
      {"morris", MethodType::morris, {"variables", "samples", "seed"}, {"min", "max"}},
      {"central_composite", MethodType::central_composite, {"variables"}, {"min", "max"}},
      {"box_behnken", MethodType::box_behnken, {"variables"}, {"min", "max"}},
      {"table", MethodType::table, {"file", "columns", "rows"}, {}},
      {"optimise",
       MethodType::optimise,
       {"variables", "algorithm", "max_evaluations", "tolerance", "seed", "initial", "batch", "least_gain",
        "prior"},
       {"min", "max"}},
  };
  return all;
}

const MethodInfo& type_named(const std::string& name) {
  for (const MethodInfo& info : types()) {
    if (info.name == name) return info;
  }
  return types().front();
}

bool takes_levels(const MethodInfo& type) {
  return is_one_of(type.variable_keys, "levels");
}

double designs_of(const MethodInfo& type, const Method& method) {
  const double d = static_cast<double>(method.variables.size());
  double product = 1.0, sum = 0.0;
  for (const Variable& v : method.variables) {
    const double levels = v.values.empty() ? std::max(1, v.levels) : static_cast<double>(v.values.size());
    product *= levels, sum += levels;
  }
  if (type.type == MethodType::morris) return method.samples * (d + 1.0);
  if (type.type == MethodType::central_composite) return 1.0 + 2.0 * d + std::exp2(d);
  return type.type == MethodType::grid ? product : type.type == MethodType::one_at_a_time ? sum : 1.0;
}

void check_number_of_variables(const MethodInfo& type, const Method& method, Mistakes& mistakes) {
  const std::size_t n = method.variables.size();
  if (type.type == MethodType::box_behnken && (n < 3 || n > 5))
    mistakes.push_back({"/method/variables", "has " + std::to_string(n) +
                                                 "; the method \"box_behnken\" takes 3 to 5: take "
                                                 "central_composite or latin_hypercube"});
  if (type.type == MethodType::halton && n > 16)
    mistakes.push_back(
        {"/method/variables",
         "has " + std::to_string(n) + "; the points of \"halton\" lie on lines in more than 16: take sobol"});
}

void parse_variables(const Json& document, const MethodInfo& type, Method& method, Mistakes& mistakes) {
  const Json& m = document.at("method");
  if (!m.contains("variables") || m.at("variables") == Json::object()) {
    mistakes.push_back({"/method/variables",
                        std::string("is ") + (m.contains("variables") ? "empty" : "missing") +
                            "; the method \"" + type.name +
                            "\" needs at least one, like {\"/bow/stem_deg\": {\"min\": 18, \"max\": 30" +
                            (takes_levels(type) ? ", \"levels\": 3" : "") + "}}"});
    return;
  }
  const Json& variables = m.at("variables");
  if (!variables.is_object()) {
    mistakes.push_back({"/method/variables",
                        "is " + type_name(variables) + ", must be an object from JSON pointer to range"});
    return;
  }
  for (const auto& [pointer, range] : variables.items())
    method.variables.push_back(parse_variable(document, type, pointer, range, mistakes));
  check_number_of_variables(type, method, mistakes);
  const double designs = designs_of(type, method);
  if (designs > most_designs) {
    mistakes.push_back({"/method/variables", "makes " + brief(designs) + " designs, at most " +
                                                 brief(most_designs) +
                                                 "; fewer levels or samples, or a latin_hypercube"});
  }
}

void check_algorithm(const Section& section, const Method& method, Mistakes& mistakes) {
  std::vector<std::string> names;
  for (const Algorithm& a : algorithms()) names.push_back(a.name);
  const Algorithm* algorithm = find_algorithm(method.algorithm);
  if (!algorithm) {
    if (!method.algorithm.empty()) {
      mistakes.push_back({section.pointer("algorithm"), "is \"" + method.algorithm + "\", must be one of " +
                                                            listed(names) +
                                                            did_you_mean(method.algorithm, names)});
    }
    return;
  }
  const int n = static_cast<int>(method.variables.size());
  if (n > 0 && n < algorithm->least_variables) {
    mistakes.push_back({section.pointer("algorithm"),
                        "is \"" + method.algorithm + "\", which needs at least " +
                            std::to_string(algorithm->least_variables) + " variables; take cobyla for one"});
  }
}

// An optimiser would make the ice thin rather than the bow good.
void check_of_the_ship(const Method& method, Mistakes& mistakes) {
  for (const Variable& v : method.variables) {
    if (v.pointer.rfind("/bow/", 0) == 0 || v.pointer.rfind("/hull/", 0) == 0) continue;
    mistakes.push_back(
        {"/method/variables",
         "has " + v.pointer +
             ", but an optimiser varies the ship alone, numbers of bow or hull: "
             "take grid or another sample for what it does, or /scenarios for several conditions"});
  }
}

// Some keys are those of expected_improvement alone, and one is not.
void check_learning(const Json& method, const Method& parsed, Mistakes& mistakes) {
  const bool learns = parsed.algorithm == learning_algorithm;
  const std::vector<std::string> others = {"tolerance"}, own = {"initial", "batch", "least_gain", "prior"};
  for (const std::string& key : learns ? others : own) {
    if (!method.contains(key)) continue;
    mistakes.push_back({"/method/" + key, learns
                                              ? "is not used by expected_improvement; least_gain ends it"
                                              : "is used by \"algorithm\": \"expected_improvement\" alone"});
  }
  if (learns && parsed.max_evaluations > most_learnt)
    mistakes.push_back({"/method/max_evaluations", "is " + std::to_string(parsed.max_evaluations) +
                                                       "; expected_improvement takes 1 to " +
                                                       std::to_string(most_learnt) +
                                                       ": its model grows with the cube of the points"});
}

// What is cheap beside the load that is ranked.
Prior usual_prior(const Json& document) {
  const Json evaluators = document.value("evaluators", Json::array({"lindqvist", "peridynamics"}));
  const auto asks = [&](const char* name) {
    return evaluators.is_array() && std::find(evaluators.begin(), evaluators.end(), name) != evaluators.end();
  };
  const Json ranking = document.value("ranking", Json::object());
  const bool by_load = !ranking.is_object() || !ranking.contains("by") || ranking.at("by") == "mean_load" ||
                       ranking.at("by") == "mean_load_per_beam";
  if (by_load && asks("peridynamics") && !document.contains("confirm")) return Prior::cycle;
  const bool by_cycle = ranking.is_object() && ranking.value("by", Json("")) == "cycle_load";
  return (by_load || by_cycle) && asks("cycle") ? Prior::lindqvist : Prior::none;
}

Learning parse_learning(const Json& document, const Section& section) {
  Learning learning;
  learning.initial = section.integer("initial");
  learning.least_gain = section.number("least_gain");
  const Json execution = document.value("execution", Json::object());
  const double at_once = execution.is_object() ? number_at(execution, "/designs_at_once") : 0.0;
  const bool given = document.at("method").contains("batch");
  learning.batch = given            ? section.integer("batch")
                   : at_once >= 1.0 ? static_cast<int>(std::min(at_once, 256.0))
                                    : 1;
  const std::string prior = section.text("prior", "");
  learning.prior = prior == "cycle"       ? Prior::cycle
                   : prior == "lindqvist" ? Prior::lindqvist
                   : prior == "none"      ? Prior::none
                                          : usual_prior(document);
  return learning;
}

// Numbers of samples that a Latin hypercube grew from.
std::vector<int> parse_extends(const Json& method, int samples, Mistakes& mistakes) {
  std::vector<int> numbers;
  if (!method.contains("extends")) return numbers;
  const Json& list = method.at("extends");
  bool good = list.is_array() && !list.empty();
  for (const Json& entry : good ? list : Json::array()) {
    good = good && entry.is_number_integer() &&
           entry.get<double>() >= (numbers.empty() ? 1 : numbers.back() + 1) && entry.get<double>() < samples;
    if (good) numbers.push_back(entry.get<int>());
  }
  if (!good)
    mistakes.push_back(
        {"/method/extends",
         "is " + shown(list) + ", must be a list of whole numbers that grow, each less than the " +
             std::to_string(samples) + " of samples, like [10, 20]: the samples are added to those"});
  return good ? numbers : std::vector<int>();
}

void check_used(const Json& method, const MethodInfo& type, Mistakes& mistakes) {
  for (const auto& item : method.items()) {
    if (item.key() == "type" || is_one_of(type.keys, item.key())) continue;
    const bool known = is_one_of(lists, item.key()) || find_spelling("method", item.key()).key;
    if (!known) continue;  // the section has said so
    const std::string takes = type.keys.empty() ? "it takes nothing else" : "it takes " + listed(type.keys);
    mistakes.push_back(
        {"/method/" + item.key(), std::string("is not used by the method \"") + type.name + "\"; " + takes});
  }
}

}  // namespace

const std::vector<Algorithm>& algorithms() {
  static const std::vector<Algorithm> all = {
      {"sbplx", false, false, 1, "local, simplex on subspaces; robust against noise"},
      {"cobyla", true, false, 1, "local, linear models; keeps to constraints"},
      {"neldermead", false, false, 1, "local, simplex"},
      {"bobyqa", false, false, 2, "local, quadratic models; smooth responses"},
      {"crs2_lm", false, true, 1, "global, controlled random search"},
      {"isres", true, true, 1, "global, evolution strategy; keeps to constraints"},
      {"esch", false, true, 1, "global, evolutionary"},
      {"direct_l", false, false, 1, "global, dividing rectangles"},
      {learning_algorithm, true, true, 1, "global, learns from noisy loads; keeps to constraints"},
  };
  return all;
}

std::string method_name(MethodType type) {
  for (const MethodInfo& info : types())
    if (info.type == type) return info.name;
  return "";
}

const Algorithm* find_algorithm(const std::string& name) {
  for (const Algorithm& a : algorithms()) {
    if (a.name == name) return &a;
  }
  return nullptr;
}

Method parse_method(const Json& document, Mistakes& mistakes) {
  Method method;
  const Section section(document, "method", 1.0, mistakes, lists);
  if (!document.contains("method") || !document.at("method").is_object()) return method;
  const std::string name = section.text("type", "list");
  const MethodInfo& type = type_named(name);
  if (type.name != name) return method;  // a wrong type: nothing sensible can be said of the rest
  method.type = type.type;
  const std::size_t before = mistakes.size();
  if (is_one_of(type.keys, "samples")) method.samples = section.integer("samples");
  if (is_one_of(type.keys, "replace_infeasible"))
    method.replace_infeasible = section.boolean("replace_infeasible");
  check_used(document.at("method"), type, mistakes);
  if (is_one_of(type.keys, "variables")) parse_variables(document, type, method, mistakes);
  if (method.type == MethodType::table) parse_table(document, method, mistakes);
  if (method.type == MethodType::latin_hypercube)
    method.extends = parse_extends(document.at("method"), method.samples, mistakes);
  method.seed = std::isnan(section.number("seed")) ? 1 : static_cast<std::uint64_t>(section.number("seed"));
  if (method.type == MethodType::optimise) {
    method.algorithm = section.text("algorithm", "cobyla");
    method.max_evaluations = section.integer("max_evaluations");
    method.tolerance = section.number("tolerance");
    check_algorithm(section, method, mistakes);
    if (mistakes.size() == before && !document.contains("scenarios")) check_of_the_ship(method, mistakes);
    check_learning(document.at("method"), method, mistakes);
    method.learning = parse_learning(document, section);
  }
  return method;
}

}  // namespace icebow
