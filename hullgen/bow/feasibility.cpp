#include "hullgen/bow/feasibility.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/text.h"
#include "base/units.h"
#include "hullgen/bow/advice.h"
#include "hullgen/bow/bow_surface.h"
#include "hullgen/bow/centre_margins.h"
#include "hullgen/bow/dimensions.h"
#include "hullgen/bow/feature_margins.h"

namespace icebow {
namespace {

constexpr double straight = 1e-9;  // relative difference of two cotangents that are meant to be the same

// "flare angle from 33.0 to at least 41.2 deg", or the waterline angle at B/4 where that is what was given:
// what makes c1 at most (raise) or at least (lower) the limit.
std::string flare_at_limit(const BowParameters& bow, const BowSurface& b, double limit_c1, bool raise) {
  const bool flare = bow.angles_at == AnglesAt::stem_and_quarter_beam;
  const double now = flare ? degrees(bow.angles.flare) : to_deg(b.c1);
  const double limit = to_deg(flare ? limit_c1 / b.c_buttock : limit_c1);
  return text("%s angle from %.2f to at %s %.2f deg", flare ? "flare" : "waterline (B/4)", now,
              raise ? "least" : "most", raise ? at_least(limit) : at_most(limit));
}
std::string or_more_flare(const BowParameters& bow, const BowSurface& b, double largest_c1) {
  return largest_c1 <= 0.0 ? "" : ", or raise the " + flare_at_limit(bow, b, largest_c1, true);
}

std::string longer_bow(const BowParameters& bow, const BowSurface& b, double shortfall, double largest_c1) {
  return text(": raise the bow length Lf by %.2f m to at least %.2f m", at_least(shortfall),
              at_least(bow.Lf + shortfall)) +
         or_more_flare(bow, b, largest_c1);
}

// g1 where side edges lead: w'(B/2) <= 0, so that at every station the edge lies below the middle.
Margin leading_side_edge(const BowParameters& bow, const BowSurface& b) {
  const double longest_bow = b.half_beam() / 4.0 * (b.c0 + 2.0 * b.c1);
  Margin g{"g1", longest_bow - b.Lf, true, ""};
  if (g.value >= 0.0) {
    g.sentence = text("the side edges lie %.2f m below the middle", (b.longest() - b.Lf) / b.c_buttock);
    return g;
  }
  g.sentence = text(
      "the side edges would lie above the middle, because the bow is too long for its angles: lower the bow "
      "length Lf by %.2f m to at most %.2f m",
      at_least(-g.value), at_most(longest_bow - b.setback));
  g.sentence += ", or lower the " + flare_at_limit(bow, b, 0.5 * (4.0 * b.Lf / b.half_beam() - b.c0), false) +
                ", or choose the family thyssen_waas";
  return g;
}

// g1: w'(B/2) >= 0 without fairing.
Margin monotone_waterline(const BowParameters& bow, const BowSurface& b) {
  Margin g{"g1", b.Lf - b.half_beam() / 4.0 * (b.c0 + 2.0 * b.c1), true, ""};
  g.sentence = g.value >= 0.0
                   ? "the design waterline widens all the way to the shoulder"
                   : "the design waterline would turn back before the shoulder, because the bow is too short "
                     "for its angles" +
                         longer_bow(bow, b, -g.value, 0.5 * (4.0 * b.Lf / b.half_beam() - b.c0));
  return g;
}

// g2: w'' >= 0 aft of B/4 (first term) and before it (second term).
Margin convex_waterline(const BowParameters& bow, const BowSurface& b) {
  const double aft = b.Lf - b.half_beam() / 4.0 * (b.c0 + 3.0 * b.c1);
  double fore = b.c1 - b.c0;
  if (std::abs(fore) < straight * b.c1) fore = 0.0;  // one waterline angle at both points, up to rounding
  Margin g{"g2", std::min(aft, fore), family_form(bow.family).convex_required, ""};
  if (g.value >= 0.0) {
    g.sentence = "the design waterline is convex";
  } else if (aft <= fore) {
    g.sentence = "the design waterline is hollow aft of B/4, because the bow is too short for its angles" +
                 longer_bow(bow, b, -aft, (4.0 * b.Lf / b.half_beam() - b.c0) / 3.0);
  } else {
    g.sentence = text(
        "the design waterline is hollow between stem and B/4, because it is blunter at B/4 (%.2f deg, from "
        "flare and buttock) than at the stem (%.2f deg): raise the waterline angle to at least %.2f deg, or "
        "lower the ",
        to_deg(b.c1), degrees(bow.angles.waterline), at_least(to_deg(b.c1)));
    g.sentence += flare_at_limit(bow, b, b.c0, false);
  }
  return g;
}

double narrowest_at_stem(const BowParameters& bow, const BowSurface& b) {
  return std::min(b.entrance(-bow.T), b.entrance(bow.D - bow.T));
}

// The waterline angle at which g3 holds, others as they are [deg]. A rounded stem moves the fan with it.
double entrance_at_limit(const BowParameters& bow, const BowSurface& b, double sharp) {
  if (b.stem_half_width == 0.0) return sharp;
  BowParameters tried = bow;
  double holds = radians(1.0), fails = bow.angles.waterline;
  for (int k = 0; k < 40; ++k) {
    tried.angles.waterline = 0.5 * (holds + fails);
    (narrowest_at_stem(tried, bow_surface(tried)) >= 0.0 ? holds : fails) = tried.angles.waterline;
  }
  return degrees(holds);
}

// g3: dS/deta >= 0 at the stem at every height; S' is linear in eta up to B/4, where it is c1 > 0.
Margin monotone_at_every_depth(const BowParameters& bow, const BowSurface& b) {
  const double dc = b.c_buttock - b.c_stem;
  const double depth = b.fan_run(-bow.T), height = -b.fan_run(bow.D - bow.T);  // T*, H*
  Margin g{"g3", b.c0 - 4.0 / b.half_beam() * std::max(-dc * depth, dc * height), true, ""};
  if (g.value >= 0.0) {
    g.sentence = "every waterline, from keel to deck, widens from the stem on";
    return g;
  }
  const bool below = dc < 0.0;
  const double reach = below ? depth : height, change = b.half_beam() * b.c0 / (4.0 * reach);
  const double cotangent = b.c_buttock + (below ? change : -change);  // the stem's, at the limit
  const double shown = to_deg(shown_stem(b, cotangent)), stem = below ? at_least(shown) : at_most(shown);
  const double entrance =
      at_most(entrance_at_limit(bow, b, to_deg(4.0 / b.half_beam() * reach * std::abs(dc))));
  g.sentence = text(
      "waterlines %s the design waterline would turn back at the stem, because the stem (%.2f deg) is too "
      "%s beside the buttocks (%.2f deg): %s the stem angle to at %s %.2f deg, or lower the waterline angle "
      "from %.2f to at most %.2f deg",
      below ? "below" : "above", degrees(bow.angles.stem), below ? "flat" : "steep",
      degrees(bow.angles.buttock), below ? "raise" : "lower", below ? "least" : "most", stem,
      degrees(bow.angles.waterline), entrance);
  return g;
}

// g4: the part of w' aft of B/4 that fairing cannot help stays positive. By the choice of K it fails only
// with g1, whose opposite side edges ask for.
Margin monotone_fairing(const BowParameters& bow, const BowSurface& b) {
  const double value = b.c1 + b.e;
  if (!family_form(bow.family).monotone)
    return {"g4", value, false, "below 0 where the waterline comes forward to the side edge"};
  return {"g4", value, true,
          value >= 0.0 ? text("the shoulder fairing (K = %.3f) leaves the waterline monotone", b.K)
                       : "the shoulder would need more length than the bow has: see g1"};
}

// g5: the underwater shell ends before midship.
Margin length_for_the_shell(const BowParameters& bow, const BowSurface& b) {
  const double keel = b.run(-bow.T), fixed = b.longest() - b.setback + b.bilge + b.reamer;
  const double needed = fixed + keel * b.c_buttock, available = bow.L / 2.0;
  Margin g{"g5", available - needed, true, ""};
  if (g.value >= 0.0) {
    g.sentence = text("the underwater shell needs %.2f m of the %.2f m forebody", needed, available);
    return g;
  }
  const double cotangent = (available - fixed) / keel;
  g.sentence = text(
      "the underwater shell (%.2f m from stem to the end of the bilge) does not fit the forebody (L/2 = %.2f "
      "m): "
      "raise L by %.2f m",
      needed, available, at_least(-2.0 * g.value));
  if (cotangent > 0.0)
    g.sentence += text(", or raise the buttock angle from %.2f to at least %.2f deg",
                       degrees(bow.angles.buttock), at_least(to_deg(cotangent)));
  return g;
}

// -1 and the reason for all margins that cannot be computed: six margins always, in the same order.
std::vector<Margin> not_computed(const BowParameters& bow, const Margin& ranges) {
  const bool convex_required = family_form(bow.family).convex_required;
  std::vector<Margin> margins;
  for (const char* name : {"g1", "g2", "g3", "g4", "g5"})
    margins.push_back({name, -1.0, name[1] != '2' || convex_required, "not computed: see g6"});
  margins.push_back(ranges);
  const FamilyForm& form = family_form(bow.family);
  if (form.reamers || form.chines) margins.push_back({"g7", -1.0, true, "not computed: see g6"});
  for (Margin& g : centre_margins(bow, nullptr)) margins.push_back(std::move(g));
  return margins;
}

// The violated ones in words. g4 repeats g1, so it is left out where g1 is violated as well.
std::string reason(const std::vector<Margin>& margins) {
  std::string words;
  for (const Margin& g : margins) {
    const bool repeats = g.sentence.find(": see g") != std::string::npos;
    if (!g.required || g.value >= 0.0 || repeats) continue;
    words += (words.empty() ? "" : "; ") + g.sentence + text(" (%s = %.3g)", g.name.c_str(), g.value);
  }
  return words;
}

}  // namespace

BowFeasibility check_feasibility(const BowParameters& bow) {
  const AngleRange angles = angle_range(bow.angles);
  const std::string problem = dimension_problem(bow);
  const Margin ranges = problem.empty() ? Margin{"g6", angles.margin, true, angles.sentence}
                                        : Margin{"g6", -1.0, true, problem};
  BowFeasibility result;
  if (ranges.value < 0.0) {
    result.margins = not_computed(bow, ranges);
  } else {
    const BowSurface b = bow_surface(bow);
    const FamilyForm& form = family_form(bow.family);
    result.margins = {form.monotone ? monotone_waterline(bow, b) : leading_side_edge(bow, b),
                      convex_waterline(bow, b),
                      monotone_at_every_depth(bow, b),
                      monotone_fairing(bow, b),
                      length_for_the_shell(bow, b),
                      ranges};
    if (form.reamers) result.margins.push_back(reamer_size(bow));
    if (form.chines) result.margins.push_back(chine_crease(b));
    for (Margin& g : centre_margins(bow, &b)) result.margins.push_back(std::move(g));
  }
  result.feasible = std::all_of(result.margins.begin(), result.margins.end(),
                                [](const Margin& g) { return !g.required || g.value >= 0.0; });
  result.reason = reason(result.margins);
  return result;
}

}  // namespace icebow
