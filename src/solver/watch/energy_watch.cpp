#include "solver/watch/energy_watch.h"

#include <algorithm>
#include <cmath>

namespace icebow {
namespace {

constexpr std::int64_t steps_per_evaluation = 1000;
// Share of the work done: above what sound runs show (docs/verification.md), far below a blow-up.
constexpr double tolerated = 0.25;

double gain(const HistoryRow& row) {
  return row.hull_work - row.contact_loss;
}

}  // namespace

EnergyWatch::EnergyWatch(const Communicator& comm, const Stepper& stepper, const Scenario& s,
                         std::int64_t steps_per_sample)
    : comm_(comm),
      model_(stepper.ledger().model()),
      copies_(stepper.sheet().lattice.copies()),
      samples_per_evaluation_((steps_per_evaluation + steps_per_sample - 1) / steps_per_sample),
      floor_(0.5 * s.ice.rho * std::pow(s.ice.h, 3) * s.V * s.V) {
  const EnergyCounts own = sheet_energy(stepper.sheet(), model_);
  std::int64_t counts[4] = {own.kinetic, own.potential, own.elastic, own.fracture};
  comm_.sum(counts, 4);
  const Energies e = joules(counts);
  start_ = e.kinetic + e.potential + e.elastic;
  fracture_at_start_ = e.fracture;
}

EnergyWatch::Energies EnergyWatch::joules(const std::int64_t* counts) const {
  const double q = copies_ * model_.quantum;
  return {counts[0] * q, counts[1] * q, counts[2] * q, counts[3] * q};
}

void EnergyWatch::sample(const Stepper& stepper, HistoryRow& row) {
  const bool with_bonds = ++samples_ % samples_per_evaluation_ == 0;
  const IceSheet& sheet = stepper.sheet();
  const EnergyCounts ice = with_bonds ? sheet_energy(sheet, model_) : motion_energy(sheet, model_);
  const EnergyCounts& dropped = stepper.dropped();
  const ContactCounts& contact = stepper.ledger().counts();
  const SurroundingsCounts& given = stepper.given_away();
  std::int64_t counts[13] = {ice.kinetic,       ice.potential,     ice.elastic,     ice.fracture,
                             dropped.kinetic,   dropped.potential, dropped.elastic, dropped.fracture,
                             contact.hull_work, contact.gain,      given.water,     given.floes,
                             given.edges};
  comm_.sum(counts, 13);
  const Energies e = joules(counts), gone = joules(counts + 4);
  const double joule = copies_ * model_.quantum;
  row.hull_work = counts[8] * joule;
  row.contact_loss = (counts[8] - counts[9]) * joule;
  row.water_loss = counts[10] * joule;
  row.floe_loss = counts[11] * joule;
  row.edge_loss = counts[12] * joule;
  // What a moving window has dropped counts as still there, and so does what the surroundings have taken.
  gone_ = gone.kinetic + gone.potential + gone.elastic + row.water_loss + row.floe_loss + row.edge_loss;
  row.kinetic_energy = e.kinetic;
  row.potential = e.potential;
  if (with_bonds) {
    row.elastic = e.elastic;
    row.fracture = fracture_ = e.fracture + gone.fracture - fracture_at_start_;
    row.balance_error = e.kinetic + e.potential + e.elastic + row.fracture + gone_ - start_ - gain(row);
  }
  judge(row);
}

// Between evaluations the elastic energy is unknown but not negative, and fracture energy only grows: what is
// left is a lower bound of the balance.
void EnergyWatch::judge(const HistoryRow& row) {
  const double bound = row.kinetic_energy + row.potential + fracture_ + gone_ - start_ - gain(row);
  const double balance = std::isnan(row.balance_error) ? bound : row.balance_error;
  const double allowed = tolerated * (std::abs(row.hull_work) + std::abs(start_)) + floor_;
  surplus_ = balance - lowest_ > allowed ? balance - lowest_ : 0.0;
  if (!std::isnan(row.balance_error)) lowest_ = std::min(lowest_, row.balance_error);
}

}  // namespace icebow
