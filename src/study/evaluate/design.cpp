#include "study/evaluate/design.h"

#include <algorithm>
#include <utility>

#include "base/errors.h"
#include "base/json_fields.h"
#include "study/spec/spec_case.h"

namespace icebow {

Evaluators evaluators_of(const Json& document) {
  if (!document.contains("evaluators")) return {};
  const Json& list = document.at("evaluators");
  const auto has = [&](const char* name) {
    return std::find(list.begin(), list.end(), Json(name)) != list.end();
  };
  return {has("lindqvist"), has("peridynamics"), has("cycle")};
}

Design read_design(const std::string& name, Json document, std::map<std::string, double> parameters) {
  Design design;
  design.name = name;
  design.parameters = std::move(parameters);
  design.asked = evaluators_of(document);
  try {
    design.given = read_case(document, name);
  } catch (const InputError& error) {
    design.mistake = error.what();
  }
  design.document = std::move(document);
  return design;
}

Json parameters_json(const std::map<std::string, double>& parameters) {
  Json json = Json::object();
  for (const auto& [pointer, value] : parameters) json[pointer] = finite_or_null(value);
  return json;
}

std::map<std::string, double> parameters_from_json(const Json& json) {
  std::map<std::string, double> parameters;
  for (const auto& item : json.items()) parameters[item.key()] = number_at(item.value(), "");
  return parameters;
}

Json to_json(const Design& design) {
  return {{"name", design.name},
          {"parameters", parameters_json(design.parameters)},
          {"document", design.document}};
}

Design design_from_json(const Json& json) {
  return read_design(json.at("name").get<std::string>(), json.at("document"),
                     parameters_from_json(json.at("parameters")));
}

}  // namespace icebow
