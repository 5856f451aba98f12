// Ice against ice: particles without a bond between them push each other back when they come nearer than a
// spacing. Equation (42) of docs/theory.md.
//
// Only ice near broken bonds is looked at. Pairs are found every pairs_every steps and at every sample, from
// displacements and bonds alone, so that a continued run finds the same ones; a bond that breaks in between
// is a pair from the next time on. Forces are whole multiples of a quantum: their sums are the same in any
// order and on any number of ranks, and what one particle gets the other loses.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "base/communicator.h"
#include "solver/contact/contact_energy.h"
#include "solver/contact/contact_pairs.h"
#include "solver/ice/energy.h"
#include "solver/ice/sheet.h"
#include "solver/model/scenario.h"

namespace icebow {

// Steps. Pairs are kept from a quarter of a spacing before they touch: ice that meets at less than 1/160 of
// its speed of sound, four times the ship's speed, is not missed.
constexpr int pairs_every = 40;

FloeContactLaw floe_contact_law(const Scenario& scenario, const Material& material);

// In quanta of the energy model.
struct FloeWork {
  std::int64_t taken = 0;    // from the ice, what the contacts store and give back included
  std::int64_t by_hull = 0;  // given to it by the hull's relocations against contacts
};

class FloeContact {
 public:
  FloeContact(const Communicator& comm, const Scenario& scenario, const Material& material,
              const EnergyModel& model);
  bool acts() const { return acts_; }

  // The ice has been renumbered since pairs were found.
  void renumbered() { pairs_.forget(); }
  // All collective.
  void find_pairs(const IceSheet& sheet);
  // The ice has moved: sends what other ranks need of it. May be left out.
  void send(const IceSheet& sheet) {
    if (acts_) pairs_.send(sheet);
  }
  // Adds to the accelerations of this rank's ice, which must hold the bonds' part and which the hull has
  // struck (by place).
  FloeWork apply(IceSheet& sheet, const std::vector<HullStrike>& strikes);

 private:
  using Force = std::array<std::int64_t, 3>;  // in quanta
  int find_touching();
  template <class Real>
  void add_forces(const IceSheet& sheet);
  template <class Real>
  double push(IceSheet& sheet, int n, const Vec3& force) const;
  template <class Real>
  FloeWork push_all(IceSheet& sheet, const std::vector<HullStrike>& strikes);

  bool acts_;
  FloeContactLaw law_;
  double quantum_;  //!< [N]
  EnergyModel model_;
  ContactPairs pairs_;
  // Of the step under way: forces on the own particles of the pairs; of the pairs that touch their number,
  // and what FloeTouches lists.
  std::vector<Force> forces_;
  std::vector<int> touching_;
  std::vector<double> away_[3], velocity_[3];
  std::vector<std::int64_t> force_[3];
};

}  // namespace icebow
