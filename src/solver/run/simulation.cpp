#include "solver/run/simulation.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>

#include "base/collective.h"
#include "base/errors.h"
#include "base/text.h"
#include "geometry/hull_distance.h"
#include "solver/contact/contact.h"
#include "solver/ice/sheet_state.h"
#include "solver/ice/stir.h"
#include "solver/lattice/stability.h"
#include "solver/output/snapshots.h"
#include "solver/run/checkpoint.h"
#include "solver/step/stepper.h"
#include "solver/watch/process_watch.h"
#include "solver/watch/recorder.h"
#include "solver/watch/stop_rule.h"

namespace icebow {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

void check_window(const QuadMesh& hull, const Scenario& s) {
  const Box box = bounding_box(hull);
  const double needed = s.sheet.window_ahead + 0.5 * (box.upper.y() - box.lower.y());
  if (s.sheet.length >= needed && s.sheet.window_ahead > 2.0 * s.ice.h) return;
  throw InputError(
      text("a window of %.3f m with %.3f m ahead of the stem: it must hold half a beam astern of the stem as "
           "well (%.3f m in all) and more than two thicknesses ahead",
           s.sheet.length, s.sheet.window_ahead, needed));
}

void check_symmetry(const QuadMesh& hull, const Lattice& lattice) {
  const double tolerance = 1e-3 * lattice.dx;  // contact does not notice less
  const auto place = place_without_mirror_image(hull, tolerance);
  if (!place) return;
  throw InputError(
      text("a half model needs a hull that is the same on both sides of y = 0: there is no mirror image, to "
           "within %.2g m, of the surface at x = %.4f m, y = %.4f m, z = %.4f m; correct the hull, or "
           "simulate the whole sheet (/sheet/half_model false)",
           tolerance, place->x(), place->y(), place->z()));
}

void check(const QuadMesh& hull, const Scenario& s, const Lattice& lattice) {
  if (s.sheet.half_model) check_symmetry(hull, lattice);
  const Box box = bounding_box(hull);
  const double beam = box.upper.y() - box.lower.y();
  if (lattice.width() < 1.2 * beam) {
    throw InputError(text("sheet of %.3f m is too narrow for a beam of %.3f m: make it at least %.3f m wide",
                          s.sheet.width, beam, 1.2 * beam));
  }
  if (s.sheet.window_ahead > 0.0) {
    check_window(hull, s);
  } else if (s.advance > s.sheet.length - 2.0 * s.ice.h) {
    throw InputError(
        text("advance %.3f m leaves no ice ahead in a sheet of %.3f m: shorten the advance or "
             "lengthen the sheet",
             s.advance, s.sheet.length));
  }
  if (!(s.V > 0.0)) throw InputError(text("speed %.3g m/s: the ship must sail ahead", s.V));
  if (s.numerics.horizon_ratio < 1.0 || s.numerics.horizon_ratio >= reach + 1) {
    throw InputError(
        text("horizon of %.3g spacings: allowed 1 to less than %d", s.numerics.horizon_ratio, reach + 1));
  }
  const Material material = make_material(s.ice, lattice.dx, s.numerics.horizon_ratio);
  if (!(material.s0 > 0.0 && material.s0 < 0.05)) {
    throw InputError(
        text("critical stretch %.4g: allowed above 0 and below 0.05 (give a smaller fracture toughness "
             "or a stiffer ice)",
             material.s0));
  }
}

struct TimeStep {
  double dt, limit;
};

TimeStep time_step(const Scenario& s, const Lattice& lattice) {
  const Material material = make_material(s.ice, lattice.dx, s.numerics.horizon_ratio);
  const Stencil stencil = make_stencil(lattice.nz, lattice.dx, material.delta);
  const double limit =
      with_contact(stable_time_step(stencil, material, lattice.dx, s.ice.rho, s.numerics.surface_correction),
                   contact_stiffness(s), s.ice.rho * lattice.particle_volume());
  const double dt = s.numerics.dt > 0.0 ? s.numerics.dt : s.numerics.dt_fraction * limit;
  if (dt > limit) {
    throw InputError(
        text("time step %.4g s is above the stability limit %.4g s of this lattice: use a smaller one, or "
             "give none for %.2g of the limit",
             dt, limit, s.numerics.dt_fraction));
  }
  return {dt, limit};
}

std::int64_t steps_of(const Scenario& s, double dt) {
  return static_cast<std::int64_t>(std::ceil(s.advance / (s.V * dt)));
}

Metrics measure(const Communicator& comm, const QuadMesh& hull, const Scenario& s, const Stepper& stepper,
                const History& history, const SheetState& state) {
  Metrics metrics;
  std::vector<double> resistance, vertical;
  metrics.steady_from = s.steady_from;
  for (const HistoryRow& row : history.rows) {
    if (row.advance <= s.steady_from) continue;
    resistance.push_back(-row.F[0]);
    vertical.push_back(row.F[2]);
    metrics.steady_to = row.advance;
  }
  metrics.resistance = series_statistics(resistance);
  metrics.drift = drift_of(resistance);
  metrics.vertical = series_statistics(vertical);
  std::int64_t bonds = stepper.sheet().bonds() + stepper.broken_bonds();
  comm.sum(&bonds, 1);
  metrics.bonds = bonds;
  metrics.broken_bonds = history.rows.empty() ? 0 : history.rows.back().broken_bonds;

  if (comm.is_root()) {
    const Box box = bounding_box(hull);
    measure_sheet(state, state.lattice.first * state.lattice.dx, stepper.hull_x() - entrance_length(hull),
                  box.upper.y() - box.lower.y(), metrics);
  }
  broadcast(comm, metrics);
  return metrics;
}

bool touches(const HistoryRow& row) {
  return row.contacts > 0 || row.F[0] != 0.0 || row.F[1] != 0.0 || row.F[2] != 0.0;
}

// Empty where the ice did touch the hull in the part of the record that counts.
std::string why_no_load(const History& history, double steady_from) {
  const auto& rows = history.rows;
  if (rows.empty()) return "";  // shorter than a sample: its load is no number
  const auto last = std::find_if(rows.rbegin(), rows.rend(), touches);
  if (last == rows.rend())
    return text("the hull never touched the ice in an advance of %.4g m",
                rows.empty() ? 0.0 : rows.back().advance);
  if (last->advance > steady_from || rows.back().advance <= steady_from) return "";
  return text("the hull touched no ice from an advance of %.4g m on, last at %.4g m", steady_from,
              last->advance);
}

// Collective [m]: of the nearest particle as it lies now; 0 where one touches.
double distance_to_ice(const Communicator& comm, const QuadMesh& hull, const IceSheet& sheet, double hull_x) {
  const HullDistance distance(hull, bounding_box(hull));
  const Layout& l = sheet.layout;
  double nearest = std::numeric_limits<double>::infinity();
  for (int jl = 0; jl < l.columns; ++jl)
    for (int k = 0; k < l.nz; ++k)
      for (int il = 0; il < l.blocks * block && l.i0 + il < sheet.lattice.nx; ++il) {
        const std::size_t p = l.row(jl, k) + static_cast<std::size_t>(il);
        const Vec3 at(sheet.lattice.x(l.i0 + il) + sheet.u[0][p] - hull_x,
                      sheet.lattice.y(l.j0 + jl) + sheet.u[1][p], sheet.lattice.z(k) + sheet.u[2][p]);
        nearest = std::min(nearest, distance.closest(at).signed_distance);
      }
  return std::max(0.0, -comm.max(-nearest));
}

double latest_balance(const History& history) {
  for (auto row = history.rows.rbegin(); row != history.rows.rend(); ++row) {
    if (!std::isnan(row->balance_error)) return row->balance_error;
  }
  return 0.0;
}

class Loop {
 public:
  Loop(const Communicator& comm, const QuadMesh& hull, const Scenario& s, const RunOptions& options,
       RunResult& result)
      : comm_(comm), hull_(hull), s_(s), options_(options), result_(result) {}

  void run(const Lattice& lattice) {
    Stepper stepper(comm_, hull_, s_, lattice, result_.dt, first_touch_x(hull_, lattice));
    stir(stepper.sheet(), options_.seed, s_.V);
    Recorder recorder(comm_, stepper, s_, result_.dt_limit);
    Snapshots snapshots(comm_, hull_, s_, options_);
    ProcessWatch process(comm_, hull_, s_, stepper, recorder.steps_per_sample());
    result_.s0 = stepper.material().s0;
    std::int64_t bonds = stepper.sheet().bits.count();
    comm_.sum(&bonds, 1);
    result_.directed_bonds = 2 * bonds;
    result_.status = RunStatus::ok;

    RunState state{stepper, recorder, snapshots, process};
    Checkpoints checkpoints(comm_, hull_, s_, options_);
    checkpoints.resume(state, result_.steps);
    snapshots.go_on(s_.V * stepper.time());
    snapshots.start(stepper);
    const std::int64_t first_step = stepper.steps();
    stepper.timer().start();
    last_report_ = Clock::now();
    start_ = last_report_ -
             std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(state.wall_seconds));
    while (stepper.steps() < result_.steps) {
      stepper.step();
      const bool sampled = stepper.steps() % recorder.steps_per_sample() == 0;
      if (sampled && !sample(state)) {
        result_.status = RunStatus::failed;
        break;
      }
      if (!sampled && !look_is_due(stepper)) continue;
      if (heed(checkpoints, state, sampled)) {
        result_.status = RunStatus::interrupted;
        result_.reason = "interrupted";
        break;
      }
      if (sampled && recorded_enough(recorder.history())) {
        result_.ended = RunEnd::interval_narrow_enough;
        break;
      }
    }
    conclude(state, checkpoints, first_step);
  }

 private:
  static CracksSoFar cracks_of(const RunState& state) {
    return [&state] { return state.process.cracked_places(state.stepper); };
  }

  void conclude(RunState& state, Checkpoints& checkpoints, std::int64_t first_step) {
    Stepper& stepper = state.stepper;
    Recorder& recorder = state.recorder;
    Snapshots& snapshots = state.snapshots;
    stepper.timer().lap(Phase::other);
    result_.wall_seconds = seconds_since(start_);
    result_.profile = profile_of(comm_, stepper.timer());
    result_.profiled_steps = stepper.steps() - first_step;
    result_.linear_share = mean_linear_share(state.linear);
    result_.ns_per_bond = ns_per_bond(stepper.steps(), result_.wall_seconds);
    if (result_.status == RunStatus::ok && result_.ended == RunEnd::advance_reached)
      snapshots.write_due(stepper, s_.advance, cracks_of(state));
    const bool keep = options_.keep_checkpoint || options_.to_be_sailed_on;
    if (result_.status != RunStatus::interrupted && !keep) checkpoints.remove();
    result_.steps = stepper.steps();
    result_.history = recorder.history();
    result_.pictures = snapshots.pictures();
    result_.picture_advance = snapshots.picture_advance();
    if (result_.status == RunStatus::ok) check_touch(stepper);
    if (result_.status != RunStatus::ok) return;
    snapshots.write_animation();
    const SheetState sheet = gather_state(comm_, stepper.sheet());
    result_.metrics = measure(comm_, hull_, s_, stepper, result_.history, sheet);
    result_.process = state.process.sum_up(stepper, sheet, result_.history);
  }

  // Collective: a row of the record, and the files that are due. False where the run has failed.
  bool sample(RunState& state) {
    Stepper& stepper = state.stepper;
    if (!state.recorder.sample(stepper, result_.reason)) return false;
    state.process.sample(stepper);
    stepper.timer().lap(Phase::sampling);
    const LinearCount linear = stepper.sheet().linear_blocks();
    state.linear.linear += linear.linear;
    state.linear.all += linear.all;
    const auto before = Clock::now();
    state.snapshots.write_due(stepper, s_.V * stepper.time(), cracks_of(state));
    stepper.timer().lap(Phase::output);
    report(stepper, state.recorder.history());
    result_.output_seconds += seconds_since(before);
    return true;
  }

  bool look_is_due(const Stepper& stepper) const {
    return stepper.may_pause() && stepper.steps() - looked_ >= look_every_;
  }

  // Collective: keeps the state where that is due or asked for. True where the run is to end now.
  bool heed(Checkpoints& checkpoints, RunState& state, bool sampled) {
    const Wish wish = wished();
    looked_ = state.stepper.steps();
    if (sampled || wish != Wish::none) {
      const auto before = Clock::now();
      state.wall_seconds = seconds_since(start_);
      state.snapshots.count_pressure(state.stepper);
      checkpoints.write_due(state,
                            wish != Wish::none || (sampled && is_last_sample(state.stepper, state.recorder)));
      result_.output_seconds += seconds_since(before);
    }
    state.stepper.timer().lap(Phase::checkpoint);
    return wish == Wish::stop;
  }

  enum class Wish { none, checkpoint, stop };

  // Collective: the root asks, and all do alike.
  Wish wished() const {
    Wish wish = Wish::none;
    if (comm_.is_root()) {
      if (options_.checkpoint_now && options_.checkpoint_now()) wish = Wish::checkpoint;
      if (options_.stop && options_.stop()) wish = Wish::stop;
    }
    return static_cast<Wish>(static_cast<int>(comm_.max(static_cast<double>(wish))));
  }

  // Where the state is kept for a longer voyage: at a sample, so that the longer one has the same samples.
  bool is_last_sample(const Stepper& stepper, const Recorder& recorder) const {
    return options_.to_be_sailed_on && stepper.steps() + recorder.steps_per_sample() > result_.steps;
  }

  double ns_per_bond(std::int64_t steps, double seconds) const {
    return steps ? 1e9 * seconds / (double(steps) * double(result_.directed_bonds)) : 0.0;
  }

  // Collective. Whole numbers, so that neither ranks nor interruptions change it.
  double mean_linear_share(const LinearCount& linear) const {
    std::int64_t sums[2] = {linear.linear, linear.all};
    comm_.sum(sums, 2);
    return sums[1] > 0 ? double(sums[0]) / double(sums[1]) : 0.0;
  }

  // Collective. A load of nothing is no result: the ship was not in the ice.
  void check_touch(const Stepper& stepper) {
    const std::string reason = why_no_load(result_.history, s_.steady_from);
    if (reason.empty()) return;
    result_.status = RunStatus::failed;
    const double missing = distance_to_ice(comm_, hull_, stepper.sheet(), stepper.hull_x());
    result_.reason =
        reason + text("; at the end the hull was %.4g m from the nearest ice", missing) +
        ": lengthen the advance (/operation/advance_m) or the record (/operation/steady_from_m), or see "
        "whether the hull reaches the water's surface (lengths at the scale of the simulation)";
  }

  // Collective: the root decides, so that ranks on unlike machines agree.
  bool recorded_enough(const History& history) const {
    if (!(s_.stop_when_ci95_below > 0.0)) return false;
    return comm_.any(comm_.is_root() && enough_recorded(history, s_.steady_from, s_.stop_when_ci95_below));
  }

  // Collective: tells the observer, and agrees on how many steps pass between two looks at what it wishes.
  void report(const Stepper& stepper, const History& history) {
    constexpr double seconds_a_look = 0.1;
    const double seconds = seconds_since(start_);
    if (comm_.is_root() && seconds_since(last_report_) > 0.25) {
      last_report_ = Clock::now();
      if (options_.on_progress) {
        const HistoryRow& row = history.rows.back();
        options_.on_progress({stepper.steps(), result_.steps, row.advance, -row.F[0], seconds,
                              ns_per_bond(stepper.steps(), seconds), row.hull_work, latest_balance(history)});
      }
    }
    const double steps = seconds_a_look * double(stepper.steps()) / std::max(seconds, 1e-9);
    look_every_ = static_cast<std::int64_t>(comm_.max(comm_.is_root() ? std::clamp(steps, 1.0, 1e9) : 0.0));
  }

  const Communicator& comm_;
  const QuadMesh& hull_;
  const Scenario& s_;
  const RunOptions& options_;
  RunResult& result_;
  Clock::time_point start_, last_report_;
  std::int64_t looked_ = 0, look_every_ = 1;  // steps
};

}  // namespace

RunSize run_size(const QuadMesh& hull, const Scenario& s) {
  const Lattice lattice = make_lattice(s);
  check(hull, s, lattice);
  const TimeStep step = time_step(s, lattice);
  return {lattice.nx, lattice.ny, lattice.nz, steps_of(s, step.dt), step.dt, step.limit};
}

RunResult simulate(const Communicator& comm, const QuadMesh& hull, const Scenario& s,
                   const RunOptions& options) {
  const RunSize size = run_size(hull, s);
  RunResult result;
  result.dt = size.dt;
  result.dt_limit = size.dt_limit;
  result.nx = size.nx;
  result.ny = size.ny;
  result.nz = size.nz;
  result.steps = size.steps;
  try {
    RunResult attempt = result;
    Loop(comm, hull, s, options, attempt).run(make_lattice(s));
    return attempt;
  } catch (const DamagedCheckpoint&) {  // of all ranks
    if (options.resume != Resume::if_usable) throw;
  }
  Loop(comm, hull, s, options, result).run(make_lattice(s));  // it was set aside
  return result;
}

}  // namespace icebow
