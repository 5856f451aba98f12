// The kernels for any processor (SSE2 or NEON): see kernel.h.
#define ICEBOW_VECTOR_BYTES 16
#include "solver/kernel/kernel_impl.h"

namespace icebow {

extern const Kernels kernels_baseline;
const Kernels kernels_baseline{"baseline", 16, passes<float>(), passes<double>(), near_pairs, floe_forces};

}  // namespace icebow
