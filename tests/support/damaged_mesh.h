// Meshes damaged at random in the ways files of other programs are, from sound ones whose right answers are
// known.
#pragma once

#include <cstdint>
#include <string>

#include "geometry/quad_mesh.h"

struct DamagedMesh {
  icebow::QuadMesh mesh;
  std::string damage;  // what was done, in words
};

// One to three of: panels turned over, panels split at an edge's middle on one side only (T-junctions),
// points torn apart by up to 3 mm (gaps), panels left out, slivers, panels given twice, doublets, loose
// triangles beside the hull, a closed tank inside, a bulkhead across, a deckhouse that overlaps the deck, all
// as triangles, coordinates in whole millimetres, panels with points of their own, the deck left out, edges
// with a point in the middle that both of their panels have. The seed says which, how many and where.
DamagedMesh damaged(const icebow::QuadMesh& sound, std::uint64_t seed);
