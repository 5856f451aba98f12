// The families of icebreaker bows: what tells one form from another, the usual ranges of its angles, and one
// bow of each to start from. Pictures, equations and sources: docs/bows.md.
#pragma once

#include <string>
#include <vector>

#include "hullgen/bow/bow.h"

namespace icebow {

constexpr double usual_reamer_step = 0.03;  // of the beam B
constexpr double usual_chine = 0.8;         // of the half-beam, from B/4 outwards and clear of the side:
constexpr double innermost_chine = 0.55, outermost_chine = 0.95;

struct Range {
  double lower, upper;
};

// General knowledge of the field, not limits of the program.
struct FamilyRanges {
  Range stem, waterline, buttock, flare;  //!< [rad]
  Range bow_length;                       // Lf over the beam of the bow
};

struct FamilyForm {
  const char* key;       // as in a study file
  const char* name;      // as in drawings
  bool monotone;         // every waterline widens up to the shoulder; otherwise the side edges lead
  bool convex_required;  // a hollow design waterline is refused
  bool faired_shoulder;  // the waterline runs tangentially into the side; otherwise a chine
  double fairing_from;   // t of (4) where the fairing begins, at the chine where there is one
  double fairing_power;  // n of (4): 2 is a quarter of an ellipse
  bool straight_stem;    // the fan of buttocks acts down to the keel; otherwise it fades out below the belt
  double
      forefoot_slope;  // cotangent of the buttocks at the keel over that in the belt: < 1 hollow, > 1 round
  double deck_angle;   //!< buttocks against the horizontal at the deck edge, at most [rad]
  bool reamers;        // the bow is wider than the ship by a step on either side
  bool chines;         // a crease runs down the bow outboard of B/4
  bool graded_by_curvature;  // panels shrink where the surface turns; not the two published bows, whose
                             // meshes are those their loads were computed with
  FamilyRanges ranges;
};

const FamilyForm& family_form(BowFamily family);
const std::vector<BowFamily>& all_families();
// "spoon_reamers", ... as a study file's choices, in the order of all_families().
std::vector<std::string> family_keys();
// The family of a key; the first one where there is no such key.
BowFamily family_of_key(const std::string& key);

// A feasible bow with angles from the middle of the family's ranges; the published one where there is one.
BowParameters preset_bow(BowFamily family);

// Beam of the bow: B, or B and both reamer steps where the family has them [m]. P1 is at a quarter of it.
double bow_beam(const BowParameters& bow);
double reamer_step(const BowParameters& bow);  //!< 0 where the family has none [m]

}  // namespace icebow
