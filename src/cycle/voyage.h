// A ship on its way through level ice: crush the edge until it can bear no more, break a piece, sail on.
#pragma once

#include <string>
#include <vector>

#include "cycle/cycle_input.h"
#include "geometry/quad_mesh.h"

namespace icebow::cycle {

struct Record {
  double advance = 0.0;        //!< of the ship since it first touched [m]
  Vec3 force = Vec3::Zero();   //!< of the ice on the ship; x < 0 resists [N]
  Vec3 moment = Vec3::Zero();  //!< about the stem on the waterline [N m]
};

struct Outline {
  double y = 0.0, width = 0.0, from = 0.0, to = 0.0;  //!< of one strip [m]
};

struct Piece {
  double advance = 0.0;        //!< when it broke [m]
  double x = 0.0, y = 0.0;     //!< middle of the contact: along the course from the first edge, to port [m]
  double width = 0.0;          //!< of the contact along the edge [m]
  double radius = 0.0;         //!< breaking length [m]
  double area = 0.0;           //!< [m^2]
  double load = 0.0;           //!< vertical, at the break [N]
  double normal_speed = 0.0;   //!< V n_x of the hull there [m/s]
  double edge_speed = 0.0;     //!< with which the hull drove the edge down [m/s]
  double deflection = 0.0;     //!< of the edge [m]
  std::vector<Outline> shape;  // where asked for
};

// Work of the ship on the ice since `counted_from` [J].
struct Work {
  double crushing = 0.0, bending = 0.0, friction = 0.0, total = 0.0;
};

struct VoyageResult {
  std::string reason;           // why there is no result; empty where there is one
  std::vector<Record> records;  // one a step
  double step = 0.0, counted_from = 0.0, counted_to = 0.0;  //!< [m]
  std::vector<Piece> pieces;
  std::vector<double> channel;  //!< widths at stations a thickness apart, in the part counted [m]
  Work work;
  double crushed_volume = 0.0;          //!< in the part counted [m^3]
  double elastic_released = 0.0;        //!< by edges that broke, in the part counted [J]
  double beam = 0.0, bow_length = 0.0;  //!< of the hull in the ice [m]
};

// Deterministic. `hull` in the frame of base/quad_mesh.h at full scale. Never throws for a hull or values
// that make no voyage: `reason` says so.
VoyageResult sail(const QuadMesh& hull, const Ice& ice, const BreakingRule& rule, const Voyage& voyage);

}  // namespace icebow::cycle
