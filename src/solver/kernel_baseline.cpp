// The kernels for any processor (SSE2 or NEON): see kernel.h.
#define ICEBOW_LANES 4
#include "solver/kernel_impl.h"

namespace icebow {

extern const Kernels kernels_baseline;
const Kernels kernels_baseline{"baseline", lanes, dilatation, force, drift};

}  // namespace icebow
