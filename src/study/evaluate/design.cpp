#include "study/evaluate/design.h"

#include <algorithm>
#include <utility>

#include "base/errors.h"
#include "base/json_fields.h"
#include "study/evaluate/result_keys.h"
#include "study/spec/document_keys.h"
#include "study/spec/spec_case.h"
#include "study/spec/spec_designs.h"

namespace icebow {

bool asks_for_hydrostatics(const Json& document) {
  const Json& list = part_at(document, document_key::constraints);
  for (const char* objective : {document_key::second_objective, document_key::second_objective_by})
    if (result_key::is_hydrostatic(text_at(document, objective))) return true;
  return list.is_array() && std::any_of(list.begin(), list.end(), [](const Json& entry) {
           return result_key::is_hydrostatic(text_at(entry, document_key::constraint_at));
         });
}

Evaluators evaluators_of(const Json& document) {
  Evaluators usual;
  usual.hydrostatics = asks_for_hydrostatics(document);
  if (!document.contains("evaluators")) return usual;
  const Json& list = document.at("evaluators");
  const auto has = [&](const char* name) {
    return std::find(list.begin(), list.end(), Json(name)) != list.end();
  };
  Evaluators asked{has("lindqvist"), has("peridynamics"), has("cycle"), {}, usual.hydrostatics};
  for (const Json& entry : list)
    if (const auto program = program_of(entry)) asked.programs.push_back(*program);
  return asked;
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

Design sailed_to(Design design, double advance) {
  design.sail_to = advance;
  if (design.given) design.given->advance = advance;
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
  Json json = {{"name", design.name},
               {"parameters", parameters_json(design.parameters)},
               {"document", design.document}};
  if (design.sail_to > 0.0) json["sail_to_m"] = design.sail_to;
  return json;
}

Design design_from_json(const Json& json) {
  Design design = read_design(json.at("name").get<std::string>(), json.at("document"),
                              parameters_from_json(json.at("parameters")));
  return json.contains("sail_to_m") ? sailed_to(std::move(design), json.at("sail_to_m")) : design;
}

}  // namespace icebow
