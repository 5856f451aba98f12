#pragma once

namespace icebow {

// Files of a ParaView snapshot of the ice.
enum class SnapshotFormat {
  vtp,    // XML PolyData; on more than one rank a piece each, and a .pvtp that names them
  vtkhdf  // one HDF5 file written by all ranks together
};

}  // namespace icebow
