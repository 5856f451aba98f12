// The kernels for processors with AVX2: see kernel.h.
#define ICEBOW_VECTOR_BYTES 32
#include "solver/kernel/kernel_impl.h"

namespace icebow {

extern const Kernels kernels_avx2;
const Kernels kernels_avx2{"avx2", 32, passes<float>(), passes<double>(), near_pairs, floe_forces};

}  // namespace icebow
