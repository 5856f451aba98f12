#include "study/evaluate/progress_json.h"

#include "study/evaluate/evaluation.h"

namespace icebow {

std::string progress_line(const Progress& p) {
  return Json{{"step", p.step},
              {"steps", p.steps},
              {"advance_m", p.advance},
              {"load_N", p.load},
              {"seconds", p.seconds},
              {"ns_per_bond", p.ns_per_bond},
              {"hull_work_J", p.hull_work},
              {"balance_error_J", p.balance_error}}
      .dump();
}

std::optional<Progress> progress_from_line(const std::string& line) {
  const Json json = Json::parse(line, nullptr, /*allow_exceptions*/ false);
  if (!json.is_object() || !json.contains("step") || !json.contains("steps")) return std::nullopt;
  const auto number = [&](const char* key) {
    return json.contains(key) && json[key].is_number() ? json[key].get<double>() : 0.0;
  };
  Progress p;
  p.step = static_cast<std::int64_t>(number("step"));
  p.steps = static_cast<std::int64_t>(number("steps"));
  p.advance = number("advance_m");
  p.load = number("load_N");
  p.seconds = number("seconds");
  p.ns_per_bond = number("ns_per_bond");
  p.hull_work = number("hull_work_J");
  p.balance_error = number("balance_error_J");
  return p;
}

std::string trouble_line(const std::string& words) {
  return json_text(Json{{"machine_trouble", words}});
}

std::optional<std::string> trouble_from_line(const std::string& line) {
  const Json json = Json::parse(line, nullptr, /*allow_exceptions*/ false);
  if (!json.is_object() || !json.contains("machine_trouble") || !json.at("machine_trouble").is_string())
    return std::nullopt;
  return json.at("machine_trouble").get<std::string>();
}

}  // namespace icebow
