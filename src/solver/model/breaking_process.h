// How the ice broke, in numbers: cracks, floes, channel, load cycles, energy. Everything at the scale of the
// run; definitions in docs/theory.md, "The breaking process".
#pragma once

#include <limits>
#include <vector>

#include "solver/model/history.h"

namespace icebow {

// By the angle between the crack and the ray from the nearest place of the hull's waterline to it, as both
// were when it opened.
enum class CrackKind {
  radial,           // within 45 degrees of the ray: it runs away from the hull
  circumferential,  // across the ray
  splitting,        // radial, within 30 degrees of the course, and seen 3 characteristic lengths ahead
  crushed,          // three quarters of the bonds gone within an advance of one thickness
  secondary,        // under the hull, where the waterline had passed: floes that break once more
  held_edge         // within two thicknesses of the held part of the sheet: the edge's doing
};
constexpr int crack_kinds = 6;

struct Crack {
  CrackKind kind = CrackKind::radial;
  double opened = 0.0;  //!< advance at which its first column opened [m]
  // Its first column, in the hull's frame at that moment: ahead of the stem, to port [m].
  double x = 0.0, y = 0.0;
  double length = 0.0;        //!< of the straight line with the same second moment along its main axis [m]
  double direction = 0.0;     //!< of its main axis to the course, -pi/2 .. pi/2 [rad]
  double from_hull = 0.0;     //!< distance from the waterline, mean over its columns as they opened [m]
  double along_course = 0.0;  //!< the same, along the course; NaN where none of it is ahead of the hull [m]
  int columns = 0;
};

const char* to_string(CrackKind kind);

struct Cracks {
  std::vector<Crack> list;        // by opening
  int columns[crack_kinds] = {};  // in the cracks of each kind
  int isolated = 0;               // columns that belong to none
};

// In reference positions, where the ice was before it broke.
struct Floe {
  double area = 0.0;                 //!< volume over the sheet's thickness [m^2]
  double length = 0.0, width = 0.0;  //!< of the rectangle with the same second moments in the plane [m]
  double through = 0.0;              // its volume over that of its columns: 1 = as thick as the sheet
  double x = 0.0, y = 0.0;           //!< centre; x from the edge the ship came in by [m]
};

struct ChannelStation {
  double x = 0.0;      //!< from the edge the ship came in by [m]
  double width = 0.0;  //!< around the centre line, in which nothing stands [m]
};

// Volumes in m^3.
struct DetachedIce {
  double volume = 0.0;    // in pieces that do not stand
  double in_floes = 0.0;  // of it in pieces of at least (2h)^2 h
  double dust = 0.0;      // of it in particles that have lost every bond
  std::vector<Floe> floes;
  std::vector<ChannelStation> channel;

  double crushed() const { return volume - in_floes; }
};

struct LoadCycle {
  // The first significant peak of the autocorrelation after its first fall below zero; NaN where there is
  // none.
  double period = std::numeric_limits<double>::quiet_NaN();   //!< [s]
  double advance = std::numeric_limits<double>::quiet_NaN();  //!< per cycle [m]
  double height = std::numeric_limits<double>::quiet_NaN();   // autocorrelation there: 1 = strictly periodic
  double significant_above = std::numeric_limits<double>::quiet_NaN();  // what a peak had to exceed
  double cycles = 0.0;                                                  // periods in the record
  bool clear = false;           // there is such a peak: cycles that do not overlap beyond recognition
  double peak_over_mean = 0.0;  // largest sample
  double deviation_over_mean = 0.0;
  double without_contact = 0.0;  // share of the samples
};

// Parts of the hull's work up to the last balance; NaN where there was no work or no balance yet. They add up
// to 1 and `unexplained`.
struct EnergyShares {
  double hull_work = 0.0;  //!< [J]
  double fracture = std::numeric_limits<double>::quiet_NaN();
  double elastic = std::numeric_limits<double>::quiet_NaN();
  double kinetic = std::numeric_limits<double>::quiet_NaN();
  double potential = std::numeric_limits<double>::quiet_NaN();     // weight and lift
  double contact_loss = std::numeric_limits<double>::quiet_NaN();  // friction, inelastic impact, relocation
  // To the water that the ice moves, the ice that it meets, the damped edges.
  double water = std::numeric_limits<double>::quiet_NaN();
  double floe_contact = std::numeric_limits<double>::quiet_NaN();
  double absorbed = std::numeric_limits<double>::quiet_NaN();
  double left_astern = std::numeric_limits<double>::quiet_NaN();  // with the ice a moving window dropped
  double unexplained = std::numeric_limits<double>::quiet_NaN();  // error of the balance
};
EnergyShares energy_shares(const History& history);

// Distance from the hull to the circumferential cracks as they opened: each crack's mean, weighted by its
// columns. NaN where there is none.
struct BreakingLength {
  double normal = std::numeric_limits<double>::quiet_NaN();     //!< to the waterline's nearest place [m]
  double along = std::numeric_limits<double>::quiet_NaN();      //!< along the course [m]
  double deviation = std::numeric_limits<double>::quiet_NaN();  //!< of the first, between cracks [m]
  // Of the first: a tenth, half, nine tenths of the columns lie in cracks nearer than this [m]. The mean
  // mixes cusps with the few long cracks far ahead.
  double tenth = std::numeric_limits<double>::quiet_NaN();
  double median = std::numeric_limits<double>::quiet_NaN();
  double nine_tenths = std::numeric_limits<double>::quiet_NaN();
  int cracks = 0;
};
BreakingLength breaking_length(const std::vector<Crack>& cracks);

struct BreakingProcess {
  double thickness = 0.0, characteristic_length = 0.0;  //!< [m]
  double stem_x = 0.0;  //!< of the stem at the end, from the edge the ship came in by [m]
  Cracks cracks;
  BreakingLength breaking_length;
  DetachedIce ice;
  LoadCycle load;
  EnergyShares energy;
};

}  // namespace icebow
