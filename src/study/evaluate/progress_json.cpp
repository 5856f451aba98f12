#include "study/evaluate/progress_json.h"

#include "base/whole_number.h"
#include "study/evaluate/evaluation.h"

namespace icebow {
namespace {

// A line of a child that is an object; null where it is anything else, such as a library's greeting.
Json object_of(const std::string& line) {
  return line.empty() || line[0] != '{' ? Json() : json_or_null(line);
}

}  // namespace

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
  const Json json = object_of(line);
  if (!json.is_object() || !json.contains("step") || !json.contains("steps")) return std::nullopt;
  const auto number = [&](const char* key) {
    return json.contains(key) && json[key].is_number() ? json[key].get<double>() : 0.0;
  };
  const double step = number("step"), steps = number("steps");
  if (!(step >= 0.0 && steps >= step && steps <= most_whole)) return std::nullopt;
  Progress p;
  p.step = static_cast<std::int64_t>(step);
  p.steps = static_cast<std::int64_t>(steps);
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
  const Json json = object_of(line);
  if (!json.is_object() || !json.contains("machine_trouble") || !json.at("machine_trouble").is_string())
    return std::nullopt;
  return json.at("machine_trouble").get<std::string>();
}

}  // namespace icebow
