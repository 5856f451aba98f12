#include "hullgen/bow/feature_margins.h"

#include <algorithm>

#include "base/text.h"
#include "base/units.h"
#include "hullgen/bow/advice.h"
#include "hullgen/bow/bow_mesh.h"

namespace icebow {
namespace {

constexpr double thinnest_step = 0.25;            // of a panel: below, the quads on the step are splinters
constexpr double largest_step = 0.1;              // of the beam
constexpr double smallest_crease = radians(3.0);  // less is a smooth waterline by its looks

}  // namespace

Margin reamer_size(const BowParameters& bow) {
  const double least = thinnest_step * panel_size(bow), most = largest_step * bow.B, step = bow.reamer_step;
  Margin g{"g7", std::min(step - least, most - step), true, ""};
  if (g.value >= 0.0)
    g.sentence = text("the bow is %.2f m wider than the ship on either side", step);
  else if (step < least)
    g.sentence = text(
        "the reamer step of %.3f m is too small for panels of %.3f m: raise it to at least %.3f m, "
        "or lower the panel size to at most %.3f m",
        step, panel_size(bow), least, step / thinnest_step);
  else
    g.sentence = text("the reamer step of %.2f m is more than %g B: lower it by %.2f m to at most %.2f m",
                      step, largest_step, at_least(step - most), at_most(most));
  return g;
}

Margin chine_crease(const BowSurface& b) {
  const double spare = (b.Lf - b.s1) / b.yq - b.c1;
  const double crease = acot(b.c1) - acot(b.c1 + knuckle_share * spare / (1.0 - b.chine));
  Margin g{"g7", crease - smallest_crease, true, ""};
  if (g.value >= 0.0) {
    g.sentence = text("the waterline turns by %.2f deg at the chine", degrees(crease));
    return g;
  }
  g.sentence = text("the waterline turns by %.2f deg at the chine, less than %.0f deg: no crease",
                    degrees(crease), degrees(smallest_crease));
  if (acot(b.c1) <= smallest_crease) return g.sentence += ": raise the flare angle", g;
  const double jump = cot(acot(b.c1) - smallest_crease) - b.c1;
  const double missing = b.yq * ((1.0 - b.chine) * jump / knuckle_share - spare);
  const double chine = 1.0 - 0.5 * knuckle_share * spare / jump;
  g.sentence += text(": raise the bow length Lf by %.2f m to at least %.2f m", at_least(missing),
                     at_least(b.Lf - b.setback + missing));
  if (spare > 0.0 && at_least(chine) <= outermost_chine)
    g.sentence += text(", or move the chine outwards to at least %.2f of the half-beam", at_least(chine));
  return g;
}

}  // namespace icebow
