// Files of a run on its way: ParaView steps and top-view pictures, equally spaced in advance.
#pragma once

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "base/communicator.h"
#include "base/json.h"
#include "geometry/quad_mesh.h"
#include "solver/ice/sheet_state.h"
#include "solver/model/run_options.h"
#include "solver/output/hull_pressure.h"
#include "solver/step/stepper.h"

namespace icebow {

using CracksSoFar = std::function<std::vector<CrackedPlace>()>;

class Snapshots {
 public:
  // Throws RuntimeError where the directory cannot be written.
  Snapshots(const Communicator& comm, const QuadMesh& hull, const Scenario& scenario,
            const RunOptions& options);

  // Collective, before the first step and after restore(): the hull, and the ParaView step of time 0 where
  // the run is there.
  void start(Stepper& stepper);
  // Collective, before record(): what the hull's contact has counted so far.
  void count_pressure(Stepper& stepper);
  // Collective, at every sample: writes what is due at this advance, and returns whether it did. The sheet is
  // gathered on the root for a picture only. `cracks` is asked where something is due, on every rank, and
  // says the same there.
  bool write_due(Stepper& stepper, double advance, const CracksSoFar& cracks);

  // Collective: of all pictures so far, where there are two or more.
  void write_animation() const;

  const std::vector<std::string>& pictures() const { return pictures_; }
  const std::vector<double>& picture_advance() const { return picture_advance_; }

  // What was written so far, as a checkpoint keeps it.
  Json record() const;
  void restore(const Json& record);
  // A run that is sailed on has its moments farther apart: what was written beyond those that are due at this
  // advance is forgotten, and its files are written over.
  void go_on(double advance);

 private:
  void write_paraview(const Stepper& stepper, const std::vector<CrackedPlace>& cracks);
  std::string write_ice(const std::string& stem, const IceCloud& own);
  void write_pressure_and_lists(double time, const std::string& ice);
  void write_picture(const SheetState& state, double advance, double hull_x,
                     const std::vector<CrackedPlace>& cracks);

  const Communicator& comm_;
  const QuadMesh& hull_;
  const Scenario& scenario_;
  const RunOptions& options_;
  int snapshots_ = 0;  // written so far, without that of time 0
  std::vector<std::pair<double, std::string>> ice_steps_, pressure_steps_;
  HullPressure pressure_;
  std::vector<std::string> pictures_;
  std::vector<double> picture_advance_;
};

}  // namespace icebow
