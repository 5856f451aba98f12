#include "study/spec/spec_hold.h"

#include <cmath>

#include "base/text.h"
#include "hullgen/bow/dimensions.h"
#include "study/spec/spec_hints.h"

namespace icebow {
namespace {

constexpr double kept = 1e-6;  // of the displacement: the document has ten digits

std::string pointer_to(const Json& document, const std::string& by) {
  const Key* key = find_key("bow", by);
  if (key == nullptr) return "";
  for (const Unit& unit : units_of(key->quantity)) {
    const std::string pointer = "/bow/" + by + unit.suffix;
    if (document.contains(Json::json_pointer(pointer))) return pointer;
  }
  return "";
}

}  // namespace

Hold read_hold(const Json& document, Mistakes& mistakes) {
  const Section s(document, "hold", 1.0, mistakes);
  return {s.number("displacement"), s.text("by", "length")};
}

HeldBy dimension_of(const Hold& hold) {
  const std::string& by = hold.by;
  return by == "beam" ? HeldBy::beam : by == "draft" ? HeldBy::draft : HeldBy::length;
}
double held_value(const BowParameters& bow, const Hold& hold) {
  const std::string& by = hold.by;
  return by == "beam" ? bow.B : by == "draft" ? bow.T : bow.L;
}

bool in_range(const BowParameters& bow) {
  return dimension_problem(bow).empty() && angle_range(bow.angles).margin >= 0.0;
}

bool has_hold(const Json& document) {
  return document.is_object() && document.contains("hold") && document.at("hold").is_object();
}

std::string held_pointer(const Json& document) {
  if (!has_hold(document)) return "";
  Mistakes mistakes;
  return pointer_to(document, read_hold(document, mistakes).by);
}

std::optional<HeldDisplacement> held_displacement(const Json& document) {
  if (!has_hold(document)) return {};
  Mistakes mistakes;
  const Hold hold = read_hold(document, mistakes);
  if (std::isnan(hold.displacement)) return {};
  const Key& key = *find_key("bow", hold.by);
  return HeldDisplacement{hold.displacement, dimension_of(hold), key.lower, key.upper};
}

void check_hold(const Json& document, const Case& c, Mistakes& mistakes) {
  if (!document.contains("hold")) return;
  const std::size_t before = mistakes.size();
  const Hold hold = read_hold(document, mistakes);
  if (document.contains("hull"))
    mistakes.push_back(
        {"/hold",
         "keeps the displacement of bows that are generated, but this file gives /hull: drop it; "
         "/constraints can ask for /hydrostatics/volume_m3"});
  if (mistakes.size() > before || std::isnan(hold.displacement) || !in_range(c.bow)) return;
  const double own = bow_displacement(c.bow);
  if (std::abs(own - hold.displacement) <= kept * hold.displacement) return;
  const Key& key = *find_key("bow", hold.by);
  mistakes.push_back({"/hold/displacement_m3",
                      "is " + brief(hold.displacement) + " m3, which this bow has with no " + hold.by +
                          " from " + range_in_words(key, units_of(key.quantity).front()) + ": it displaces " +
                          brief(own) + " m3 with " + brief(held_value(c.bow, hold)) +
                          " m; give another displacement, another dimension in /hold/by, or nearer angles"});
}

std::string hold_in_words(const Json& document) {
  if (!has_hold(document)) return "";
  Mistakes mistakes;
  const Hold hold = read_hold(document, mistakes);
  return "the displacement is held at " + text("%.10g", hold.displacement) + " m3 by " +
         held_pointer(document);
}

}  // namespace icebow
