// The surface of a bow as a graph over its body plan, s = S(eta, z); equations (1) to (8) and
// (11), (12) of docs/bows.md.
//
// Notation: s [m] aft of the stem at the design waterline (x = -s), z [m] up from the design waterline, eta
// in [0, half_beam()] is the half-breadth y wherever the section is wall-sided; in the rounded bilge y = eta
// half_breadth(z) / half_beam(). F: run of a buttock per unit cotangent, from the design waterline (positive
// below, negative above); fan: the same run for what makes the stem differ from the other buttocks.
#pragma once

#include "hullgen/bow/family.h"

namespace icebow {

constexpr double knuckle_share =
    0.5;  // of the length a straight waterline leaves over: to the chine's crease

double cot(double angle);
double acot(double cotangent);  // in (0, pi)

// Every constant of the form. Needs dimensions and angles in range: see check_feasibility.
struct BowSurface {
  double yq;                 //!< quarter of the bow's beam [m], where flare and buttock are measured
  double Lf, T, D;           //!< [m]
  double c_stem, c_buttock;  // cotangents of stem and buttock angle
  double c_deck;             // cotangent of the buttocks' angle at the deck edge
  double c0, c1;             // cotangents of the waterline angle at the stem and at B/4
  double s1;                 //!< s of the design waterline at B/4 [m]
  double K;                  // shoulder fairing
  double fairing_from, fairing_power;  // of K: t where it begins, n
  double chine;                        // t of the crease; 0 where there is none
  double J;                            // jump of the waterline's cotangent at the crease
  double e;                            // curvature of the design waterline aft of B/4
  double bilge;                        //!< bilge radius, also length of the forefoot's rounding [m]
  double belt_below, belt_above;       //!< [m]
  double deck_fade;  //!< height over which the buttocks turn from their angle to the deck's [m]
  double fan_fade;   //!< depth over which the fan fades out below the belt [m]; infinite for a straight stem

  double forefoot_slope;  // cotangent of the buttocks at the upper end of the bilge over that in the belt
  double forefoot_fade;   //!< depth over which it changes [m]
  double reamer;          //!< the bow is wider than the ship by this on either side [m]

  // In the centre plane; 0: none. Lf and s above count from the edge in which the sides would meet at the
  // design waterline, and s() from the rounded stem's nose there, `setback` behind that edge.
  double stem_half_width = 0.0;                    //!< eta up to which the stem is rounded [m]
  double setback = 0.0;                            //!< [m]
  double knife_half_width = 0.0, knife_top = 0.0;  //!< eta of its root, z of its upper end [m]
  double knife_cotangent = 0.0;                    // of its edge
  double knife_from = 0.0;                         //!< s of the stem at its upper end [m]

  double half_beam() const { return 2.0 * yq; }      // of the bow
  double longest() const;                            //!< w of the aftmost point of the design waterline [m]
  double entrance(double z) const;                   // cotangent of the sharp waterline at the centre plane
  double stem_rounding(double eta, double z) const;  //!< how far the rounding lies behind the sharp stem [m]
  double knife(double eta, double z) const;          //!< how far the ice knife stands ahead of the bow [m]
  double waterline(double eta) const;                // w [m]
  double buttock_cotangent(double eta) const;        // c
  double run(double z) const;                        // F [m]
  double fan_run(double z) const;                    // Phi [m]
  double deck_run(double z) const;                   // G [m]
  double forefoot(double z) const;                   // b [m]
  double half_breadth(double z) const;               //!< largest half-breadth at this height [m]
  double s_without_knife(double eta, double z) const;  //!< [m]
  double s(double eta, double z) const;                // S [m]
  Vec3 point(double eta, double z) const;              // port side, hull frame
};

BowSurface bow_surface(const BowParameters& bow);

double stem_half_width(const BowParameters& bow);   //!< eta up to which the stem is rounded [m]
double knife_half_width(const BowParameters& bow);  //!< eta of its root; 0 where there is no ice knife [m]
double skeg_half_width(const BowParameters& bow);   //!< eta of its root; 0 where there is no skeg [m]
double bottom_share(const BowParameters& bow);      // y over eta on the flat bottom, behind reamers
// cot of the stem angle that a bow shows whose sharp stem has this cotangent; the sharp one is what the fan
// of buttocks (5) takes.
double shown_stem(const BowSurface& bow, double sharp);

}  // namespace icebow
