// The kernels for processors with AVX512: see kernel.h.
#define ICEBOW_LANES 16
#include "solver/kernel_impl.h"

namespace icebow {

extern const Kernels kernels_avx512;
const Kernels kernels_avx512{"avx512", lanes, dilatation, force, drift};

}  // namespace icebow
