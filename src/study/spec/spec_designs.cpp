#include "study/spec/spec_designs.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <set>

#include "study/spec/design_name.h"
#include "study/spec/held_document.h"
#include "study/spec/spec_case.h"
#include "study/spec/spec_derived.h"
#include "study/spec/spec_hints.h"
#include "study/spec/spec_hold.h"

namespace icebow {
namespace {

// Names the program gives itself.
bool is_reserved(const std::string& name) {
  return name == "baseline" || is_numbered_name(name);
}

std::string parse_name(const Json& design, const std::string& at, Mistakes& mistakes) {
  const auto name = design.find("name");
  if (name == design.end()) {
    mistakes.push_back({at + "/name", "is missing; give the design a name of its own"});
    return "";
  }
  if (!name->is_string() || !is_design_name(name->get<std::string>())) {
    mistakes.push_back(
        {at + "/name", "is " + shown(*name) +
                           ", must be 1 to 64 letters, digits, spaces or . _ + ( ) -, in UTF-8 200 bytes at "
                           "most, and start with a letter or digit: it names a directory"});
    return "";
  }
  if (is_reserved(*name)) {
    mistakes.push_back(
        {at + "/name",
         "is " + shown(*name) + ", a name the program gives itself (baseline, d001 ...); choose another"});
  }
  return *name;
}

// A patch may change the ship, the ice and the run, not the study.
bool parse_patch_keys(const Json& patch, const std::string& at, Mistakes& mistakes) {
  if (!patch.is_object()) {
    mistakes.push_back({at, "is " + shown(patch) + ", must be an object like {\"bow\": {\"stem_deg\": 20}}"});
    return false;
  }
  std::vector<std::string> allowed = design_sections();
  allowed.push_back("scale");
  for (const auto& item : patch.items()) {
    if (std::find(allowed.begin(), allowed.end(), item.key()) != allowed.end()) {
      check_dropped_keys(item.key(), item.value(), at, mistakes);
      continue;
    }
    mistakes.push_back({at + "/" + item.key(), "cannot be changed by a design, which may set " +
                                                   listed(allowed) + did_you_mean(item.key(), allowed)});
  }
  return true;
}

// What follows from a displacement that is held is no design's to say.
void refuse_held(const Json& document, const Json& patch, const std::string& at, Mistakes& mistakes) {
  const std::string held = held_pointer(document);
  if (held.empty() || !patch.contains(Json::json_pointer(held))) return;
  mistakes.push_back(
      {at + held,
       "follows from the displacement in /hold: drop it, or choose another dimension in /hold/by"});
}

NamedDesign parse_design(const CaseMistakes& baseline, const Json& design, const std::string& at,
                         Mistakes& mistakes) {
  NamedDesign named;
  if (!design.is_object()) {
    mistakes.push_back({at, "is " + shown(design) + ", must be {\"name\": \"...\", \"set\": {...}}"});
    return named;
  }
  for (const auto& item : design.items()) {
    if (item.key() == "name" || item.key() == "set") continue;
    mistakes.push_back(
        {at + "/" + item.key(),
         "is not a key of a design" + did_you_mean(item.key(), {"name", "set"}) + "; it has name, set"});
  }
  named.name = parse_name(design, at, mistakes);
  named.set = design.value("set", Json::object());
  if (!parse_patch_keys(named.set, at + "/set", mistakes)) return named;
  refuse_held(baseline.document(), named.set, at + "/set", mistakes);
  for (const auto& [section, values] : named.set.items()) {
    if (!values.is_object()) continue;
    for (const auto& [key, value] : values.items())
      if (is_derived(baseline.document(), "/" + section + "/" + key))
        mistakes.push_back({at + "/set/" + section + "/" + key,
                            "is derived by an expression in /derived: change what that depends on"});
  }
  Json patched = baseline.document();
  patched.merge_patch(named.set);
  for (const Mistake& m : baseline.fresh(patched)) {
    mistakes.push_back({at + "/set" + m.pointer, m.message});
  }
  return named;
}

void check_program(const Json& entry, const std::string& at, Mistakes& mistakes) {
  const std::vector<std::string> keys = {"name", "command", "time_limit_s"};
  for (const auto& item : entry.items())
    if (std::find(keys.begin(), keys.end(), item.key()) == keys.end())
      mistakes.push_back({at + "/" + item.key(), "is not a key of a program that evaluates" +
                                                     did_you_mean(item.key(), keys) + "; it has " +
                                                     listed(keys)});
  const Json name = entry.value("name", Json()), command = entry.value("command", Json()),
             limit = entry.value("time_limit_s", Json(600.0));
  const auto plain = [](const std::string& text) {
    return !text.empty() && text.size() <= 40 &&
           std::all_of(text.begin(), text.end(), [](unsigned char c) { return std::isalnum(c) || c == '_'; });
  };
  if (!name.is_string() || !plain(name.get<std::string>()))
    mistakes.push_back({at + "/name", "is " + shown(name) +
                                          ", must be 1 to 40 letters, digits or _: the program's "
                                          "results are /programs/NAME/..."});
  const bool words =
      command.is_array() && !command.empty() &&
      std::all_of(command.begin(), command.end(), [](const Json& word) { return word.is_string(); });
  if (!words || command[0] == "")
    mistakes.push_back(
        {at + "/command", "is " + shown(command) +
                              ", must be a list of words, the program first, like [\"python3\", "
                              "\"yard.py\"]; files are looked for from the study file's directory"});
  if (!limit.is_number() || !(limit.get<double>() > 0.0 && limit.get<double>() <= 1e8))
    mistakes.push_back({at + "/time_limit_s", "is " + shown(limit) + ", must be a number" +
                                                  number_meant_by(limit) + ", allowed above 0 to 1e+08 s"});
}

}  // namespace

CaseMistakes::CaseMistakes(const Json& document) : document_(document) {
  for (const char* list : {"designs", "method"})
    document_.erase(list);  // may be long, and say nothing of a case
  Mistakes mistakes;
  parse_case(document_, mistakes);
  for (const Mistake& m : mistakes) known_.emplace(m.pointer, m.message);
}

Mistakes CaseMistakes::fresh(const Json& changed) const {
  Mistakes all, fresh;
  Json held = changed;
  hold_displacement(held);
  parse_case(held, all);
  for (const Mistake& m : all)
    if (known_.count({m.pointer, m.message}) == 0) fresh.push_back(m);
  return fresh;
}

std::vector<NamedDesign> parse_designs(const Json& document, Mistakes& mistakes) {
  std::vector<NamedDesign> designs;
  if (!document.contains("designs")) return designs;
  const Json& list = document.at("designs");
  if (!list.is_array()) {
    mistakes.push_back(
        {"/designs", "is " + type_name(list) + ", must be a list [{\"name\": \"...\", \"set\": {...}}]"});
    return designs;
  }
  std::set<std::string> names;
  const CaseMistakes baseline(document);
  for (std::size_t k = 0; k < list.size(); ++k) {
    const std::string at = "/designs/" + std::to_string(k);
    designs.push_back(parse_design(baseline, list[k], at, mistakes));
    const std::string& name = designs.back().name;
    if (!name.empty() && !names.insert(name).second) {
      mistakes.push_back(
          {at + "/name", "is \"" + name + "\", the name of an earlier design; every name is its own"});
    }
  }
  return designs;
}

std::optional<ProgramEvaluator> program_of(const Json& entry) {
  if (!entry.is_object()) return std::nullopt;
  ProgramEvaluator program;
  const auto name = entry.find("name"), command = entry.find("command"), limit = entry.find("time_limit_s");
  if (name != entry.end() && name->is_string()) program.name = name->get<std::string>();
  if (command != entry.end() && command->is_array())
    for (const Json& word : *command)
      if (word.is_string()) program.command.push_back(word.get<std::string>());
  if (limit != entry.end() && limit->is_number()) program.time_limit = limit->get<double>();
  return program;
}

void resolve_program_files(Json& document, const std::string& study_file) {
  if (!document.contains("evaluators") || !document.at("evaluators").is_array()) return;
  const std::filesystem::path folder = std::filesystem::path(study_file).parent_path();
  for (Json& entry : document.at("evaluators")) {
    if (!entry.is_object() || !entry.contains("command") || !entry.at("command").is_array()) continue;
    for (Json& word : entry.at("command")) {
      if (!word.is_string()) continue;
      std::error_code none;
      const std::filesystem::path file = folder / word.get<std::string>();
      if (std::filesystem::is_regular_file(file, none))
        word = std::filesystem::absolute(file).lexically_normal().string();
    }
  }
}

void parse_evaluators(const Json& document, StudySpec& spec, Mistakes& mistakes) {
  if (!document.contains("evaluators")) return;
  const Json& list = document.at("evaluators");
  const std::vector<std::string> known = {"lindqvist", "cycle", "peridynamics"};
  if (!list.is_array() || list.empty()) {
    mistakes.push_back(
        {"/evaluators", "is " + shown(list) + ", must be a list of one or more of " + listed(known)});
    return;
  }
  std::set<std::string> given;
  for (std::size_t k = 0; k < list.size(); ++k) {
    const std::string at = "/evaluators/" + std::to_string(k);
    if (list[k].is_object()) {
      check_program(list[k], at, mistakes);
      const ProgramEvaluator program = *program_of(list[k]);
      if (!program.name.empty() && !given.insert(program.name).second)
        mistakes.push_back({at + "/name", "is \"" + program.name + "\" again; name each evaluator once"});
      spec.programs.push_back(program);
      continue;
    }
    const std::string word = list[k].is_string() ? list[k].get<std::string>() : "";
    if (std::find(known.begin(), known.end(), word) == known.end()) {
      mistakes.push_back(
          {at, "is " + shown(list[k]) + ", must be one of " + listed(known) + did_you_mean(word, known) +
                   ", or a program: {\"name\": \"yard\", \"command\": [\"python3\", \"yard.py\"]}"});
    } else if (!given.insert(word).second) {
      mistakes.push_back({at, "is \"" + word + "\" again; name each evaluator once"});
    }
  }
  spec.use_lindqvist = given.count("lindqvist") > 0;
  spec.use_cycle = given.count("cycle") > 0;
  spec.use_peridynamics = given.count("peridynamics") > 0;
}

}  // namespace icebow
