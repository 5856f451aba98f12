// Time of the whole bond work of a step on the reference slab: 500 x 250 x 3 particles, corrections and
// breakage on.
//
//   bench/kernel [--json] [--steps N] [--nx N --ny N --nz N] [--along-x RANKS] [--fp64] [--full-law]
//                [--state linear|calm|intact|touched|stress]                     also under mpirun -n N
//   bench/kernel --machine                                                         only what it runs on
//
// The slab vibrates freely (a smooth initial velocity), so no value is trivial; nothing breaks, and all of it
// stays below the displacement gradient where the bond law is linearised. --full-law: no block is linear.
// --state: all ice in one state (bench/block_states.h), one rank. ICEBOW_KERNEL names another vector width
// than the widest.
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <iostream>
#include <nlohmann/json.hpp>
#include <string>

#include "base/communicator.h"
#include "bench/block_states.h"
#include "bench/machine.h"
#include "solver/ice/sheet.h"
#include "solver/ice/step_schedule.h"
#include "solver/lattice/stability.h"

using namespace icebow;

namespace {

struct Options {
  bool json = false, machine = false, fp64 = false, full_law = false;
  int steps = 60, nx = 500, ny = 250, nz = 3;
  int along_x = 0;  // ranks along x; 0 = the smallest halo
  std::string state;
};

Options parse(int argc, char** argv) {
  Options o;
  const struct {
    const char* name;
    int* value;
  } numbers[] = {
      {"--steps", &o.steps}, {"--nx", &o.nx}, {"--ny", &o.ny}, {"--nz", &o.nz}, {"--along-x", &o.along_x}};
  for (int a = 1; a < argc; ++a) {
    if (!std::strcmp(argv[a], "--json")) o.json = true;
    if (!std::strcmp(argv[a], "--fp64")) o.fp64 = true;
    if (!std::strcmp(argv[a], "--full-law")) o.full_law = true;
    if (!std::strcmp(argv[a], "--machine")) o.machine = true;
    if (!std::strcmp(argv[a], "--state") && a + 1 < argc) o.state = argv[++a];
    for (const auto& number : numbers)
      if (!std::strcmp(argv[a], number.name) && a + 1 < argc) *number.value = std::atoi(argv[++a]);
  }
  return o;
}

Scenario slab(const Options& o) {
  Scenario s;
  if (!o.state.empty()) s = slab_scenario(o.nx, o.ny, o.nz, ice_state(o.state));
  s.numerics.dx = 0.013;
  if (o.fp64) s.numerics.precision = Precision::fp64;
  if (o.full_law) s.numerics.linear_below = 0.0;
  if (!o.state.empty()) return s;
  s.ice = {o.nz * s.numerics.dx, 826.6, 52e6, 0.33, 0.0052, 0.0};
  s.sheet = {o.nx * s.numerics.dx, o.ny * s.numerics.dx, FixedEdges::sides};
  return s;
}

void excite(IceSheet& sheet) {
  for (int jl = 0; jl < sheet.layout.columns; ++jl) {
    for (int k = 0; k < sheet.layout.nz; ++k) {
      const std::size_t row = sheet.layout.row(jl, k);
      for (int l = 0; l < sheet.layout.blocks * block; ++l) {
        if (!sheet.mobile(jl, l)) continue;
        const double x = sheet.lattice.x(sheet.layout.i0 + l), y = sheet.lattice.y(sheet.layout.j0 + jl);
        sheet.v[2][row + l] = 1e-3 * std::sin(3.0 * x) * std::cos(2.0 * y);
      }
    }
  }
}

void run(const Communicator& comm, const Options& options) {
  const Scenario s = slab(options);
  const Lattice lattice = make_lattice(s);
  const Material material = make_material(s.ice, lattice.dx, s.numerics.horizon_ratio);
  IceSheet sheet(s, lattice, make_partition(lattice, comm.rank(), comm.size(), options.along_x), material);
  const double limit = stable_time_step(sheet.stencil, material, lattice.dx, s.ice.rho, true);
  DriftSettings drift{};
  drift.dt = 0.8 * limit;
  drift.inverse_dx = 1.0 / lattice.dx;
  if (options.state.empty()) {
    excite(sheet);
  } else {
    put_into(sheet, ice_state(options.state));
    drift.dt = still_step;
  }

  PhaseTimer timer;
  StepSchedule schedule(comm, sheet, timer);
  double best = 1e300, part[3] = {};
  for (int repeat = 0; repeat < 3; ++repeat) {
    comm.barrier();
    const auto now = [] {
      return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
    };
    const PhaseTimer before = timer;
    const double start = now();
    timer.start();
    for (int n = 0; n < options.steps; ++n) {
      schedule.run([&](int jl0, int jl1) {
        sheet.drift(drift, jl0, jl1);
        timer.lap(Phase::drift);
      });
    }
    const double seconds = comm.max(now() - start) / options.steps;
    if (seconds >= best) continue;
    best = seconds;
    const Phase shown[3] = {Phase::drift, Phase::dilatation, Phase::force};
    for (int p = 0; p < 3; ++p)
      part[p] = (timer.seconds(shown[p]) - before.seconds(shown[p])) / options.steps;
  }
  std::int64_t bonds = 2 * sheet.bits.count();  // directed
  comm.sum(&bonds, 1);
  std::int64_t bytes = static_cast<std::int64_t>(sheet.bytes());
  comm.sum(&bytes, 1);
  std::int64_t sent = static_cast<std::int64_t>(schedule.bytes_sent());
  comm.sum(&sent, 1);
  if (!comm.is_root()) return;
  const double ns = 1e9 * best / double(bonds), per_particle = double(bytes) / double(lattice.particles());
  if (options.json) {
    std::cout << nlohmann::json{{"ranks", comm.size()},
                                {"ranks_along_x", sheet.partition.px},
                                {"ranks_along_y", sheet.partition.py},
                                {"lattice", {lattice.nx, lattice.ny, lattice.nz}},
                                {"particles", lattice.particles()},
                                {"bonds", bonds},
                                {"ms_per_step", 1e3 * best},
                                {"ns_per_bond", ns},
                                {"bytes_per_particle", per_particle},
                                {"halo_bytes_per_step", sent},
                                {"linear_share", sheet.linear_share()},
                                {"kernel", sheet.kernel.name},
                                {"precision", options.fp64 ? "fp64" : "fp32"},
                                {"dt_s", drift.dt},
                                {"dt_limit_s", limit},
                                {"machine", machine_context()}}
              << "\n";
  } else {
    std::printf(
        "%d rank(s), %lld directed bonds, %s: %.3f ms/step = %.3f ns/bond (drift %.2f, dilatation %.2f, "
        "force "
        "%.2f ms), %.0f %% linear, %.0f B/particle, %lld B/step sent, dt limit %.3g s\n",
        comm.size(), static_cast<long long>(bonds), sheet.kernel.name, 1e3 * best, ns, 1e3 * part[0],
        1e3 * part[1], 1e3 * part[2], 100.0 * sheet.linear_share(), per_particle,
        static_cast<long long>(sent), limit);
  }
}

}  // namespace

int main(int argc, char** argv) {
  MpiSession mpi(argc, argv);
  const Communicator comm = mpi.world();
  const Options options = parse(argc, argv);
  try {
    if (options.machine) {
      if (comm.is_root()) std::cout << machine_context() << "\n";
    } else {
      run(comm, options);
    }
  } catch (const std::exception& error) {
    if (comm.is_root()) std::cerr << "kernel: " << error.what() << "\n";
    return 1;
  }
}
