#include "study/evaluate/scenario_result.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/json_fields.h"
#include "study/evaluate/result_keys.h"

namespace icebow {
namespace {

bool ends_in(const std::string& text, const std::string& end) {
  return text.size() >= end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

class Combination {
 public:
  Combination(const std::vector<ScenarioResult>& scenarios, bool by_worst)
      : scenarios_(scenarios), by_worst_(by_worst) {
    for (const ScenarioResult& s : scenarios) weights_ += s.weight;
  }

  // The loads of `part`, which is at `pointer` of every result.
  void replace_loads(Json& part, const std::string& pointer) const {
    if (!part.is_object()) return;
    for (const auto& item : part.items()) {
      const std::string at = pointer + "/" + item.key();
      if (item.value().is_object()) replace_loads(part[item.key()], at);
      if (ends_in(item.key(), "_N")) part[item.key()] = finite_or_null(load(item.key(), at));
    }
  }

 private:
  double load(const std::string& key, const std::string& at) const {
    const bool half_width = key.find("ci95") != std::string::npos;
    const bool largest = by_worst_ || key == "max_load_N";
    double sum = 0.0, worst = 0.0;
    for (const ScenarioResult& s : scenarios_) {
      const double value = number_at(s.result, at), share = s.weight / weights_;
      if (!std::isfinite(value)) return std::numeric_limits<double>::quiet_NaN();
      if (std::fabs(value) > std::fabs(worst)) worst = value;
      sum += half_width ? std::pow(share * value, 2) : share * value;
    }
    return largest ? worst : half_width ? std::sqrt(sum) : sum;
  }

  const std::vector<ScenarioResult>& scenarios_;
  bool by_worst_;
  double weights_ = 0.0;
};

Json entry_of(const ScenarioResult& s) {
  Json entry = {{"name", s.name}, {"weight", s.weight}};
  for (const char* part : {"lindqvist", "cycle", "programs"})
    if (s.result.contains(part)) entry[part] = s.result.at(part);
  for (const char* long_part : {"metrics", "process", "same_way"})
    if (entry.contains("cycle")) entry["cycle"].erase(long_part);
  return entry;
}

void judge_formula(Json& result, const std::vector<ScenarioResult>& scenarios) {
  for (const ScenarioResult& s : scenarios) {
    if (!is_false_at(s.result, result_key::lindqvist_valid)) continue;
    result["lindqvist"]["valid"] = false;
    result["lindqvist"]["reason"] = s.name + ": " + text_at(s.result, result_key::lindqvist_reason);
    return;
  }
}

}  // namespace

Json combined(const std::vector<ScenarioResult>& scenarios, bool by_worst) {
  Json result = scenarios.at(0).result;
  const Combination combination(scenarios, by_worst);
  for (const char* part : {"lindqvist", "cycle", "metrics", "programs"})
    if (result.contains(part)) combination.replace_loads(result[part], std::string("/") + part);
  judge_formula(result, scenarios);
  result["scenarios"] = Json::array();
  for (const ScenarioResult& s : scenarios) result["scenarios"].push_back(entry_of(s));
  return result;
}

}  // namespace icebow
