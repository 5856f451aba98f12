// A bow from its angles: parameters, feasibility and the closed quad hull.
//
// Angles in radians. Stem angle: profile against the horizontal at the stem; waterline angle: entrance
// against the centre plane at the stem; buttock angle: against the horizontal at y = B/4; flare angle: from
// the vertical at y = B/4. The first two belong to P0 = (y = 0, design waterline), the last two to P1 = (y =
// B/4, design waterline).
#pragma once

#include <string>
#include <vector>

#include "base/units.h"
#include "geometry/quad_mesh.h"

namespace icebow {

// What each is: hullgen/bow/family.h. Stored results know a family by its number: new ones go to the end.
enum class BowFamily {
  straight_parallel_buttocks,
  thyssen_waas,
  concave,
  high_flare,
  spoon_reamers,
  semi_spoon_chines,
  flat,
  thyssen_waas_side_edges
};

// Which angles were given, so that advice names those: waterline at the stem and flare at B/4, or waterline
// at B/4, from which the flare follows.
enum class AnglesAt { stem_and_quarter_beam, quarter_beam };

struct BowAngles {
  double stem = 0.0;       //!< [rad]
  double waterline = 0.0;  //!< [rad]
  double buttock = 0.0;    //!< [rad]
  double flare = 0.0;      //!< [rad] from the vertical
};

// What stands in the centre plane of a bow of any family: equations (11) to (13) of docs/bows.md. A stem
// radius or a height of 0 means none of it; a width of 0 that of the stem bar, or B/40 where the stem is
// sharp.
struct CentrePlane {
  double stem_radius = 0.0;       //!< of the stem bar, in the design waterline [m]
  double knife_height = 0.0;      //!< of the ice knife under the forefoot, from the keel up [m]
  double knife_width = 0.0;       //!< its breadth where it meets the bow [m]
  double knife_angle = 0.5 * pi;  //!< of its edge, against the horizontal [rad]
  double skeg_height = 0.0;       //!< of the skeg, from the bottom down [m]
  double skeg_length = 0.0;       //!< from the fore end of the bottom, at its root [m]
  double skeg_width = 0.0;        //!< its breadth at its root [m]
  double skeg_angle = 0.25 * pi;  //!< of its ends, against the horizontal [rad]
};

struct BowParameters {
  BowFamily family = BowFamily::straight_parallel_buttocks;
  AnglesAt angles_at = AnglesAt::stem_and_quarter_beam;  // `angles` below are the same four either way
  BowAngles angles;
  double L = 0.0;            //!< length between perpendiculars: stem at the waterline to the transom [m]
  double B = 0.0;            //!< beam [m]
  double T = 0.0;            //!< draught [m]
  double D = 0.0;            //!< depth [m]
  double Lf = 0.0;           //!< length of the bow along the design waterline [m]
  double panel = 0.0;        //!< wanted edge length of a quad in the ice belt [m]; 0 = B/60
  double belt_below = 1.5;   //!< ice belt reaches this far below the design waterline [m]
  double belt_above = 1.0;   //!< and this far above it [m]
  double reamer_step = 0.0;  //!< the bow is wider than B by this on either side; spoon with reamers only [m]
  double chine = 0.0;        // the crease's share of the half-beam; semi-spoon with chines only
  CentrePlane centre;
};

// One feasibility inequality, written so that value >= 0 means satisfied.
struct Margin {
  std::string name;  // "g1"
  double value =
      0.0;  // [m] g1, g2, g5, g8 to g10; cotangents g3, g4; [rad] g6; g7 [m] or [rad]: docs/bows.md
  bool required = true;  // a margin that is only reported (convexity of a hollow waterline) is false
  std::string sentence;  // what it means and, where negative, which parameter to move which way
};

struct BowFeasibility {
  bool feasible = false;
  std::vector<Margin> margins;  // g1 to g6, g7 of reamers or chines, g8 of a stem radius, g9 of an ice knife,
                                // g10 of a skeg; -1 where a value cannot be computed
  std::string reason;           // the violated inequalities in words; empty where feasible
};

enum class HullStatus { ok, infeasible, mesh_rejected };

struct Hull {
  HullStatus status = HullStatus::infeasible;
  std::string reason;  // why there is no mesh
  std::string form;    // in words, for drawings: the family, or the file it comes from
  BowFeasibility feasibility;
  BowAngles requested;  // NaN: nothing asked
  QuadMesh mesh;        // closed, oriented outward, free of self-intersections where status is ok
  BowAngles measured;   // read back from the mesh
  double waterline_at_quarter_beam = 0.0;  //!< derived angle at P1 [rad]
  double flare_at_stem = 0.0;              //!< derived angle at P0 [rad]
  double stem_radius = 0.0;  //!< read back from the mesh of a generated bow; 0: a sharp stem [m]
};

}  // namespace icebow
