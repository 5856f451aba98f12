#include "hullgen/bow/dimensions.h"

#include <algorithm>
#include <cmath>

#include "base/text.h"
#include "base/units.h"
#include "hullgen/bow/family.h"

namespace icebow {
namespace {

constexpr double coarsest_panel = 1.0 / 8.0, finest_panel = 1.0 / 400.0;  // of the beam
constexpr double flattest_end = 10.0,
                 steepest_end = 80.0;  // of ice knife and skeg, against the horizontal [deg]
constexpr double belt_share = 0.9;     // of the straight height below and above the design waterline

struct Named {
  const char* name;
  double value;
};

std::string not_a_length(const BowParameters& bow) {
  for (const Named& n : {Named{"length L", bow.L},
                         {"beam B", bow.B},
                         {"draught T", bow.T},
                         {"depth D", bow.D},
                         {"bow length Lf", bow.Lf},
                         {"reach of the ice belt below the design waterline", bow.belt_below},
                         {"reach of the ice belt above the design waterline", bow.belt_above}}) {
    if (!std::isfinite(n.value)) return text("%s is not a finite number: give it in metres", n.name);
    if (n.value <= 0.0) return text("%s is %g m: it must be positive", n.name, n.value);
  }
  return std::isfinite(bow.panel)
             ? ""
             : "panel size is not a finite number: give it in metres, or leave it out for B/60";
}

std::string bad_panel(const BowParameters& bow) {
  const double largest = coarsest_panel * bow.B, smallest = finest_panel * bow.B;
  if (bow.panel == 0.0 || (bow.panel >= smallest && bow.panel <= largest)) return "";
  return text("panel size %g m is outside %.3g to %.3g m (B/400 to B/8): %s it, or leave it out for B/60",
              bow.panel, smallest, largest, bow.panel < smallest ? "raise" : "lower");
}

std::string bad_belt(const BowParameters& bow) {
  const double below = belt_share * (bow.T - std::min(bow.T / 4.0, bow_beam(bow) / 8.0));
  const double above = belt_share * (bow.D - bow.T);
  if (bow.belt_below > below)
    return text(
        "the ice belt reaches %.2f m below the design waterline, into the rounding of the bilge: raise the "
        "draught "
        "T (%.2f m) or lower the belt's reach to at most %.2f m",
        bow.belt_below, bow.T, below);
  if (bow.belt_above > above)
    return text(
        "the ice belt reaches %.2f m above the design waterline and leaves no room below the deck: raise the "
        "depth D (%.2f m) to at least %.2f m or lower the belt's reach to at most %.2f m",
        bow.belt_above, bow.D, bow.T + bow.belt_above / belt_share, above);
  return "";
}

std::string bad_feature(const BowParameters& bow) {
  if (family_form(bow.family).reamers && !(std::isfinite(bow.reamer_step) && bow.reamer_step > 0.0))
    return text("the reamer step is %g m: it must be positive, usually %g m (%g B)", bow.reamer_step,
                usual_reamer_step * bow.B, usual_reamer_step);
  if (family_form(bow.family).chines && !(bow.chine >= innermost_chine && bow.chine <= outermost_chine))
    return text("the chine at %g of the half-beam is outside %g to %g: move it, usually to %g", bow.chine,
                innermost_chine, outermost_chine, usual_chine);
  return "";
}

std::string bad_centre(const BowParameters& bow) {
  const CentrePlane& c = bow.centre;
  for (const Named& n : {Named{"stem radius", c.stem_radius},
                         {"height of the ice knife", c.knife_height},
                         {"width of the ice knife", c.knife_width},
                         {"height of the skeg", c.skeg_height},
                         {"length of the skeg", c.skeg_length},
                         {"width of the skeg", c.skeg_width}})
    if (!(std::isfinite(n.value) && n.value >= 0.0))
      return text("%s is %g m: it must be 0, for none, or positive", n.name, n.value);
  const auto outside = [](double angle, double steepest) {
    return !(angle >= radians(flattest_end) - 1e-9 && angle <= radians(steepest) + 1e-9);
  };
  if (outside(c.knife_angle, 90.0))
    return text("the ice knife's edge at %g deg is outside %g to 90 deg", degrees(c.knife_angle),
                flattest_end);
  if (outside(c.skeg_angle, steepest_end))
    return text("the skeg's ends at %g deg are outside %g to %g deg", degrees(c.skeg_angle), flattest_end,
                steepest_end);
  return "";
}

}  // namespace

std::string dimension_problem(const BowParameters& bow) {
  std::string problem = not_a_length(bow);
  if (problem.empty() && bow.D <= bow.T)
    problem = text("depth D (%.2f m) must exceed the draught T (%.2f m): raise D or lower T", bow.D, bow.T);
  if (problem.empty()) problem = bad_panel(bow);
  if (problem.empty()) problem = bad_feature(bow);
  if (problem.empty()) problem = bad_belt(bow);
  if (problem.empty()) problem = bad_centre(bow);
  return problem;
}

AngleRange angle_range(const BowAngles& angles) {
  const double one = radians(1.0), right = radians(90.0);
  struct Allowed {
    const char* name;
    double value, lower, upper;
  };
  AngleRange nearest{right, ""};
  for (const Allowed& r : {Allowed{"stem", angles.stem, one, right - one},
                           {"waterline", angles.waterline, one, right},
                           {"buttock", angles.buttock, one, right - one},
                           {"flare", angles.flare, one, right - one}}) {
    if (!std::isfinite(r.value))
      return {-1.0, text("the %s angle is not a finite number: give it in degrees", r.name)};
    const double margin = std::min(r.value - r.lower, r.upper - r.value);
    if (margin >= nearest.margin) continue;
    nearest.margin = margin;
    const bool low = r.value < r.lower;
    nearest.sentence = margin >= 0.0
                           ? text("all angles in range (%s angle nearest to its end)", r.name)
                           : text("the %s angle %.2f deg is outside %.0f to %.0f deg: %s it by %.2f deg",
                                  r.name, degrees(r.value), degrees(r.lower), degrees(r.upper),
                                  low ? "raise" : "lower", -degrees(margin));
  }
  return nearest;
}

}  // namespace icebow
