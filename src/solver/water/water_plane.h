// Linear inertia of deep water under a plane that moves up and down in places: equation (44) of
// docs/theory.md.
//
// The plane is a grid of square cells. Where it does not move, and beyond the grid, a rigid lid lies on the
// water, as the ship's bottom does. The pressure at a cell is the sum of what each cell's acceleration gives
// through the potential of a source on the lid (Rayleigh, Theory of Sound, art. 302), found by transforms of
// the grid.
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

namespace icebow {

struct WaterGrid {
  int nx = 0, ny = 0;     // cells; number i * ny + j
  double cell = 0.0;      //!< side [m]
  bool mirrored = false;  // the plane is symmetric in the edge of the cells j = 0
  double density = 0.0;   //!< of the water [kg/m^3]
};

class WaterPlane {
 public:
  // `mobility` [1/kg] is the most that a cell will have.
  WaterPlane(const WaterGrid& grid, double mobility);
  ~WaterPlane();

  // Upward acceleration of each cell without the force that is asked for, and by how much a downward force of
  // 1 N lowers it (0: nothing moves the cell, its acceleration must be 0). Returns the force with which the
  // water resists what the accelerations become, downwards [N]; balanced to a part of 1e-4. The same on every
  // rank that asks the same.
  std::vector<double> resistance(const std::vector<double>& acceleration,
                                 const std::vector<double>& mobility);
  std::size_t cells() const { return std::size_t(grid_.nx) * grid_.ny; }
  // Iterations that the last answer took.
  int iterations() const { return iterations_; }

 private:
  class Transform;

  WaterGrid grid_;
  double mobility_;
  std::unique_ptr<Transform> transform_;
  std::vector<float> inertia_, resisted_;  // factors of wave numbers
  int iterations_ = 0;
};

}  // namespace icebow
