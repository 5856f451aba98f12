#include "cli/study_choice.h"

#include "base/errors.h"
#include "study/spec/read_study.h"
#include "study/spec/spec_hints.h"
#include "study/spec/spec_hull.h"

namespace icebow {
namespace {

Json load_document(const Arguments& arguments) {
  Json document = read_json_file(arguments.positional);
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

Design chosen_design(const StudySpec& spec, const Arguments& arguments) {
  if (!arguments.has("--design")) return baseline_of(spec);
  const StudyPlan plan = plan_study(spec);
  const Design& planned = find_planned(plan, arguments.value("--design")).design;
  if (!planned.given || !arguments.has("--set")) return planned;
  Json document = planned.document;
  for (const std::string& assignment : arguments.values("--set")) apply_set(document, assignment);
  resolve_hull_files(document, spec.file);
  return read_design(planned.name, std::move(document), planned.parameters);
}

}  // namespace

ChosenDesign choose_design(const StudySpec& spec, const Arguments& arguments) {
  ChosenDesign chosen;
  chosen.design = chosen_design(spec, arguments);
  if (!chosen.design.given) throw InputError(chosen.design.mistake);
  chosen.description = *chosen.design.given;
  return chosen;
}

}  // namespace icebow
