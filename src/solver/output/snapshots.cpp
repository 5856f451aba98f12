#include "solver/output/snapshots.h"

#include <algorithm>
#include <optional>

#include "base/collective.h"
#include "base/errors.h"
#include "base/text.h"
#include "solver/ice/local_cloud.h"
#include "solver/output/animation.h"
#include "solver/output/picture.h"
#include "solver/output/vtkhdf.h"
#include "solver/output/vtp.h"

namespace icebow {
namespace {

// The n-th of `count` moments, the last one at the end of the run.
bool due(int written, int count, double advance, double total) {
  return written < count && advance >= total * (written + 1) / count * (1.0 - 1e-9);
}

// The edges of the channel astern of the stem.
std::vector<Segment> channel(const SheetState& state, double hull_x) {
  std::vector<Segment> lines;
  const double dx = state.lattice.dx;
  std::optional<ChannelEdges> before;
  for (int i = 0; i < state.lattice.nx && state.lattice.x(i) < hull_x; ++i) {
    const ChannelEdges now = channel_edges(state, i);
    const double x = state.lattice.x(i) - 0.5 * dx;
    if (!(now.port > now.starboard)) {
      before.reset();
      continue;
    }
    for (const auto edge : {&ChannelEdges::port, &ChannelEdges::starboard}) {
      lines.emplace_back(Vec2(x, now.*edge), Vec2(x + dx, now.*edge));
      if (before) lines.emplace_back(Vec2(x, (*before).*edge), Vec2(x, now.*edge));
    }
    before = now;
  }
  return lines;
}

}  // namespace

Snapshots::Snapshots(const Communicator& comm, const QuadMesh& hull, const Scenario& scenario,
                     const RunOptions& options)
    : comm_(comm), hull_(hull), scenario_(scenario), options_(options), pressure_(hull) {}

Json Snapshots::record() const {
  return {{"snapshots", snapshots_},        {"ice_steps", ice_steps_}, {"pressure_steps", pressure_steps_},
          {"pressure", pressure_.record()}, {"pictures", pictures_},   {"picture_advance", picture_advance_}};
}

void Snapshots::restore(const Json& record) {
  record.at("snapshots").get_to(snapshots_);
  record.at("ice_steps").get_to(ice_steps_);
  record.at("pressure_steps").get_to(pressure_steps_);
  pressure_.restore(record.at("pressure"));
  record.at("pictures").get_to(pictures_);
  record.at("picture_advance").get_to(picture_advance_);
  if (picture_advance_.size() != pictures_.size()) throw RuntimeError("its list of pictures is not whole");
  for (const std::string& name : pictures_)
    if (name.find('/') != std::string::npos)
      throw RuntimeError("its list of pictures names another directory");
}

void Snapshots::go_on(double advance) {
  const auto left = [&](int written, int count) {
    int n = 0;
    while (n < written && due(n, count, advance, scenario_.advance)) ++n;
    return static_cast<std::size_t>(n);
  };
  snapshots_ = static_cast<int>(left(snapshots_, options_.snapshots));
  const std::size_t steps = static_cast<std::size_t>(snapshots_) + 1;  // and that of time 0
  ice_steps_.resize(std::min(ice_steps_.size(), steps));
  pressure_steps_.resize(std::min(pressure_steps_.size(), steps));
  pictures_.resize(left(static_cast<int>(pictures_.size()), options_.pictures));
  picture_advance_.resize(pictures_.size());
}

void Snapshots::start(Stepper& stepper) {
  if (options_.directory.empty() || options_.snapshots == 0) return;
  stepper.watch_faces();
  if (stepper.steps() > 0) return;
  act_together(comm_, [&] {
    if (comm_.is_root()) write_hull_vtp(options_.directory + "/hull.vtp", hull_);
  });
  write_paraview(stepper, {});
}

void Snapshots::count_pressure(Stepper& stepper) {
  if (options_.snapshots > 0 && !options_.directory.empty()) pressure_.add(comm_, stepper);
}

bool Snapshots::write_due(Stepper& stepper, double advance, const CracksSoFar& cracks) {
  if (options_.directory.empty()) return false;
  count_pressure(stepper);
  const bool paraview = due(snapshots_, options_.snapshots, advance, scenario_.advance);
  const bool picture = due(static_cast<int>(pictures_.size()), options_.pictures, advance, scenario_.advance);
  if (!paraview && !picture) return false;
  const std::vector<CrackedPlace> places = cracks ? cracks() : std::vector<CrackedPlace>();
  if (paraview) {
    write_paraview(stepper, places);
    ++snapshots_;
  }
  if (picture) {
    const SheetState state = gather_state(comm_, stepper.sheet());
    act_together(comm_, [&] { write_picture(state, advance, stepper.hull_x(), places); });
  }
  return true;
}

void Snapshots::write_paraview(const Stepper& stepper, const std::vector<CrackedPlace>& cracks) {
  IceCloud own = local_cloud(comm_, stepper.sheet());
  mark_cracks(own, cracks);
  for (float& x : own.x) x -= static_cast<float>(stepper.hull_x());  // the files are in the hull's frame
  const std::string ice = write_ice(text("ice_%04zu", ice_steps_.size()), own);
  act_together(comm_, [&] { write_pressure_and_lists(stepper.time(), ice); });
}

// Returns the name of the file to open.
std::string Snapshots::write_ice(const std::string& stem, const IceCloud& own) {
  const std::string folder = options_.directory + "/";
  if (options_.snapshot_format == SnapshotFormat::vtkhdf) {
    write_ice_vtkhdf(comm_, folder + stem + ".hdf", own, true);
    return stem + ".hdf";
  }
  std::vector<std::string> pieces;
  for (int rank = 0; rank < comm_.size(); ++rank)
    pieces.push_back(stem + "_p" + std::to_string(rank) + ".vtp");
  if (comm_.size() == 1) pieces = {stem + ".vtp"};
  act_together(comm_, [&] { write_ice_vtp(folder + pieces[comm_.rank()], own); });
  if (comm_.size() == 1) return pieces[0];
  act_together(comm_, [&] {
    if (comm_.is_root()) write_ice_pvtp(folder + stem + ".pvtp", pieces, true);
  });
  return stem + ".pvtp";
}

void Snapshots::write_pressure_and_lists(double time, const std::string& ice) {
  const std::string folder = options_.directory + "/";
  const std::string pressure = text("hull_pressure_%04zu.vtp", pressure_steps_.size());
  const std::vector<PressedQuad> pressed = pressure_.take(time);
  ice_steps_.emplace_back(time, ice);
  pressure_steps_.emplace_back(time, pressure);
  if (!comm_.is_root()) return;
  write_pressure_vtp(folder + pressure, hull_, pressed);
  if (options_.snapshot_format == SnapshotFormat::vtkhdf) {
    write_series(folder + "ice.hdf.series", ice_steps_);
  } else {
    write_pvd(folder + "ice.pvd", ice_steps_);
  }
  write_pvd(folder + "hull_pressure.pvd", pressure_steps_);
}

void Snapshots::write_picture(const SheetState& state, double advance, double hull_x,
                              const std::vector<CrackedPlace>& cracks) {
  const std::string name = text("ice_%03d.png", static_cast<int>(pictures_.size()));
  pictures_.push_back(name);
  picture_advance_.push_back(advance);
  if (!comm_.is_root()) return;
  const Box box = bounding_box(hull_);
  const double beam = box.upper.y() - box.lower.y(), half = std::min(0.5 * scenario_.sheet.width, 1.4 * beam);
  PictureFrame frame;
  frame.x_min = -0.3 * beam;
  frame.x_max = std::min(scenario_.sheet.length, scenario_.advance + 1.2 * beam);
  if (scenario_.sheet.window_ahead > 0.0) {
    frame.x_min = state.lattice.x(0);
    frame.x_max = state.lattice.x(state.lattice.nx - 1);
  }
  frame.y_min = -half;
  frame.y_max = half;
  frame.width_px = 1100;
  frame.section = true;
  frame.lambda = options_.lambda;
  frame.title = (options_.name.empty() ? "" : options_.name + ": ") +
                text("ice from above, %.1f m after first touch", advance * options_.lambda) +
                (options_.lambda > 1.0 ? text(", full scale (model 1:%g)", options_.lambda) : "");
  frame.channel = channel(state, hull_x);
  IceCloud ice = cloud(state);
  mark_cracks(ice, cracks);
  write_top_view(options_.directory + "/" + name, ice, hull_, hull_x, frame);
}

void Snapshots::write_animation() const {
  if (options_.directory.empty() || pictures_.size() < 2) return;
  act_together(comm_, [&] {
    if (!comm_.is_root()) return;
    std::vector<std::string> files;
    for (const std::string& name : pictures_) files.push_back(options_.directory + "/" + name);
    animate_pictures(options_.directory + "/" + animation_name, files);
  });
}

}  // namespace icebow
