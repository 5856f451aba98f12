#include "study/spec/spec_method.h"

#include <algorithm>
#include <cmath>

#include "study/spec/spec_hints.h"
#include "study/spec/spec_variables.h"

namespace icebow {
namespace {

constexpr double most_designs = 100000;

const std::vector<MethodInfo>& types() {
  static const std::vector<MethodInfo> all = {
      {"list", MethodType::list, {}, {}},
      {"grid", MethodType::grid, {"variables"}, {"min", "max", "levels", "values"}},
      {"latin_hypercube", MethodType::latin_hypercube, {"variables", "samples", "seed"}, {"min", "max"}},
      {"optimise",
       MethodType::optimise,
       {"variables", "algorithm", "max_evaluations", "tolerance", "seed"},
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

void parse_variables(const Json& document, const MethodInfo& type, Method& method, Mistakes& mistakes) {
  const Json& m = document.at("method");
  if (!m.contains("variables") || m.at("variables") == Json::object()) {
    mistakes.push_back({"/method/variables",
                        std::string("is ") + (m.contains("variables") ? "empty" : "missing") +
                            "; the method \"" + type.name +
                            "\" needs at least one, like {\"/bow/stem_deg\": {\"min\": 18, \"max\": 30" +
                            (type.type == MethodType::grid ? ", \"levels\": 3" : "") + "}}"});
    return;
  }
  const Json& variables = m.at("variables");
  if (!variables.is_object()) {
    mistakes.push_back({"/method/variables",
                        "is " + type_name(variables) + ", must be an object from JSON pointer to range"});
    return;
  }
  double designs = 1.0;
  for (const auto& [pointer, range] : variables.items()) {
    method.variables.push_back(parse_variable(document, type, pointer, range, mistakes));
    const Variable& v = method.variables.back();
    if (type.type == MethodType::grid)
      designs *= v.values.empty() ? std::max(1, v.levels) : static_cast<double>(v.values.size());
  }
  if (designs > most_designs) {
    mistakes.push_back({"/method/variables", "makes " + brief(designs) + " designs, at most " +
                                                 brief(most_designs) +
                                                 "; fewer levels, or a latin_hypercube"});
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
                            std::to_string(algorithm->least_variables) + " variables; take sbplx for one"});
  }
}

void check_used(const Json& method, const MethodInfo& type, Mistakes& mistakes) {
  for (const auto& item : method.items()) {
    if (item.key() == "type" || is_one_of(type.keys, item.key())) continue;
    const bool known = item.key() == "variables" || find_spelling("method", item.key()).key;
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
  };
  return all;
}

const Algorithm* find_algorithm(const std::string& name) {
  for (const Algorithm& a : algorithms()) {
    if (a.name == name) return &a;
  }
  return nullptr;
}

Method parse_method(const Json& document, Mistakes& mistakes) {
  Method method;
  const Section section(document, "method", 1.0, mistakes, {"variables"});
  if (!document.contains("method") || !document.at("method").is_object()) return method;
  const std::string name = section.text("type", "list");
  const MethodInfo& type = type_named(name);
  if (type.name != name) return method;  // a wrong type: nothing sensible can be said of the rest
  method.type = type.type;
  check_used(document.at("method"), type, mistakes);
  if (is_one_of(type.keys, "variables")) parse_variables(document, type, method, mistakes);
  if (method.type == MethodType::latin_hypercube) method.samples = section.integer("samples");
  method.seed = std::isnan(section.number("seed")) ? 1 : static_cast<std::uint64_t>(section.number("seed"));
  if (method.type == MethodType::optimise) {
    method.algorithm = section.text("algorithm", "sbplx");
    method.max_evaluations = section.integer("max_evaluations");
    method.tolerance = section.number("tolerance");
    check_algorithm(section, method, mistakes);
  }
  return method;
}

}  // namespace icebow
