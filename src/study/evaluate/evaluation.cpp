#include "study/evaluate/evaluation.h"

#include <array>

#include "base/errors.h"
#include "base/json_fields.h"
#include "base/printable.h"

namespace icebow {
namespace {

constexpr std::array<EvaluationStatus, 5> statuses = {EvaluationStatus::ok, EvaluationStatus::infeasible,
                                                      EvaluationStatus::failed, EvaluationStatus::running,
                                                      EvaluationStatus::damaged};

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

Json to_json(const Evaluation& e) {
  return {{"key", e.key},
          {"name", e.name},
          {"reason", e.reason},
          {"status", to_string(e.status)},
          {"result", e.result},
          {"parameters", parameters_json(e.parameters)},
          {"wall_seconds", finite_or_null(e.wall_seconds)}};
}

Evaluation evaluation_from_json(const Json& json) {
  Evaluation e;
  e.key = json.at("key").get<std::string>();
  e.name = json.at("name").get<std::string>();
  e.status = status_from_string(json.at("status").get<std::string>());
  e.reason = printable(json.at("reason").get<std::string>());  // of a store from anywhere
  e.parameters = parameters_from_json(json.at("parameters"));
  e.result = json.at("result");
  e.wall_seconds = number_at(json, "/wall_seconds");
  return e;
}

std::string json_text(const Json& json, int indent) {
  return json.dump(indent, ' ', false, Json::error_handler_t::replace);
}

}  // namespace icebow
