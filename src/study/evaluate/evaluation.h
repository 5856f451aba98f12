// What became of a design: the rows of the result store.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "base/json.h"
#include "study/evaluate/design.h"

namespace icebow {

enum class EvaluationStatus {
  ok,
  infeasible,
  failed,
  running,
  damaged  // its row of the store is not what was written; never written itself
};

struct Evaluation {
  std::string key;   // hash of everything the result depends on: the same key is never computed twice
  std::string name;  // of the design
  EvaluationStatus status = EvaluationStatus::failed;
  std::string reason;  // infeasible, failed, damaged: in words
  std::map<std::string, double> parameters;
  Json result;  // what `icebow simulate` writes as result.json: see docs/study_file.md, "Results"
  double wall_seconds = 0.0;
};

const char* to_string(EvaluationStatus status);
EvaluationStatus status_from_string(const std::string& text);  // throws RuntimeError for an unknown word

// Between processes and ranks. A number that is not finite travels as null and comes back as NaN.
Json to_json(const Evaluation& evaluation);
Evaluation evaluation_from_json(const Json& json);

// A tree as text that any reader of JSON takes: bytes that are not UTF-8 are replaced instead of thrown at.
std::string json_text(const Json& json, int indent = -1);

}  // namespace icebow
