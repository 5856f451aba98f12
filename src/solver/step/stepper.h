// The time step of one ship-ice run.
#pragma once

#include <cstdint>
#include <vector>

#include "base/communicator.h"
#include "solver/contact/contact.h"
#include "solver/ice/sheet.h"
#include "solver/ice/step_schedule.h"
#include "solver/lattice/stencil.h"
#include "solver/model/exact_sum.h"
#include "solver/model/phase_timer.h"
#include "solver/model/scenario.h"
#include "solver/step/surrounding_forces.h"

namespace icebow {

class Stepper {
 public:
  // The hull at the scenario's scale. `hull_x` is where its origin is at the start.
  Stepper(const Communicator& comm, const QuadMesh& hull, const Scenario& scenario, const Lattice& lattice,
          double dt, double hull_x);

  void step();

  double dt() const { return dt_; }
  std::int64_t steps() const { return steps_; }
  double time() const { return steps_ * dt_; }
  double hull_x() const { return start_x_ + V_ * time(); }
  // Whether one of the next so many steps begins with a move of the window.
  bool window_moves_within(std::int64_t steps) const { return window_is_due(steps_ + steps - 1); }
  // Whether a run that goes on from here later is the same, bit for bit; at every sample it is.
  bool may_pause() const { return surroundings_.may_pause(steps_); }
  const IceSheet& sheet() const { return sheet_; }
  IceSheet& sheet() { return sheet_; }
  const Material& material() const { return material_; }

  // Collective. To go on where another run was, whose sheet is there already; counts are of this rank.
  void restore(std::int64_t steps, std::int64_t broken_bonds, const ExactImpulse::Counts& impulse,
               const EnergyCounts& dropped, const SurroundingsCounts& given_away);

  const ExactImpulse& impulse() const { return impulse_; }
  // Of this rank, since the last take_impulse().
  ExactImpulse take_impulse();
  // Of this rank, as HullContact says.
  void watch_faces() { contact_.watch_faces(); }
  std::vector<std::int64_t> take_face_impulse() { return contact_.take_face_impulse(); }
  int contacts() const { return contacts_; }  // particles touching the hull now, this rank
  std::int64_t broken_bonds() const {
    return broken_bonds_;
  }  // so far, this rank's own as in IceSheet::bonds
  // Energy of the ice that a moving window has dropped, less that of what it laid; this rank's, in quanta.
  const EnergyCounts& dropped() const { return dropped_; }
  const ContactLedger& ledger() const { return ledger_; }
  ContactLedger& ledger() { return ledger_; }
  // Energy that the ice gave to the water, to other ice and to the damped edges; this rank's, in quanta.
  const SurroundingsCounts& given_away() const { return surroundings_.counts(); }
  PhaseTimer& timer() { return timer_; }

 private:
  bool window_is_due(std::int64_t steps) const;
  void move_window();
  void move(int jl0, int jl1);  // drift and contact of columns

  Communicator comm_;
  double dt_, V_, start_x_, window_ahead_;
  Material material_;
  IceSheet sheet_;
  HullContact contact_;
  DriftSettings drift_{};
  ExactImpulse impulse_, no_impulse_;
  ContactLedger ledger_;
  SurroundingForces surroundings_;
  EnergyCounts dropped_;
  PhaseTimer timer_;
  StepSchedule schedule_;
  std::int64_t steps_ = 0, broken_bonds_ = 0;
  int contacts_ = 0;
};

// Where the hull's frame starts so that its foremost point within the ice's thickness is at the sheet's edge
// x = 0.
double first_touch_x(const QuadMesh& hull, const Lattice& lattice);

}  // namespace icebow
