// Cracks of a run from the columns that cracked: their kind, place, length and order. docs/theory.md, "The
// breaking process".
#pragma once

#include <limits>
#include <vector>

#include "geometry/hull_section.h"
#include "solver/model/breaking_process.h"
#include "solver/model/cracked_place.h"
#include "solver/watch/crack_watch.h"

namespace icebow {

struct CrackedSheet {
  Lattice lattice;                                               // of the run
  std::vector<CrackedColumn> columns;                            // of a half model those of the port half
  double thickness = 0.0;                                        //!< [m]
  double characteristic_length = 0.0;                            //!< [m]
  double held_beyond = std::numeric_limits<double>::infinity();  //!< |y| from which the sides are held [m]
  double first_touch_x = 0.0;                                    //!< of the hull's frame at advance 0 [m]
};

// Neighbouring columns (two apart at most) of one kind that opened within an advance of one thickness of each
// other form a crack; what is shorter than two thicknesses is none, but for crushed ice.
Cracks find_cracks(const CrackedSheet& sheet, const std::vector<Segment>& waterline);
// The columns of these cracks, of both halves of a half model.
std::vector<CrackedPlace> cracked_places(const CrackedSheet& sheet, const std::vector<Segment>& waterline);

}  // namespace icebow
