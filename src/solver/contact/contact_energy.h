// What the hull does to the energy of the ice, strike by strike: equations (23) and (24) of docs/theory.md.
#pragma once

#include <vector>

#include "base/vec.h"
#include "solver/ice/energy.h"

namespace icebow {

// So far and of one rank, in quanta of the energy model.
struct ContactCounts {
  std::int64_t hull_work = 0;  // impulse on the ice . V
  std::int64_t gain = 0;  // of the ice: the rest is lost to friction, inelastic impact and moving particles
};

// What the hull did to a particle, by its place in the fields.
struct HullStrike {
  std::size_t p;
  Vec3 delta_v;  //!< [m/s]
  Vec3 push;     //!< of a relocation [m]
};

// The strikes of one step wait for the accelerations after it. The work of a relocation also needs the
// acceleration before it, which the drift uses up: so it is kept for all particles next to the surface.
class ContactLedger {
 public:
  explicit ContactLedger(const EnergyModel& model) : model_(model) {}

  // A particle (its place p in the fields, the reference height z of its row) near the hull but outside.
  void passed(std::size_t p, double z);
  void struck(std::size_t p, double z, const Vec3& v_before, const Vec3& delta_v, const Vec3& push);
  // When forces are known: the step's strikes are accounted for.
  void close_step(const IceSheet& sheet);
  // The strikes of the step closed last, by place.
  std::vector<HullStrike> strikes() const;
  // What its relocations did against forces that came after the step was closed.
  void add_work(std::int64_t quanta) { counts_.gain += quanta; }

  // The last step's particles next to the hull, five numbers each: number in the lattice, reference height,
  // acceleration. And back, from all ranks' lists in any order: a rank takes its own.
  std::vector<double> record(const IceSheet& sheet) const;
  void restore(const ContactCounts& counts, const std::vector<double>& record, const IceSheet& sheet);

  // A window that has dropped a block; `record` holds all ranks' particles as they were before.
  void move_window(std::vector<double> record, const IceSheet& sheet);

  const EnergyModel& model() const { return model_; }
  const ContactCounts& counts() const { return counts_; }
  // Whether the last step found the hull's surface at a particle within a distance [m] of a place.
  bool beside_hull(const IceSheet& sheet, const Vec3& position, double distance) const;

 private:
  struct Touch {
    std::size_t p;
    double z;  //!< reference height [m]
    Vec3 delta_v, push, acceleration;
    bool struck;
  };
  void account(const Touch& now, const Vec3& acceleration_before);

  EnergyModel model_;
  std::vector<Touch> now_, before_;
  ContactCounts counts_;
};

}  // namespace icebow
