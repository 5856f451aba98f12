#include "bench/block_states.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <ctime>

#include "base/errors.h"
#include "solver/ice/cut.h"
#include "solver/ice/step_schedule.h"
#include "solver/lattice/stability.h"
#include "solver/model/phase_timer.h"

namespace icebow {
namespace {

constexpr const char* names[ice_states] = {"linear", "calm", "intact", "touched", "stress"};

double seconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

// A stretch of the whole sheet along the course that keeps all bonds in a state's range.
double stretch_of(IceState state) {
  if (state == IceState::intact) return -3e-3;
  if (state == IceState::touched) return -2e-2;
  return 0.0;
}

}  // namespace

const char* to_string(IceState state) {
  return names[static_cast<int>(state)];
}

IceState ice_state(const std::string& name) {
  const auto found = std::find(names, names + ice_states, name);
  if (found == names + ice_states)
    throw InputError("--state " + name + ": allowed linear, calm, intact, touched, stress");
  return static_cast<IceState>(found - names);
}

Scenario slab_scenario(int nx, int ny, int nz, IceState state) {
  Scenario s;
  s.numerics.dx = 0.013;
  if (state != IceState::linear) s.numerics.linear_below = 0.0;
  s.ice = {nz * s.numerics.dx, 826.6, 52e6, 0.33, 0.0052, 0.0};
  if (state == IceState::stress) s.ice.tensile_strength = s.ice.E * s.ice.s0;
  s.sheet = {nx * s.numerics.dx, ny * s.numerics.dx, FixedEdges::sides};
  return s;
}

void put_into(IceSheet& sheet, IceState state) {
  const double stretch = stretch_of(state);
  for (int jl = 0; jl < sheet.layout.columns; ++jl) {
    for (int k = 0; k < sheet.layout.nz; ++k) {
      const std::size_t row = sheet.layout.row(jl, k);
      for (int l = 0; l < sheet.layout.blocks * block; ++l) {
        const double x = sheet.lattice.x(sheet.layout.i0 + l), y = sheet.lattice.y(sheet.layout.j0 + jl);
        if (sheet.layout.i0 + l < sheet.lattice.nx) sheet.u[0][row + l] = stretch * x;
        if (sheet.mobile(jl, l)) sheet.v[2][row + l] = 1e-3 * std::sin(3.0 * x) * std::cos(2.0 * y);
      }
    }
  }
  if (state != IceState::touched && state != IceState::stress) return;
  // One bond of every block's first particle, to the next along y.
  cut(sheet,
      [](int i, int, int, const Offset& o) { return i % block == 0 && o.di == 0 && o.dj == 1 && o.dk == 0; });
}

namespace {

StateCost slab_cost(const Scenario& s, IceState state) {
  const Lattice lattice = make_lattice(s);
  const Material material = make_material(s.ice, lattice.dx, s.numerics.horizon_ratio);
  const Communicator comm = Communicator::serial();
  IceSheet sheet(s, lattice, make_partition(lattice, 0, 1), material);
  put_into(sheet, state);
  DriftSettings drift{};
  drift.dt = still_step;
  drift.inverse_dx = 1.0 / lattice.dx;
  PhaseTimer timer;
  StepSchedule schedule(comm, sheet, timer);
  constexpr int steps = 200;
  double best = 1e300;
  const double cpu = double(std::clock());
  for (int n = 0; n < steps; ++n) {
    const double start = seconds();
    schedule.run([&](int jl0, int jl1) { sheet.drift(drift, jl0, jl1); });
    best = std::min(best, seconds() - start);
  }
  const double mean = (double(std::clock()) - cpu) / CLOCKS_PER_SEC / steps,
               bonds = 2.0 * double(sheet.bits.count());
  return {to_string(state), 1e9 * best / bonds, 1e9 * mean / bonds};
}

}  // namespace

std::vector<StateCost> state_costs(int layers) {
  std::vector<StateCost> costs;
  for (int n = 0; n < ice_states; ++n) {
    const IceState state = static_cast<IceState>(n);
    costs.push_back(slab_cost(slab_scenario(176, 122, layers, state), state));
  }
  return costs;
}

std::vector<StateShare> state_shares(const Communicator& comm, const IceSheet& sheet) {
  std::int64_t counts[ice_states + 1] = {};
  const Layout& l = sheet.layout;
  for (int jl = 0; jl < l.columns; ++jl) {
    for (int k = 0; k < l.nz; ++k) {
      for (int b = 0; b < l.blocks; ++b) {
        const std::uint8_t state = sheet.state(jl, k)[b];
        IceState found = law_of(state) == calm ? IceState::calm : IceState::intact;
        if (sheet.is_linear(jl, b))
          found = IceState::linear;
        else if (state & cracked)
          found = law_of(state) == calm ? IceState::stress : IceState::touched;
        else if (law_of(state) == wide)
          found = IceState::touched;
        ++counts[static_cast<int>(found)];
        ++counts[ice_states];
      }
    }
  }
  comm.sum(counts, ice_states + 1);
  std::vector<StateShare> shares;
  for (int n = 0; n < ice_states; ++n)
    shares.push_back({names[n], double(counts[n]) / double(std::max<std::int64_t>(1, counts[ice_states]))});
  return shares;
}

}  // namespace icebow
