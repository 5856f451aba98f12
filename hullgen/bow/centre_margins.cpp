#include "hullgen/bow/centre_margins.h"

#include <algorithm>
#include <cmath>

#include "base/text.h"
#include "base/units.h"
#include "hullgen/bow/advice.h"
#include "hullgen/bow/bow_mesh.h"
#include "hullgen/bow/skeg.h"

namespace icebow {
namespace {

constexpr double narrowest = 0.05;        // half width over a panel: below, panels are splinters
constexpr double widest_rounding = 0.05;  // half width over the bow's beam: the angles are read outside it
constexpr double widest_fin = 0.1;        // breadth over the beam
constexpr double lowest_fin = 0.25;       // height over a panel
constexpr double deepest_skeg = 0.5;      // height over the draught

// One of the inequalities behind a margin, and what to change where it is violated.
struct Limit {
  double value;  //!< [m]
  std::string sentence;
};

Margin least(const char* name, const std::vector<Limit>& limits, const std::string& satisfied) {
  const auto worst = std::min_element(limits.begin(), limits.end(),
                                      [](const Limit& a, const Limit& b) { return a.value < b.value; });
  return {name, worst->value, true, worst->value >= 0.0 ? satisfied : worst->sentence};
}

// Upwards and downwards to millimetres, for fins are small.
double mm_up(double metres) {
  return std::ceil(metres * 1000.0 - 1e-9) / 1000.0;
}
double mm_down(double metres) {
  return std::floor(metres * 1000.0 + 1e-9) / 1000.0;
}

Margin stem_radius(const BowParameters& bow, const BowSurface& b) {
  const double panel = panel_size(bow), radius = bow.centre.stem_radius, half = stem_half_width(bow);
  const double cosine = std::cos(bow.angles.waterline), most = widest_rounding * 2.0 * b.half_beam();
  std::string narrow = text(
      "the stem radius of %.3f m rounds %.4f m on either side of the centre plane, too little for panels of "
      "%.3f m: ",
      radius, half, panel);
  const double needed = narrowest * panel / std::max(cosine, 1e-9);
  narrow += needed < most / std::max(cosine, 1e-9) && cosine > 0.01
                ? text("raise the stem radius to at least %.3f m, or leave it out", mm_up(needed))
                : text("leave it out: a waterline angle of %.2f deg has no edge to round",
                       degrees(bow.angles.waterline));
  return least(
      "g8",
      {{half - narrowest * panel, narrow},
       {most - half,
        text("the stem radius of %.3f m rounds %.3f m on either side of the centre plane, more than "
             "a twentieth of the beam: lower the stem radius to at most %.3f m",
             radius, half, mm_down(most / cosine))}},
      text("the stem is rounded %.3f m on either side of the centre plane, its nose %.3f m behind the edge",
           half, b.setback));
}

// A fin of this half width; `across` is y over the eta its columns go by.
Limit too_narrow(const BowParameters& bow, const char* what, double half, double across) {
  const double limit = across * narrowest * panel_size(bow);
  return {half - limit,
          text("the %s is %.3f m wide, too narrow for panels of %.3f m: raise its width to at least "
               "%.3f m",
               what, 2.0 * half, panel_size(bow), mm_up(2.0 * limit))};
}
Limit too_wide(const BowParameters& bow, const char* what, double half) {
  const double most = widest_fin * bow.B;
  return {0.5 * most - half,
          text("the %s is %.3f m wide, more than a tenth of the beam: lower its width to at most "
               "%.3f m",
               what, 2.0 * half, mm_down(most))};
}
Limit too_low(const BowParameters& bow, const char* what, double height) {
  const double lowest = lowest_fin * panel_size(bow);
  return {height - lowest,
          text("the %s is %.3f m high, too low for panels of %.3f m: raise its height to at least "
               "%.3f m",
               what, height, panel_size(bow), mm_up(lowest))};
}

// Two edges of columns beside each other leave a splinter between them.
Limit beside(const BowParameters& bow, const char* what, double half, const char* other, double other_half,
             double across) {
  other_half *= across;
  const double apart = std::abs(half - other_half), least_apart = across * narrowest * panel_size(bow);
  const bool fine = other_half == 0.0 || apart < 1e-9 * bow.B;
  return {fine ? bow.B : apart - least_apart, text("the %s is %.3f m wide and the %s %.3f m, which leaves "
                                                   "panels of %.4f m between: make the %s at least "
                                                   "%.3f m wide, or leave its width out",
                                                   what, 2.0 * half, other, 2.0 * other_half, apart, what,
                                                   mm_up(2.0 * (other_half + least_apart)))};
}

// The edge of the knife stays ahead of the stem: steepest slope from its top to a point of the stem below.
Limit ahead_of_stem(const BowParameters& bow, const BowSurface& b) {
  constexpr int samples = 100;
  const double height = bow.centre.knife_height;
  double flattest = 1e300;  // cotangent that the edge may have
  for (int k = 1; k <= samples; ++k) {
    const double z = b.knife_top - height * k / samples;
    flattest = std::min(flattest, (b.s_without_knife(0.0, z) - b.knife_from) / (b.knife_top - z));
  }
  return {
      height * (flattest - b.knife_cotangent),
      text("the ice knife's edge at %.2f deg would run inside the stem: raise its angle to at least %.2f deg",
           degrees(bow.centre.knife_angle), at_least(to_deg(flattest)))};
}

Margin ice_knife(const BowParameters& bow, const BowSurface& b) {
  const double half = knife_half_width(bow), height = bow.centre.knife_height;
  const double room = bow.T - bow.belt_below;
  return least(
      "g9",
      {{room - height, text("the ice knife of %.2f m reaches into the ice belt: lower its height to at "
                            "most %.2f m, or let the belt reach less far down",
                            height, at_most(room))},
       ahead_of_stem(bow, b),
       too_low(bow, "ice knife", height),
       too_narrow(bow, "ice knife", half, 1.0),
       too_wide(bow, "ice knife", half),
       beside(bow, "ice knife", half, "stem bar", stem_half_width(bow), 1.0)},
      text("the ice knife stands %.2f m ahead of the forefoot at the keel", b.knife(0.0, -bow.T)));
}

Margin skeg(const BowParameters& bow, const BowSurface& b) {
  const CentrePlane& c = bow.centre;
  const double across = bottom_share(bow), half = across * skeg_half_width(bow),
               ends = 2.0 * c.skeg_height * cot(c.skeg_angle);
  const double room = bow.L - b.s(0.0, -bow.T) - b.reamer;
  return least(
      "g10",
      {{c.skeg_length - ends, text("the skeg is %.2f m long, shorter than its two ends at %.2f deg: raise "
                                   "its length to at least %.2f m",
                                   c.skeg_length, degrees(c.skeg_angle), at_least(ends))},
       {room - c.skeg_length, text("the skeg is %.2f m long, the bottom %.2f m: lower its length to at most "
                                   "%.2f m",
                                   c.skeg_length, room, at_most(room))},
       {deepest_skeg * bow.T - c.skeg_height,
        text("the skeg is %.2f m high, more than half the draught: lower its height to at most %.2f m",
             c.skeg_height, at_most(deepest_skeg * bow.T))},
       too_low(bow, "skeg", c.skeg_height),
       too_narrow(bow, "skeg", half, across),
       too_wide(bow, "skeg", half),
       beside(bow, "skeg", half, "stem bar", stem_half_width(bow), across),
       beside(bow, "skeg", half, "ice knife", knife_half_width(bow), across)},
      text("the skeg reaches %.2f m below the bottom", c.skeg_height));
}

}  // namespace

std::vector<Margin> centre_margins(const BowParameters& bow, const BowSurface* surface) {
  std::vector<Margin> margins;
  const auto add = [&](const char* name, double size,
                       Margin (*margin)(const BowParameters&, const BowSurface&)) {
    if (size == 0.0) return;
    margins.push_back(surface ? margin(bow, *surface) : Margin{name, -1.0, true, "not computed: see g6"});
  };
  add("g8", bow.centre.stem_radius, stem_radius);
  add("g9", bow.centre.knife_height, ice_knife);
  add("g10", bow.centre.skeg_height, skeg);
  return margins;
}

}  // namespace icebow
