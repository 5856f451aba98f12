#include "solver/watch/process_watch.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/collective.h"
#include "base/errors.h"
#include "base/whole_number.h"
#include "solver/model/load_cycle.h"
#include "solver/model/plate_on_water.h"

namespace icebow {
namespace {

constexpr std::size_t column_values = 6;

PlateOnWater floating_sheet(const Scenario& s) {
  return plate_on_water(s.ice.E, s.ice.nu, s.ice.h, s.water.rho);
}

}  // namespace

double entrance_length(const QuadMesh& hull) {
  const Box box = bounding_box(hull);
  const double half_beam = box.upper.y(), tolerance = 0.02 * (box.upper.z() - box.lower.z());
  double x = box.lower.x();
  for (const Vec3& p : hull.points) {
    if (std::abs(p.z()) < tolerance && p.y() > 0.999 * half_beam) x = std::max(x, p.x());
  }
  return -x;
}

ProcessWatch::ProcessWatch(const Communicator& comm, const QuadMesh& hull, const Scenario& s,
                           const Stepper& stepper, std::int64_t steps_per_sample)
    : comm_(comm),
      hull_(hull),
      scenario_(s),
      steps_per_sample_(steps_per_sample),
      start_x_(stepper.hull_x()),
      cracks_(stepper.sheet().lattice.dx, s.V * stepper.dt() * double(steps_per_sample)) {}

double ProcessWatch::full_beam_x(const Stepper& stepper) const {
  return stepper.hull_x() - entrance_length(hull_);
}

void ProcessWatch::sample(const Stepper& stepper) {
  if (cracks_.is_due(stepper.steps() / steps_per_sample_))
    cracks_.look(comm_, stepper.sheet(), scenario_.V * stepper.time());
  if (!stepper.window_moves_within(steps_per_sample_)) return;
  const SheetState state = gather_state(comm_, stepper.sheet());
  if (comm_.is_root()) ice_.add(state, block, 0.0, full_beam_x(stepper));
}

CrackedSheet ProcessWatch::cracked_sheet(const Stepper& stepper) const {
  CrackedSheet sheet;
  sheet.lattice = stepper.sheet().lattice;
  sheet.columns = cracks_.columns();
  sheet.thickness = scenario_.ice.h;
  sheet.characteristic_length = characteristic_length(floating_sheet(scenario_));
  if (scenario_.sheet.fixed != FixedEdges::none)
    sheet.held_beyond = 0.5 * sheet.lattice.width() - reach * sheet.lattice.dx;
  sheet.first_touch_x = start_x_;
  return sheet;
}

std::vector<CrackedPlace> ProcessWatch::cracked_places(const Stepper& stepper) const {
  return icebow::cracked_places(cracked_sheet(stepper), hull_section(hull_, 0.0));
}

BreakingProcess ProcessWatch::sum_up(const Stepper& stepper, const SheetState& state,
                                     const History& history) const {
  BreakingProcess p;
  p.thickness = scenario_.ice.h;
  p.characteristic_length = characteristic_length(floating_sheet(scenario_));
  p.stem_x = stepper.hull_x();
  if (comm_.is_root()) {
    p.cracks = find_cracks(cracked_sheet(stepper), hull_section(hull_, 0.0));
    DetachedIceCount all = ice_;
    all.add(state, state.lattice.nx, 0.0, full_beam_x(stepper));
    p.ice = all.total();
  }
  broadcast(comm_, p.cracks.columns);
  broadcast(comm_, p.cracks.isolated);
  for (double* volume : {&p.ice.volume, &p.ice.in_floes, &p.ice.dust}) broadcast(comm_, *volume);
  broadcast(comm_, p.cracks.list);
  broadcast(comm_, p.ice.floes);
  broadcast(comm_, p.ice.channel);
  p.breaking_length = breaking_length(p.cracks.list);
  p.load = load_cycle(history, scenario_.steady_from);
  p.energy = energy_shares(history);
  return p;
}

std::vector<double> ProcessWatch::crack_record() const {
  std::vector<double> r;
  for (const CrackedColumn& c : cracks_.columns())
    r.insert(r.end(), {double(c.i), double(c.j), c.opened, c.crushed, c.cos2, c.sin2});
  return r;
}

void ProcessWatch::restore(const std::vector<double>& r, const std::vector<double>& ice) {
  const std::string trouble = "its list of cracks is not whole";
  const double most = std::numeric_limits<int>::max();  // of columns and rows of a lattice
  if (r.size() % column_values != 0) throw RuntimeError(trouble);
  std::vector<CrackedColumn> columns;
  for (std::size_t n = 0; n < r.size(); n += column_values)
    columns.push_back({whole_number(r[n], -most, most, trouble), whole_number(r[n + 1], -most, most, trouble),
                       r[n + 2], r[n + 3], r[n + 4], r[n + 5]});
  cracks_.restore(std::move(columns));
  ice_.restore(ice);
}

}  // namespace icebow
