#include "study/spec/held_document.h"

#include <cmath>
#include <cstdlib>

#include "base/text.h"
#include "hullgen/bow/bow_volume.h"
#include "study/spec/spec_case.h"
#include "study/spec/spec_hold.h"

namespace icebow {

void hold_displacement(Json& document) {
  if (!has_hold(document) || document.contains("hull")) return;
  Json free = document;
  free.erase("hold");
  Mistakes mistakes;
  Hold hold = read_hold(document, mistakes);
  const Case c = parse_case(free, mistakes);
  if (!mistakes.empty() || !in_range(c.bow)) return;
  const std::string pointer = held_pointer(document);
  if (pointer.empty()) return;
  if (std::isnan(hold.displacement)) {
    hold.displacement = std::strtod(text("%.10g", bow_displacement(c.bow)).c_str(), nullptr);
    document["hold"]["displacement_m3"] = hold.displacement;
  }
  const Key& key = *find_key("bow", hold.by);
  const auto value =
      dimension_for_displacement(c.bow, hold.displacement, dimension_of(hold), key.lower, key.upper);
  if (!value) return;
  Json& written = document[Json::json_pointer(pointer)];  // in the section's unit and scale
  const double unit = written.get<double>() / held_value(c.bow, hold);
  written = std::strtod(text("%.10g", *value * unit).c_str(), nullptr);
}

}  // namespace icebow
