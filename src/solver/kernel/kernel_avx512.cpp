// The kernels for processors with AVX512: see kernel.h.
#define ICEBOW_VECTOR_BYTES 64
#include "solver/kernel/kernel_impl.h"

namespace icebow {

extern const Kernels kernels_avx512;
const Kernels kernels_avx512{"avx512", 64, passes<float>(), passes<double>(), near_pairs, floe_forces};

}  // namespace icebow
