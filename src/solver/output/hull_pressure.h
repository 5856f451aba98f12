// How hard the ice pressed on each quad of the hull, on average between two ParaView steps.
#pragma once

#include <cstdint>
#include <vector>

#include "base/communicator.h"
#include "base/json.h"
#include "geometry/quad_mesh.h"
#include "solver/output/vtp.h"
#include "solver/step/stepper.h"

namespace icebow {

class HullPressure {
 public:
  explicit HullPressure(const QuadMesh& hull) : hull_(hull) {}

  // Collective: adds what the stepper's contact has counted since the last call. The same on every rank, bit
  // for bit on any number of ranks.
  void add(const Communicator& comm, Stepper& stepper);
  // The mean since the last call, or since time 0, up to `time` [s]; the count begins anew.
  std::vector<PressedQuad> take(double time);

  // As a checkpoint keeps it. Throws RuntimeError for a list that is not of this hull.
  Json record() const;
  void restore(const Json& record);

 private:
  const QuadMesh& hull_;
  std::vector<std::int64_t> impulse_;  // x, y, z of each quad in turn, in quanta
  double quantum_ = 0.0;               //!< [N s]
  double since_ = 0.0;                 //!< [s]
};

}  // namespace icebow
