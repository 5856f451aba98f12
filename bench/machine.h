// What a timing was taken on. Every --json output of bench/ holds it under "machine".
#pragma once

#include <nlohmann/json.hpp>

namespace icebow {

// processor, physical_cores, logical_cores (those this program may use; under mpirun, which pins each rank
// to a core, those of the machine), compiler, build_type, flags, kernel_flags, kernel, kernel_bits, mpi,
// load_average (of the last minute: was the machine quiet?), date (UTC).
nlohmann::json machine_context();

}  // namespace icebow
