#include "study/evaluate/scenario_result.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>

#include "base/json_fields.h"
#include "base/text_file.h"
#include "solver/model/mean_difference.h"
#include "study/evaluate/evaluation.h"
#include "study/evaluate/result_keys.h"

namespace icebow {
namespace {

namespace fs = std::filesystem;

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
      const std::string at = (Json::json_pointer(pointer) / item.key()).to_string();
      if (item.value().is_object()) replace_loads(part[item.key()], at);
      if (ends_in(item.key(), "_N")) part[item.key()] = finite_or_null(load(item.key(), at));
    }
  }

  // Of the mean at `mean`, whose half width is at `ci95`; NaN where a scenario does not say.
  double samples(const char* at, const char* mean, const char* ci95) const {
    double variance = 0.0, squares = 0.0, widest = -1.0, of_widest = 0.0;
    for (const ScenarioResult& s : scenarios_) {
      const double half = number_at(s.result, ci95), n = number_at(s.result, at), share = s.weight / weights_;
      const MeanEstimate e = mean_estimate(number_at(s.result, mean), half, n);
      if (!std::isfinite(e.standard_error)) return std::numeric_limits<double>::quiet_NaN();
      const double part = std::pow(share * e.standard_error, 2);
      variance += part, squares += part * part / e.degrees_of_freedom;
      if (half > widest) widest = half, of_widest = n;
    }
    return by_worst_ ? of_widest : squares > 0.0 ? 1.0 + variance * variance / squares : of_widest;
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
  const bool simulated = s.result.contains("simulation") && s.result.at("simulation").is_object();
  for (const char* part : {"lindqvist", "cycle", "programs"})
    if (s.result.contains(part)) entry[part] = s.result.at(part);
  for (const char* part : {"metrics", "simulation"})
    if (simulated && s.result.contains(part)) entry[part] = s.result.at(part);
  for (const char* long_part : {"metrics", "process", "same_way"})
    if (entry.contains("cycle")) entry["cycle"].erase(long_part);
  return entry;
}

void replace_samples(Json& result, const Combination& combination) {
  const auto replace = [&](const char* at, const char* mean, const char* ci95) {
    const Json::json_pointer pointer(at);
    if (result.contains(pointer)) result[pointer] = finite_or_null(combination.samples(at, mean, ci95));
  };
  replace(result_key::effective_samples, result_key::mean_load, result_key::mean_load_ci95);
  replace(result_key::cycle_effective_samples, result_key::cycle_load, result_key::cycle_load_ci95);
}

std::string kept_name(const std::string& key) {
  return "scenario_" + key.substr(0, 16) + ".json";
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
  replace_samples(result, combination);
  judge_formula(result, scenarios);
  result["scenarios"] = Json::array();
  for (const ScenarioResult& s : scenarios) result["scenarios"].push_back(entry_of(s));
  return result;
}

std::vector<ScenarioLoad> scenario_loads(const Json& result) {
  std::vector<ScenarioLoad> loads;
  const Json& list = part_at(result, result_key::scenarios);
  if (!list.is_array()) return loads;
  for (const Json& one : list) {
    ScenarioLoad load{text_at(one, result_key::scenario_name), number_at(one, result_key::scenario_weight),
                      number_at(one, result_key::mean_load), number_at(one, result_key::mean_load_ci95)};
    if (!std::isfinite(load.mean))
      load.mean = number_at(one, result_key::cycle_load),
      load.ci95 = number_at(one, result_key::cycle_load_ci95);
    if (!std::isfinite(load.mean))
      load.mean = number_at(one, result_key::lindqvist_breaking);  // what is ranked
    loads.push_back(load);
  }
  return loads;
}

Json kept_scenario(const std::string& design_directory, const std::string& key) {
  const fs::path file = fs::path(design_directory) / kept_name(key);
  try {
    if (!fs::exists(file)) return nullptr;
    const Json kept = read_json_file(file.string());
    return text_at(kept, "/key") == key ? kept.at("result") : Json(nullptr);
  } catch (const std::exception&) {  // damaged: evaluated once more
    return nullptr;
  }
}

void keep_scenario(const std::string& design_directory, const std::string& key, const Json& result) {
  write_text_file((fs::path(design_directory) / kept_name(key)).string(),
                  json_text(Json{{"key", key}, {"result", result}}) + "\n");
}

bool is_kept_scenario(const std::string& file_name) {
  return file_name.rfind("scenario_", 0) == 0 && ends_in(file_name, ".json");
}

void remove_kept_scenarios(const std::string& design_directory) {
  std::error_code ignored;
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(design_directory, ignored))
    if (is_kept_scenario(entry.path().filename().string())) files.push_back(entry.path());
  for (const fs::path& file : files) fs::remove(file, ignored);
}

}  // namespace icebow
