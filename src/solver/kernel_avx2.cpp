// The kernels for processors with AVX2: see kernel.h.
#define ICEBOW_LANES 8
#include "solver/kernel_impl.h"

namespace icebow {

extern const Kernels kernels_avx2;
const Kernels kernels_avx2{"avx2", lanes, dilatation, force, drift};

}  // namespace icebow
