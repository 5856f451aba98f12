#include "study/spec/spec_variables.h"

#include <algorithm>
#include <cmath>

#include "study/spec/spec_derived.h"
#include "study/spec/spec_designs.h"
#include "study/spec/spec_hints.h"
#include "study/spec/spec_hold.h"

namespace icebow {
namespace {

// One entry of "variables": pointer -> range.
class VariableReader {
 public:
  VariableReader(const Json& document, const MethodInfo& type, Mistakes& mistakes)
      : document_(document), type_(type), mistakes_(mistakes) {}

  Variable read(const std::string& pointer, const Json& range) {
    variable_ = Variable();
    variable_.pointer = pointer;
    at_ = "/method/variables/";
    for (const char c : pointer) at_ += c == '~' ? "~0" : c == '/' ? "~1" : std::string(1, c);
    if (!find_target()) return variable_;
    if (!range.is_object()) {
      mistake("", "is " + shown(range) + ", must be an object like {\"min\": 18, \"max\": 30}");
      return variable_;
    }
    check_keys(range);
    const std::size_t before = mistakes_.size();
    if (is_choice())
      read_words(range);
    else
      range.contains("values") ? read_values(range) : read_range(range);
    if (mistakes_.size() == before) try_ends();
    return variable_;
  }

 private:
  bool find_target() {
    target_ = find_pointer(variable_.pointer);
    const bool of_a_design =
        variable_.pointer == "/scale" || (target_.key && is_one_of(design_sections(), target_.key->section));
    if (target_.key && std::string(target_.key->section) == "bow" && document_.contains("hull")) {
      mistake(
          "",
          "is of a bow that is generated, but this file gives /hull; to deform the bow of its mesh, give an "
          "angle there and vary that, like /hull/stem_deg");
      return false;
    }
    if (!target_.key || !of_a_design || !(is_numeric(target_.key->quantity) || is_choice())) {
      mistake("", "is not a number or choice of bow, hull, ice, water, sheet, operation or solver" +
                      did_you_mean(variable_.pointer, candidates()));
      return false;
    }
    if (is_derived(document_, variable_.pointer)) {
      mistake("", "is derived by an expression in /derived: vary what that depends on");
      return false;
    }
    const Json::json_pointer pointer(variable_.pointer);
    if (!document_.contains(pointer)) {
      mistake("", "is not in this file; " + other_spelling());
      return false;
    }
    if (variable_.pointer == held_pointer(document_)) {
      mistake("", "follows from the displacement in /hold: drop it, or choose another dimension in /hold/by");
      return false;
    }
    return true;
  }

  // What to do where the file has no such key: it may have it in another unit.
  std::string other_spelling() const {
    const Key& key = *target_.key;
    for (const Unit& unit : units_of(key.quantity)) {
      const std::string there = "/" + std::string(key.section) + "/" + key.name + unit.suffix;
      if (document_.contains(Json::json_pointer(there)))
        return "the file gives " + there + ": vary that, in its unit";
    }
    return "give it there, as the baseline's value";
  }

  std::vector<std::string> candidates() const {
    std::vector<std::string> known;
    for (const std::string& section : design_sections()) {
      for (const Key* key : keys_of_section(section)) {
        if (is_numeric(key->quantity) || key->quantity == Quantity::choice)
          known.push_back("/" + section + "/" + spelled(*key));
      }
    }
    return known;
  }

  bool is_choice() const { return target_.key->quantity == Quantity::choice; }

  void check_keys(const Json& range) {
    if (is_choice() && !is_one_of(type_.variable_keys, "values")) return;  // read_words says it
    for (const auto& item : range.items()) {
      if (is_one_of(type_.variable_keys, item.key())) continue;
      const bool other_method = is_one_of({"min", "max", "levels", "values"}, item.key());
      mistake("/" + item.key(), other_method ? std::string("is not used by the method \"") + type_.name +
                                                   "\"; it takes " + listed(type_.variable_keys)
                                             : "is not a key of a variable" +
                                                   did_you_mean(item.key(), type_.variable_keys) +
                                                   "; it has " + listed(type_.variable_keys));
    }
  }

  // NaN where it is not a number in the key's allowed range.
  double read_number(const Json& value, const std::string& below) {
    const Key& key = *target_.key;
    const bool number = value.is_number();
    const double x = number ? value.get<double>() : 0.0;
    if (!number || !(x >= lower_in(key, *target_.unit) && x <= upper_in(key, *target_.unit))) {
      mistake(below, "is " + shown(value) + (number ? "" : ", must be a number") + number_meant_by(value) +
                         ", allowed " + range_in_words(key, *target_.unit));
      return NAN;
    }
    if (key.quantity == Quantity::integer && std::floor(x) != x) {
      mistake(below, "is " + shown(value) + ", must be a whole number");
      return NAN;
    }
    return x;
  }

  void read_values(const Json& range) {
    if (range.contains("min") || range.contains("max") || range.contains("levels")) {
      mistake("", "gives values and a range; keep values, or min, max and levels");
    }
    const Json& values = range.at("values");
    if (!values.is_array() || values.empty()) {
      return mistake("/values", "is " + shown(values) + ", must be a list of one or more numbers");
    }
    for (std::size_t k = 0; k < values.size(); ++k) {
      const double x = read_number(values[k], "/values/" + std::to_string(k));
      if (contains_value(x))
        mistake("/values/" + std::to_string(k), "is " + shown(values[k]) + " again; list each value once");
      variable_.values.push_back(x);
    }
    variable_.lower = *std::min_element(variable_.values.begin(), variable_.values.end());
    variable_.upper = *std::max_element(variable_.values.begin(), variable_.values.end());
  }

  // Of a choice, like the family of the bow.
  void read_words(const Json& range) {
    const Key& key = *target_.key;
    if (!is_one_of(type_.variable_keys, "values"))
      return mistake("", "is a choice of words, which the method \"" + std::string(type_.name) +
                             "\" cannot vary; take grid, one_at_a_time, latin_hypercube, sobol or halton");
    const Json words = range.value("values", Json());
    if (!words.is_array() || words.empty() || range.size() != 1)
      return mistake("/values", "is " + shown(words) + ", must be a list of one or more of " +
                                    listed(key.choices) + ", and nothing beside it");
    bool known = true;
    for (std::size_t k = 0; k < words.size(); ++k) {
      const std::string at = "/values/" + std::to_string(k);
      const std::string word = words[k].is_string() ? words[k].get<std::string>() : "";
      known = known && is_one_of(key.choices, word);
      if (!is_one_of(key.choices, word))
        mistake(at, "is " + shown(words[k]) + ", must be one of " + listed(key.choices) +
                        did_you_mean(word, key.choices));
      if (is_one_of(variable_.words, word)) mistake(at, "is \"" + word + "\" again; list each once");
      variable_.words.push_back(word);
      variable_.values.push_back(static_cast<double>(k));
    }
    variable_.upper = variable_.values.back();
    const Json& own = document_.at(Json::json_pointer(variable_.pointer));
    if (known && (!own.is_string() || !is_one_of(variable_.words, own.get<std::string>())))
      mistake("/values", "do not hold " + shown(own) + ", which the file has: add it");
  }

  bool contains_value(double x) const {
    return std::find(variable_.values.begin(), variable_.values.end(), x) != variable_.values.end();
  }

  void read_range(const Json& range) {
    const bool grid = is_one_of(type_.variable_keys, "levels");
    const bool lists = is_one_of(type_.variable_keys, "values");
    const std::string shape = grid    ? "min, max and levels, or values"
                              : lists ? "min and max, or values"
                                      : "min and max";
    for (const char* needed : {"min", "max", "levels"}) {
      const bool wanted = grid || std::string(needed) != "levels";
      if (wanted && !range.contains(needed))
        mistake(std::string("/") + needed, "is missing; a variable needs " + shape);
    }
    if (target_.key->quantity == Quantity::integer) {
      mistake("",
              "takes whole numbers only, so no range; list them in values (methods \"grid\", "
              "\"one_at_a_time\", \"latin_hypercube\", \"sobol\" and \"halton\")");
    }
    if (range.contains("min")) variable_.lower = read_number(range.at("min"), "/min");
    if (range.contains("max")) variable_.upper = read_number(range.at("max"), "/max");
    if (range.contains("min") && range.contains("max") && variable_.lower >= variable_.upper) {
      mistake("/min", "is " + brief(variable_.lower) + ", not less than max " + brief(variable_.upper));
    }
    if (grid && range.contains("levels")) read_levels(range.at("levels"));
  }

  void read_levels(const Json& levels) {
    const bool whole = levels.is_number() && std::floor(levels.get<double>()) == levels.get<double>();
    if (!whole || levels.get<double>() < 2 || levels.get<double>() > 1000) {
      return mistake("/levels", "is " + shown(levels) + ", must be a whole number, allowed 2 to 1000");
    }
    variable_.levels = static_cast<int>(levels.get<double>());
  }

  // Each end of the range by itself must make a case that can be run.
  void try_ends() {
    const CaseMistakes baseline(document_);
    const auto attempt = [&](const Json& x) {
      Json changed = baseline.document();
      changed[Json::json_pointer(variable_.pointer)] = x;
      for (const Mistake& m : baseline.fresh(changed)) {
        mistake("", "at " + (x.is_number() ? brief(x.get<double>()) : shown(x)) + " makes " + m.pointer +
                        " wrong: it " + m.message);
      }
    };
    for (const std::string& word : variable_.words) attempt(word);
    if (!variable_.words.empty()) return;
    attempt(variable_.lower);
    if (variable_.upper != variable_.lower) attempt(variable_.upper);
  }

  void mistake(const std::string& below, const std::string& message) {
    mistakes_.push_back({at_ + below, message});
  }

  const Json& document_;
  const MethodInfo& type_;
  Mistakes& mistakes_;
  Variable variable_;
  std::string at_;
  Spelling target_;
};

}  // namespace

bool is_one_of(const std::vector<std::string>& words, const std::string& word) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

Variable parse_variable(const Json& document, const MethodInfo& method, const std::string& pointer,
                        const Json& range, Mistakes& mistakes) {
  return VariableReader(document, method, mistakes).read(pointer, range);
}

}  // namespace icebow
