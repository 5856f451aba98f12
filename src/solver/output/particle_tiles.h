// The sheet's particles as small parallelepipeds: what a picture of a bent, rotated floe is made of.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "solver/ice/ice_cloud.h"

namespace icebow {

// Current edges of the cube of ice a particle stands for [m].
struct Tile {
  Eigen::Vector3f x, y, z;
};

// One tile per particle. The reference lattice is recovered from positions minus displacements; an edge
// follows the lattice neighbours of the same piece that are still next to it (stretched by less than 0.4).
// Without such neighbours, for crushed ice, and where the particles are not on one lattice, the cube keeps
// its axes.
std::vector<Tile> particle_tiles(const IceCloud& ice);

}  // namespace icebow
