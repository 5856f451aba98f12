// Time of the whole bond work of a step on the reference slab: 500 x 250 x 3 particles, corrections and
// breakage on.
//
//   bench/kernel [--json] [--steps N]      also under mpirun -n N
//
// The slab vibrates freely (a smooth initial velocity), so no value is trivial; nothing breaks.
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <string>

#include "base/communicator.h"
#include "solver/halo.h"
#include "solver/sheet.h"
#include "solver/stability.h"

using namespace icebow;

namespace {

Scenario reference_slab() {
  Scenario s;
  s.ice = {0.039, 826.6, 52e6, 0.33, 0.0052, 0.0};
  s.sheet = {6.5, 3.25, FixedEdges::sides};
  s.numerics.dx = 0.013;
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

}  // namespace

int main(int argc, char** argv) {
  MpiSession mpi(argc, argv);
  const Communicator comm = mpi.world();
  bool json = false, fp64 = false;
  int steps = 60;
  for (int a = 1; a < argc; ++a) {
    if (!std::strcmp(argv[a], "--json")) json = true;
    if (!std::strcmp(argv[a], "--fp64")) fp64 = true;
    if (!std::strcmp(argv[a], "--steps") && a + 1 < argc) steps = std::atoi(argv[++a]);
  }

  Scenario s = reference_slab();
  if (fp64) s.numerics.precision = Precision::fp64;
  const Lattice lattice = make_lattice(s);
  const Material material = make_material(s.ice, lattice.dx, s.numerics.horizon_ratio);
  IceSheet sheet(s, lattice, make_partition(lattice, comm.rank(), comm.size()), material);
  Halo displacements(comm, sheet.partition, sheet.layout, {&sheet.u[0], &sheet.u[1], &sheet.u[2]},
                     ghost_blocks, 0);
  Halo dilatations(comm, sheet.partition, sheet.layout, {&sheet.theta}, 1, 1);
  const double limit = stable_time_step(sheet.stencil, material, lattice.dx, s.ice.rho, true);
  DriftSettings drift{};
  drift.dt = 0.8 * limit;
  drift.inverse_dx = 1.0 / lattice.dx;
  excite(sheet);

  double best = 1e300, part[3] = {};
  for (int repeat = 0; repeat < 3; ++repeat) {
    comm.barrier();
    const auto now = [] {
      return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
    };
    double t[3] = {};
    const double start = now();
    for (int n = 0; n < steps; ++n) {
      const double t0 = now();
      sheet.drift(drift);
      displacements.exchange();
      const double t1 = now();
      sheet.dilatation();
      dilatations.exchange();
      const double t2 = now();
      sheet.force();
      const double t3 = now();
      t[0] += t1 - t0;
      t[1] += t2 - t1;
      t[2] += t3 - t2;
    }
    const double seconds = comm.max(now() - start) / steps;
    if (seconds < best) {
      best = seconds;
      for (int p = 0; p < 3; ++p) part[p] = t[p] / steps;
    }
  }
  std::int64_t bonds = 2 * sheet.bits.count();  // directed
  comm.sum(&bonds, 1);
  std::int64_t bytes = static_cast<std::int64_t>(sheet.bytes());
  comm.sum(&bytes, 1);
  if (!comm.is_root()) return 0;
  const double ns = 1e9 * best / double(bonds), per_particle = double(bytes) / double(lattice.particles());
  if (json) {
    std::printf(
        "{\"ranks\": %d, \"particles\": %lld, \"bonds\": %lld, \"ms_per_step\": %.4f, \"ns_per_bond\": %.4f, "
        "\"bytes_per_particle\": %.1f, \"kernel\": \"%s\", \"dt_limit_s\": %.4g}\n",
        comm.size(), static_cast<long long>(lattice.particles()), static_cast<long long>(bonds), 1e3 * best,
        ns, per_particle, sheet.kernel.name, limit);
  } else {
    std::printf(
        "%d rank(s), %lld directed bonds, %s: %.3f ms/step = %.3f ns/bond (drift %.2f, dilatation %.2f, "
        "force "
        "%.2f ms), %.0f B/particle, dt limit %.3g s\n",
        comm.size(), static_cast<long long>(bonds), sheet.kernel.name, 1e3 * best, ns, 1e3 * part[0],
        1e3 * part[1], 1e3 * part[2], per_particle, limit);
  }
}
