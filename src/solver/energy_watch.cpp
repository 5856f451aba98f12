#include "solver/energy_watch.h"

#include <algorithm>
#include <cmath>

namespace icebow {
namespace {

constexpr std::int64_t steps_per_evaluation = 600;
// Of the work done: above what is seen in sound runs (docs/verification.md), far below a blow-up.
constexpr double tolerated = 0.1;

}  // namespace

EnergyWatch::EnergyWatch(const Communicator& comm, const Stepper& stepper, const Scenario& s,
                         std::int64_t steps_per_sample)
    : comm_(comm),
      model_(stepper.ledger().model()),
      samples_per_evaluation_((steps_per_evaluation + steps_per_sample - 1) / steps_per_sample),
      floor_(0.5 * s.ice.rho * std::pow(s.ice.h, 3) * s.V * s.V) {
  const Energies e = evaluate(stepper.sheet());
  start_ = e.kinetic + e.potential + e.elastic;
  fracture_at_start_ = e.fracture;
}

EnergyWatch::Energies EnergyWatch::evaluate(const IceSheet& sheet) const {
  const EnergyCounts own = sheet_energy(sheet, model_);
  std::int64_t counts[4] = {own.kinetic, own.potential, own.elastic, own.fracture};
  comm_.sum(counts, 4);
  const double q = model_.quantum;
  return {counts[0] * q, counts[1] * q, counts[2] * q, counts[3] * q};
}

void EnergyWatch::sample(const Stepper& stepper, HistoryRow& row) {
  const ContactCounts& contact = stepper.ledger().counts();
  std::int64_t counts[4] = {contact.hull_work, contact.loss, contact.relocation,
                            potential_energy(stepper.sheet(), model_)};
  comm_.sum(counts, 4);
  row.hull_work = counts[0] * model_.quantum;
  row.contact_loss = counts[1] * model_.quantum;
  row.relocation = counts[2] * model_.quantum;
  row.potential = counts[3] * model_.quantum;
  if (++samples_ % samples_per_evaluation_ == 0) {
    const Energies e = evaluate(stepper.sheet());
    row.elastic = e.elastic;
    row.fracture = fracture_ = e.fracture - fracture_at_start_;
    const double gain = row.hull_work - row.contact_loss + row.relocation;
    row.balance_error = e.kinetic + e.potential + e.elastic + row.fracture - start_ - gain;
  }
  judge(row);
}

// Between evaluations the elastic energy is unknown but not negative, and fracture energy only grows: what is
// left is a lower bound of the balance.
void EnergyWatch::judge(const HistoryRow& row) {
  const double gain = row.hull_work - row.contact_loss + row.relocation;
  const double bound = row.kinetic_energy + row.potential + fracture_ - start_ - gain;
  const double balance = std::isnan(row.balance_error) ? bound : std::max(bound, row.balance_error);
  const double allowed = tolerated * (std::abs(row.hull_work) + std::abs(start_)) + floor_;
  surplus_ = balance - lowest_ > allowed ? balance - lowest_ : 0.0;
  if (!std::isnan(row.balance_error)) lowest_ = std::min(lowest_, row.balance_error);
}

}  // namespace icebow
