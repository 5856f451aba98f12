#include "study/evaluate/evaluation.h"

#include <array>
#include <cmath>
#include <limits>

#include "base/errors.h"

namespace icebow {
namespace {

constexpr std::array<EvaluationStatus, 5> statuses = {EvaluationStatus::ok, EvaluationStatus::infeasible,
                                                      EvaluationStatus::failed, EvaluationStatus::running,
                                                      EvaluationStatus::damaged};

Json number_json(double value) {
  return std::isfinite(value) ? Json(value) : Json(nullptr);
}

double number_from(const Json& json) {
  return json.is_number() ? json.get<double>() : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace

const char* to_string(EvaluationStatus status) {
  switch (status) {
    case EvaluationStatus::ok:
      return "ok";
    case EvaluationStatus::infeasible:
      return "infeasible";
    case EvaluationStatus::failed:
      return "failed";
    case EvaluationStatus::running:
      return "running";
    case EvaluationStatus::damaged:
      return "damaged";
  }
  return "failed";
}

EvaluationStatus status_from_string(const std::string& text) {
  for (const EvaluationStatus status : statuses) {
    if (text == to_string(status)) return status;
  }
  throw RuntimeError("unknown status of an evaluation: \"" + text + "\"");
}

Json parameters_json(const std::map<std::string, double>& parameters) {
  Json json = Json::object();
  for (const auto& [pointer, value] : parameters) json[pointer] = number_json(value);
  return json;
}

std::map<std::string, double> parameters_from_json(const Json& json) {
  std::map<std::string, double> parameters;
  for (const auto& item : json.items()) parameters[item.key()] = number_from(item.value());
  return parameters;
}

Json to_json(const Design& design) {
  return {{"name", design.name},
          {"parameters", parameters_json(design.parameters)},
          {"document", design.document}};
}

Design design_from_json(const Json& json) {
  return {json.at("name").get<std::string>(), json.at("document"),
          parameters_from_json(json.at("parameters"))};
}

Json to_json(const Evaluation& e) {
  return {{"key", e.key},
          {"name", e.name},
          {"reason", e.reason},
          {"status", to_string(e.status)},
          {"result", e.result},
          {"parameters", parameters_json(e.parameters)},
          {"wall_seconds", number_json(e.wall_seconds)}};
}

Evaluation evaluation_from_json(const Json& json) {
  Evaluation e;
  e.key = json.at("key").get<std::string>();
  e.name = json.at("name").get<std::string>();
  e.status = status_from_string(json.at("status").get<std::string>());
  e.reason = json.at("reason").get<std::string>();
  e.parameters = parameters_from_json(json.at("parameters"));
  e.result = json.at("result");
  e.wall_seconds = number_from(json.at("wall_seconds"));
  return e;
}

std::string json_text(const Json& json, int indent) {
  return json.dump(indent, ' ', false, Json::error_handler_t::replace);
}

}  // namespace icebow
