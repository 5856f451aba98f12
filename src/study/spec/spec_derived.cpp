// The one file that includes muParser.
#include "study/spec/spec_derived.h"

#include <muParser.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "base/json_fields.h"
#include "base/units.h"
#include "study/spec/spec_hints.h"

namespace icebow {
namespace {

constexpr std::size_t longest = 1000;  // characters of an expression

std::string escaped(const std::string& pointer) {
  std::string out;
  for (const char c : pointer) out += c == '~' ? "~0" : c == '/' ? "~1" : std::string(1, c);
  return out;
}

// "bow.beam_m" stands at "/bow/beam_m".
std::string pointer_of(std::string name) {
  std::replace(name.begin(), name.end(), '.', '/');
  return "/" + name;
}

// muParser knows "a = 1", which would change a number on the way.
bool assigns(const std::string& expression) {
  for (std::size_t i = 0; i < expression.size(); ++i) {
    if (expression[i] != '=') continue;
    const bool two = i + 1 < expression.size() && expression[i + 1] == '=';
    const bool compares = i > 0 && std::string("<>!").find(expression[i - 1]) != std::string::npos;
    if (!two && !compares) return true;
    i += two;
  }
  return false;
}

class Derivation {
 public:
  Derivation(Json& document, Mistakes& mistakes)
      : document_(document), expressions_(document.at("derived")), mistakes_(mistakes) {}

  void all() {
    for (const auto& [pointer, expression] : expressions_.items())
      if (is_good(pointer, expression)) derive(pointer);
  }

 private:
  bool is_good(const std::string& pointer, const Json& expression) {
    const std::size_t before = mistakes_.size();
    const Spelling target = find_pointer(pointer);
    const auto sections = design_sections();
    const bool of_a_design =
        target.key && std::find(sections.begin(), sections.end(), target.key->section) != sections.end();
    if (!of_a_design || !is_numeric(target.key->quantity))
      mistake(pointer, "is not a number of " + listed(sections));
    else if (!std::isfinite(number_at(document_, pointer)))
      mistake(pointer, "is not in this file; give a number there, which the expression replaces");
    if (!expression.is_string() || expression.get<std::string>().size() > longest)
      mistake(pointer, "is " + shown(expression) +
                           ", must be an expression like \"1.6 * bow.beam_m\", of 1000 characters at most");
    return mistakes_.size() == before;
  }

  // The value, once it is known; NaN where there is none.
  double derive(const std::string& pointer) {
    const auto known = values_.find(pointer);
    if (known != values_.end()) return known->second;
    if (!under_way_.insert(pointer).second) {
      mistake(pointer, "depends on itself: break the circle");
      return values_[pointer] = NAN;
    }
    const double value = evaluated(pointer, expressions_.at(pointer).get<std::string>());
    under_way_.erase(pointer);
    if (std::isfinite(value)) document_[Json::json_pointer(pointer)] = value;
    return values_[pointer] = value;
  }

  double evaluated(const std::string& pointer, const std::string& expression) {
    if (assigns(expression)) {
      mistake(pointer, "has a =, which sets nothing here: " + expression + "; give what stands behind it");
      return NAN;
    }
    try {
      mu::Parser parser;
      parser.DefineNameChars("0123456789_abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ.");
      parser.DefineConst("deg", radians(1.0));
      parser.SetExpr(expression);
      std::map<std::string, double> numbers;
      for (const auto& [name, ignored] : parser.GetUsedVar()) {
        const double number = number_of(pointer, name);
        if (!std::isfinite(number)) return NAN;
        numbers[name] = number;
      }
      for (auto& [name, number] : numbers) parser.DefineVar(name, &number);
      int values = 0;
      const double value = parser.Eval(values)[values - 1];
      if (values != 1) {
        mistake(pointer, "gives " + std::to_string(values) +
                             " numbers, for a comma parts them: " + expression + "; write a decimal point");
        return NAN;
      }
      if (!std::isfinite(value)) mistake(pointer, "gives no number here: " + expression);
      return value;
    } catch (const mu::Parser::exception_type& error) {
      mistake(pointer, "is no expression: " + error.GetMsg());
      return NAN;
    }
  }

  double number_of(const std::string& pointer, const std::string& name) {
    const std::string there = pointer_of(name);
    if (expressions_.contains(there) && expressions_.at(there).is_string()) return derive(there);
    const double number = number_at(document_, there);
    if (!std::isfinite(number))
      mistake(pointer, "names " + name + ", but the file has no number at " + there);
    return number;
  }

  void mistake(const std::string& pointer, const std::string& message) {
    mistakes_.push_back({"/derived/" + escaped(pointer), message});
  }

  Json& document_;
  const Json expressions_;
  Mistakes& mistakes_;
  std::map<std::string, double> values_;
  std::set<std::string> under_way_;
};

}  // namespace

void apply_derived(Json& document, Mistakes& mistakes) {
  if (!document.is_object() || !document.contains("derived")) return;
  const Json& derived = document.at("derived");
  if (!derived.is_object()) {
    mistakes.push_back(
        {"/derived", "is " + type_name(derived) +
                         ", must be an object like {\"/bow/bow_length_m\": \"1.6 * bow.beam_m\"}"});
    return;
  }
  if (document.contains("hold"))
    mistakes.push_back(
        {"/derived", "is given beside /hold, which derives a dimension of the bow itself: drop one of them"});
  else
    Derivation(document, mistakes).all();
}

bool is_derived(const Json& document, const std::string& pointer) {
  return document.contains("derived") && document.at("derived").is_object() &&
         document.at("derived").contains(pointer);
}

}  // namespace icebow
