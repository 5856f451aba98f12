// VTKHDF 1.0, unstructured grid: what ParaView from 5.10 and VTK from 9.1 read in parallel.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "base/communicator.h"
#include "solver/ice/ice_cloud.h"

namespace icebow {

// Collective: one file, one piece a rank; the particles as vertex cells with the point arrays of
// write_ice_vtp, crack where all ranks have it. Complete or absent. Throws RuntimeError naming the file.
void write_ice_vtkhdf(const Communicator& comm, const std::string& path, const IceCloud& own, bool cracks);

// ParaView's list of files over (time [s], file name) pairs; replaced atomically.
void write_series(const std::string& path, const std::vector<std::pair<double, std::string>>& steps);

}  // namespace icebow
