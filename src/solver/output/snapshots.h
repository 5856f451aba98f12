// Files of a run on its way: ParaView steps and top-view pictures, equally spaced in advance.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "base/communicator.h"
#include "base/json.h"
#include "geometry/quad_mesh.h"
#include "solver/ice/sheet_state.h"
#include "solver/model/run_options.h"
#include "solver/step/stepper.h"

namespace icebow {

class Snapshots {
 public:
  // Throws RuntimeError where the directory cannot be written.
  Snapshots(const Communicator& comm, const QuadMesh& hull, const Scenario& scenario,
            const RunOptions& options);

  // Collective: writes what is due at this advance, and returns whether it did. The sheet is gathered on the
  // root for a picture only.
  bool write_due(const Stepper& stepper, double advance);

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
  void write_paraview(const Stepper& stepper);
  std::string write_ice(const std::string& stem, const IceCloud& own);
  void write_hull_and_lists(double time, double hull_x, const std::string& ice);
  void write_picture(const SheetState& state, double advance, double hull_x);

  const Communicator& comm_;
  const QuadMesh& hull_;
  const Scenario& scenario_;
  const RunOptions& options_;
  int snapshots_ = 0;  // written so far
  std::vector<std::pair<double, std::string>> ice_steps_, hull_steps_;
  std::vector<std::string> pictures_;
  std::vector<double> picture_advance_;
};

}  // namespace icebow
