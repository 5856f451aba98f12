// The part of a study file that names designs and evaluators.
#pragma once

#include <optional>
#include <set>
#include <utility>

#include "study/spec/spec_section.h"
#include "study/spec/study_spec.h"

namespace icebow {

// Each notes its mistakes; what they return is to be used only where they added none.
std::vector<NamedDesign> parse_designs(const Json& document, Mistakes& mistakes);
// Of one entry of "evaluators"; nothing where it is no object.
std::optional<ProgramEvaluator> program_of(const Json& entry);
// Makes the paths of programs and their files absolute, as they are meant: from the study file's directory.
void resolve_program_files(Json& document, const std::string& study_file);
void parse_evaluators(const Json& document, StudySpec& spec, Mistakes& mistakes);

// The mistakes of a study's own case, by which those that a change of it brings are told.
class CaseMistakes {
 public:
  explicit CaseMistakes(const Json& document);
  const Json& document() const { return document_; }  // what a design changes: without designs and method
  Mistakes fresh(const Json& changed) const;          // those of `changed` that the document does not have

 private:
  Json document_;
  std::set<std::pair<std::string, std::string>> known_;  // pointer and message
};

}  // namespace icebow
