// Time of a step of the run that users wait for: calibrated ice that a ship breaks, with water and floes.
//
//   bench/icebreaking [--json] [--steps N] [--advance M] [--study FILE] [--design NAME] [--state FILE]
//                                                                                  also under mpirun -n N
//
// Goes on from a stored state of the design for N steps (400) and prints the fastest forty of them, one after
// the other. The state is the run after an advance of M metres at full scale (36: a moving window has filled
// by then). It is made where it is not there, which takes minutes, and kept beside this program; --state
// names another file. A state is a checkpoint (solver/run/checkpoint.h) that this program has made: it is
// made again where it is of another case, of another time step for one.
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <exception>
#include <filesystem>
#include <iostream>
#include <limits>
#include <nlohmann/json.hpp>

#include "base/communicator.h"
#include "base/error_words.h"
#include "base/errors.h"
#include "bench/block_states.h"
#include "bench/machine.h"
#include "solver/contact/floe_contact.h"
#include "solver/run/case_text.h"
#include "solver/run/checkpoint.h"
#include "solver/run/simulation.h"
#include "study/evaluate/calibration.h"
#include "study/plan/design_space.h"
#include "study/spec/case_hull.h"
#include "study/spec/read_study.h"
#include "study/spec/spec_case.h"

using namespace icebow;

namespace {

struct Options {
  bool json = false;
  int steps = 400;  // rounded up to batches
  double advance = 36.0;
  std::string study = ICEBOW_SOURCE_DIR "/studies/validation/calibrated_trends.json", design = "base", state;
};

Options parse(int argc, char** argv) {
  Options o;
  for (int a = 1; a < argc; ++a) {
    const std::string name = argv[a];
    if (name == "--json") {
      o.json = true;
      continue;
    }
    if (a + 1 >= argc) throw InputError(name + ": no such option, or its value is missing");
    const std::string value = argv[++a];
    if (name == "--steps")
      o.steps = std::max(1, std::atoi(value.c_str()));
    else if (name == "--advance")
      o.advance = std::atof(value.c_str());
    else if (name == "--study")
      o.study = value;
    else if (name == "--design")
      o.design = value;
    else if (name == "--state")
      o.state = value;
    else
      throw InputError(name + ": no such option");
  }
  if (o.state.empty()) {
    const auto place = std::filesystem::path(argv[0]).parent_path();
    o.state = (place / ("icebreaking_" + o.design + "_" + std::to_string(std::lround(o.advance)) + "m.h5"))
                  .string();
  }
  return o;
}

Case find_case(const Options& o) {
  const StudySpec spec = read_study(o.study);
  for (const PlannedDesign& planned : plan_study(spec).designs)
    if (planned.design.name == o.design) return read_case(planned.design.document, o.design);
  throw InputError(o.design + ": no such design in " + o.study);
}

double now() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

// One run by hand.
struct Run {
  Run(const Communicator& c, const Case& study_case)
      : comm(c),
        lambda(study_case.lambda),
        hull(scaled(make_hull(study_case).mesh, 1.0 / lambda)),
        s(simulated_scenario(comm, study_case)),
        lattice(make_lattice(s)),
        stepper(comm, hull, s, lattice, run_size(hull, s).dt, first_touch_x(hull, lattice)),
        recorder(comm, stepper, s),
        snapshots(comm, hull, s, options),
        process(comm, hull, s, stepper, recorder.steps_per_sample()) {}
  RunState state() { return {stepper, recorder, snapshots, process}; }

  const Communicator& comm;
  const double lambda;
  const QuadMesh hull;
  const Scenario s;
  const Lattice lattice;
  const RunOptions options;
  Stepper stepper;
  Recorder recorder;
  Snapshots snapshots;
  ProcessWatch process;
};

// A state of this very case: one of another time step would put the ship elsewhere.
void reach_state(Run& run, const Options& o) {
  RunState state = run.state();
  const std::string text = case_text(run.hull, run.s, run.options);
  if (run.comm.any(run.comm.is_root() && std::filesystem::exists(o.state))) {
    const int bytes = run.s.numerics.precision == Precision::fp64 ? 8 : 4;
    const std::string reason =
        why_not_resumable(run.comm, o.state, text, bytes, std::numeric_limits<std::int64_t>::max());
    if (reason.empty()) return load_checkpoint(run.comm, o.state, state);
    if (run.comm.is_root()) std::cerr << o.state << ' ' << reason << '\n';
  }
  if (run.comm.is_root()) std::cerr << "making " << o.state << " ...\n";
  while (run.s.V * run.stepper.time() * run.lambda < o.advance ||
         run.stepper.steps() % run.recorder.steps_per_sample() != 0)
    run.stepper.step();
  save_checkpoint(run.comm, o.state, text, state);
}

struct Timing {
  double ms_per_step = 1e300, median_ms = 0.0, cpu_ms = 0.0;
  double phase_ms[phases] = {};
};

// In batches as long as the search for floes' contacts comes round. The fastest batch is what the program
// takes, the median what the machine gave it; CPU time is the mean over all.
Timing time_steps(Run& run, int steps) {
  Timing timing;
  std::vector<double> batches;
  PhaseTimer& timer = run.stepper.timer();
  const double cpu = double(std::clock());
  int done = 0;
  for (; done < steps; done += pairs_every) {
    run.comm.barrier();
    timer.start();
    const PhaseTimer before = timer;
    const double start = now();
    for (int n = 0; n < pairs_every; ++n) run.stepper.step();
    batches.push_back(1e3 * run.comm.max(now() - start) / pairs_every);
    if (batches.back() >= timing.ms_per_step) continue;
    timing.ms_per_step = batches.back();
    for (int p = 0; p < phases; ++p) {
      const Phase phase = static_cast<Phase>(p);
      timing.phase_ms[p] = 1e3 * (timer.seconds(phase) - before.seconds(phase)) / pairs_every;
    }
  }
  std::nth_element(batches.begin(), batches.begin() + batches.size() / 2, batches.end());
  timing.median_ms = batches[batches.size() / 2];
  timing.cpu_ms = 1e3 * (double(std::clock()) - cpu) / CLOCKS_PER_SEC / done;
  return timing;
}

void run(const Communicator& comm, const Options& o) {
  const Case study_case = find_case(o);
  Run run(comm, study_case);
  reach_state(run, o);
  std::int64_t bonds = 2 * run.stepper.sheet().bits.count();
  comm.sum(&bonds, 1);
  comm.broadcast(&bonds, sizeof bonds);
  const double advance = run.s.V * run.stepper.time() * run.lambda;
  const Timing timing = time_steps(run, o.steps);
  const std::vector<StateShare> shares = state_shares(comm, run.stepper.sheet());
  if (!comm.is_root()) return;
  const std::vector<StateCost> costs = state_costs(run.lattice.nz);
  const double linear_ms = 1e-6 * costs.front().cpu_ns_per_bond * double(bonds) / comm.size();
  const double ratio = timing.cpu_ms / linear_ms;
  if (o.json) {
    nlohmann::json states, phase_shares;
    for (std::size_t n = 0; n < shares.size(); ++n)
      states[shares[n].name] = {{"share", shares[n].share},
                                {"ns_per_bond", costs[n].ns_per_bond},
                                {"cpu_ns_per_bond", costs[n].cpu_ns_per_bond}};
    for (int p = 0; p < phases; ++p)
      phase_shares[to_string(static_cast<Phase>(p))] = timing.phase_ms[p] / timing.ms_per_step;
    std::cout << nlohmann::json{{"ranks", comm.size()},
                                {"design", o.design},
                                {"advance_m", advance},
                                {"lattice", {run.lattice.nx, run.lattice.ny, run.lattice.nz}},
                                {"bonds", bonds},
                                {"steps", o.steps},
                                {"ms_per_step", timing.ms_per_step},
                                {"median_ms_per_step", timing.median_ms},
                                {"cpu_ms_per_step", timing.cpu_ms},
                                {"linear_ms_per_step", linear_ms},
                                {"ratio_to_linear", ratio},
                                {"states", states},
                                {"phases", phase_shares},
                                {"kernel", run.stepper.sheet().kernel.name},
                                {"machine", machine_context()}}
              << "\n";
    return;
  }
  std::printf(
      "%s after %.1f m, %d rank(s), %lld directed bonds, %s: %.4f ms/step = %.3f ns/bond, %.2f x the linear "
      "rate (median %.4f ms, CPU %.4f ms)\n",
      o.design.c_str(), advance, comm.size(), static_cast<long long>(bonds), run.stepper.sheet().kernel.name,
      timing.ms_per_step, 1e6 * timing.ms_per_step / double(bonds), ratio, timing.median_ms, timing.cpu_ms);
  for (int p = 0; p < phases; ++p) {
    if (timing.phase_ms[p] > 0.0)
      std::printf("  %-14s %8.4f ms %5.1f %%\n", to_string(static_cast<Phase>(p)), timing.phase_ms[p],
                  100.0 * timing.phase_ms[p] / timing.ms_per_step);
  }
  for (std::size_t n = 0; n < shares.size(); ++n)
    std::printf("  %-14s %5.1f %% of the blocks' rows, %.3f ns/bond where all are\n", shares[n].name,
                100.0 * shares[n].share, costs[n].ns_per_bond);
}

}  // namespace

int main(int argc, char** argv) {
  MpiSession mpi(argc, argv);
  const Communicator comm = mpi.world();
  try {
    run(comm, parse(argc, argv));
  } catch (const std::exception& error) {
    if (comm.is_root()) std::cerr << "icebreaking: " << in_words(error) << "\n";
    return 1;
  }
}
