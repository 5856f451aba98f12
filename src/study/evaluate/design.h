// A design: a point of the study, read once and passed on as what it means.
#pragma once

#include <map>
#include <optional>
#include <string>

#include "base/json.h"
#include "study/spec/study_spec.h"

namespace icebow {

struct Design {
  std::string name;  // "baseline", "Thyssen-Waas", "d007"
  Json document;     // the whole study document after its overrides
  std::map<std::string, double>
      parameters;             // values of the study's variables, by JSON pointer, in the file's units
  Evaluators asked;           // by the document
  std::optional<Case> given;  // what the document describes; nothing where it describes no ship
  std::string mistake;        // then: why
  // Of a voyage that may be sailed on, how far it goes now, full scale [m]: `given` has it as its advance.
  // 0 = a voyage as the document has it.
  double sail_to = 0.0;
};

// The same voyage, so far.
Design sailed_to(Design design, double advance);

// The one place where a design's document is read. Never throws for what the document can do wrong: that is
// the design's mistake.
Design read_design(const std::string& name, Json document, std::map<std::string, double> parameters = {});

// Which evaluators a study document asks for: those of a plain Evaluators where it does not say.
Evaluators evaluators_of(const Json& document);

// Between processes and ranks: name, parameters and document travel, and the other side reads the document.
Json to_json(const Design& design);
Design design_from_json(const Json& json);

// A number that is not finite travels as null and comes back as NaN.
Json parameters_json(const std::map<std::string, double>& parameters);
std::map<std::string, double> parameters_from_json(const Json& json);

}  // namespace icebow
