// The ice sheet in a checkpoint: global arrays, the same file whatever the number of ranks and their grid.
//
//   u_x .. u_z, v_*, residual_*, acceleration_*   float32 or float64 as the solver computes, [j][k][i]
//   bonds                                         uint16, [j][block][slot], see BondBits
//   states                                        uint8, [j][k][block], see RowFields::state
//
// Rows are padded to whole blocks of 16 particles.
#pragma once

#include "base/parallel_file.h"
#include "solver/ice/sheet.h"

namespace icebow {

// Collective; throw RuntimeError. Loading fills what a rank owns, and the bonds of its neighbours that it
// follows; the other ghosts are copied in the next step before they are read.
void save_sheet(ParallelFile& file, const IceSheet& sheet);
void load_sheet(ParallelFile& file, IceSheet& sheet);

// Bytes of a floating-point number of the fields, told to whoever opens the file.
int precision_of(const IceSheet& sheet);

}  // namespace icebow
