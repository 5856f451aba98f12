#include "cli/cycle_text.h"

#include <cmath>

#include "base/units.h"
#include "cli/text_table.h"
#include "study/spec/spec_hints.h"

namespace icebow {
namespace {

std::string kilonewtons(double newtons) {
  return decimals(newtons / 1e3, 1);
}

const char* rule_in_words(cycle::Breaking rule) {
  if (rule == cycle::Breaking::plate) return "by plate theory";
  return rule == cycle::Breaking::calibrated ? "by patch tests of this ice" : "by the literature";
}

}  // namespace

std::string cycle_text(const CycleOutcome& o, const Case& c, const std::string& design) {
  const double l = cycle_ice(c).characteristic_length();
  std::string text = design + ": breaking cycle, full scale, ice " + brief(c.ice.h) + " m, " + brief(c.V) +
                     " m/s (" + brief(c.V / metres_per_second_per_knot) + " kn), flexural strength " +
                     brief(c.flexural_strength / 1e3) + " kPa, crushing pressure " +
                     brief(c.cycle.crushing_pressure / 1e3) + " kPa, friction " + brief(c.numerics.friction) +
                     ", edges break " + rule_in_words(c.cycle.rule.type) + "\n\n";
  text += text_table({{"part", "kN"},
                      {"crushing", kilonewtons(o.crushing)},
                      {"bending", kilonewtons(o.bending)},
                      {"friction", kilonewtons(o.friction)},
                      {"submersion", kilonewtons(o.submersion)},
                      {"water", kilonewtons(o.water)},
                      {"mean load", kilonewtons(o.mean)}});
  text += "95 % interval \u00b1 " + kilonewtons(o.ci95) + " kN, from " + std::to_string(c.cycle.voyages) +
          " voyages of " + brief(c.cycle.voyage) + " m (" + kilonewtons(o.series) + " from their records";
  if (std::isfinite(o.voyages)) text += ", " + kilonewtons(o.voyages) + " from their scatter";
  text += ")\n";
  if (o.pieces == 0) return text + "No edge ever broke: the hull crushes its way.\n";
  text += "pieces " + decimals(o.breaking_length, 2) + " m long = " + decimals(o.breaking_length / l, 2) +
          " l, contacts " + decimals(o.contact_width, 2) + " m wide, channel " +
          decimals(o.channel_width, 1) + " m = " + decimals(o.channel_width / c.bow.B, 2) + " B\n";
  return text;
}

}  // namespace icebow
