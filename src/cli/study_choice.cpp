#include "cli/study_choice.h"

#include <filesystem>
#include <utility>

#include "base/errors.h"
#include "base/json_fields.h"
#include "study/look/stored_design.h"
#include "study/spec/document_keys.h"
#include "study/spec/held_document.h"
#include "study/spec/read_study.h"
#include "study/spec/spec_hints.h"
#include "study/spec/spec_hull.h"

namespace icebow {
namespace {

Json load_document(const Arguments& arguments) {
  const std::string& path = arguments.positional;
  Json document =
      std::filesystem::is_directory(path) ? document_of(open_store_of(path)) : read_json_file(path);
  for (const std::string& assignment : arguments.values("--set")) apply_set(document, assignment);
  return document;
}

// The n-th of the plan (from 1) where the text is a number, -1 where it is none.
int number_in_plan(const std::string& text) {
  if (text.empty() || text.size() > 6 || text.find_first_not_of("0123456789") != std::string::npos) return -1;
  return std::stoi(text);
}

const PlannedDesign& find_planned(const StudyPlan& plan, const std::string& wanted) {
  std::vector<std::string> names;
  for (const PlannedDesign& planned : plan.designs) {
    if (planned.design.name == wanted) return planned;
    names.push_back(planned.design.name);
  }
  const int k = number_in_plan(wanted), n = static_cast<int>(plan.designs.size());
  if (k >= 1 && k <= n) return plan.designs[static_cast<std::size_t>(k - 1)];
  throw InputError("--design " + wanted + ": no such design" + did_you_mean(wanted, names) +
                   "; the study has " +
                   (n <= 12 ? listed(names) : std::to_string(n) + " designs, see `icebow check`"));
}

}  // namespace

StudySpec load_study(const Arguments& arguments) {
  return read_study(load_document(arguments), arguments.positional);
}

StudySpec load_study(const Communicator& comm, const Arguments& arguments) {
  std::string text, mistake;
  if (comm.is_root()) {
    try {
      text = json_text(load_study(arguments).document);
    } catch (const InputError& error) {
      mistake = error.what();
    }
  }
  mistake = comm.broadcast(mistake);
  if (!mistake.empty()) throw InputError(mistake);
  StudySpec spec;
  try {
    spec = read_study(Json::parse(comm.broadcast(text)), arguments.positional);
  } catch (const InputError& error) {  // a hull's file that only the root's machine has
    mistake = error.what();
  }
  mistake = first_trouble(comm, mistake);
  if (!mistake.empty()) throw InputError(mistake);
  return spec;
}

namespace {

Design planned_design(const StudySpec& spec, const Arguments& arguments) {
  const std::string wanted = arguments.value("--design");
  if (is_study_directory(arguments.positional)) {
    const auto stored = stored_design(spec, open_store_of(arguments.positional), wanted);
    if (stored) return stored->planned.design;
  }
  return find_planned(plan_study(spec), wanted).design;
}

// Of a race as far as it has sailed, unless the operation is asked for otherwise.
Design chosen_design(const StudySpec& spec, const Arguments& arguments) {
  if (!arguments.has("--design")) return baseline_of(spec);
  const Design planned = planned_design(spec, arguments);
  if (!planned.given || !arguments.has("--set")) return planned;
  Json document = planned.document;
  for (const std::string& assignment : arguments.values("--set")) apply_set(document, assignment);
  resolve_hull_files(document, spec.file);
  hold_displacement(document);
  Design changed = read_design(planned.name, std::move(document), planned.parameters);
  const bool asked = part_at(changed.document, document_key::operation) !=
                     part_at(planned.document, document_key::operation);
  return planned.sail_to > 0.0 && !asked ? sailed_to(std::move(changed), planned.sail_to) : changed;
}

}  // namespace

ChosenDesign choose_design(const StudySpec& spec, const Arguments& arguments) {
  ChosenDesign chosen;
  chosen.design = chosen_design(spec, arguments);
  if (!chosen.design.given) throw InputError(chosen.design.mistake);
  chosen.description = *chosen.design.given;
  return chosen;
}

ChosenDesign choose_design(const Communicator& comm, const StudySpec& spec, const Arguments& arguments) {
  std::string text, mistake;
  if (comm.is_root()) {
    try {
      text = json_text(to_json(choose_design(spec, arguments).design));
    } catch (const std::exception& error) {
      mistake = error.what();
    }
  }
  mistake = comm.broadcast(mistake);
  if (!mistake.empty()) throw InputError(mistake);
  ChosenDesign chosen;
  chosen.design = design_from_json(Json::parse(comm.broadcast(text)));
  mistake = first_trouble(comm, chosen.design.mistake);
  if (!mistake.empty()) throw InputError(mistake);
  chosen.description = *chosen.design.given;
  return chosen;
}

StudySpec study_of_one(const Communicator& comm, const StudySpec& spec, const Arguments& arguments) {
  const std::string out = arguments.value("--out");
  std::error_code none;
  if (std::filesystem::equivalent(arguments.positional, out, none))
    throw InputError("--out " + out + ": holds the study that the design is of; give another directory");
  Json document = choose_design(comm, spec, arguments).design.document;
  document["method"] = {{"type", "list"}};
  for (const char* key : {"designs", "include_baseline", "decide", "confirm"}) document.erase(key);
  return read_study(document, spec.file);
}

}  // namespace icebow
