#include "solver/contact/contact_energy.h"

#include <algorithm>

namespace icebow {

void ContactLedger::passed(std::size_t p, double z) {
  now_.push_back({p, z, Vec3::Zero(), Vec3::Zero(), Vec3::Zero(), false});
}

void ContactLedger::struck(std::size_t p, double z, const Vec3& v_before, const Vec3& delta_v,
                           const Vec3& push) {
  counts_.hull_work += model_.quanta(model_.mass * delta_v.x() * model_.V);
  counts_.gain += model_.quanta(model_.mass * delta_v.dot(v_before + 0.5 * delta_v));
  now_.push_back({p, z, delta_v, push, Vec3::Zero(), true});
}

std::vector<HullStrike> ContactLedger::strikes() const {
  std::vector<HullStrike> all;
  for (const Touch& touch : before_) {
    if (touch.struck) all.push_back({touch.p, touch.delta_v, touch.push});
  }
  return all;
}

void ContactLedger::close_step(const IceSheet& sheet) {
  // Columns move in any order.
  std::sort(now_.begin(), now_.end(), [](const Touch& a, const Touch& b) { return a.p < b.p; });
  auto before = before_.begin();
  for (Touch& now : now_) {
    for (int c = 0; c < 3; ++c) now.acceleration[c] = sheet.acceleration[c][now.p];
    now.acceleration.z() += model_.weight_and_lift(now.z + sheet.u[2][now.p]);
    while (before != before_.end() && before->p < now.p) ++before;
    const bool known = before != before_.end() && before->p == now.p;
    if (now.struck) account(now, known ? before->acceleration : now.acceleration);
  }
  before_.swap(now_);
  now_.clear();
}

// The trapezoidal work of the relocation, and of the late change of velocity: the last terms of eq. (24).
void ContactLedger::account(const Touch& now, const Vec3& acceleration_before) {
  const double work = 0.5 * model_.mass *
                      (model_.dt * now.acceleration.dot(now.delta_v) -
                       (acceleration_before + now.acceleration).dot(now.push));
  counts_.gain += model_.quanta(work);
}

std::vector<double> ContactLedger::record(const IceSheet& sheet) const {
  const Layout& layout = sheet.layout;
  std::vector<double> numbers;
  for (const Touch& touch : before_) {
    const Layout::Place at = layout.place(touch.p);
    const std::int64_t id = sheet.lattice.id(layout.i0 + at.il, layout.j0 + at.jl, at.k);
    const Vec3& a = touch.acceleration;
    numbers.insert(numbers.end(), {double(id), touch.z, a.x(), a.y(), a.z()});
  }
  return numbers;
}

void ContactLedger::restore(const ContactCounts& counts, const std::vector<double>& record,
                            const IceSheet& sheet) {
  const Lattice& lattice = sheet.lattice;
  const Layout& layout = sheet.layout;
  counts_ = counts;
  before_.clear();
  for (std::size_t n = 0; n + 5 <= record.size(); n += 5) {
    if (!(record[n] >= 0.0 && record[n] < double(lattice.nx) * lattice.ny * lattice.nz)) continue;
    const std::int64_t id = static_cast<std::int64_t>(record[n]), row = id / lattice.nx;
    const int il = static_cast<int>(id % lattice.nx) - layout.i0;
    const int jl = static_cast<int>(row / lattice.nz) - layout.j0, k = static_cast<int>(row % lattice.nz);
    if (il < 0 || il >= layout.blocks * block || jl < 0 || jl >= layout.columns) continue;
    before_.push_back({layout.row(jl, k) + il, record[n + 1], Vec3::Zero(), Vec3::Zero(),
                       Vec3(record[n + 2], record[n + 3], record[n + 4]), false});
  }
  std::sort(before_.begin(), before_.end(), [](const Touch& a, const Touch& b) { return a.p < b.p; });
}

void ContactLedger::move_window(std::vector<double> record, const IceSheet& sheet) {
  std::vector<double> kept;
  for (std::size_t n = 0; n + 5 <= record.size(); n += 5) {
    if (static_cast<std::int64_t>(record[n]) % sheet.lattice.nx < block) continue;
    record[n] -= block;
    kept.insert(kept.end(), &record[n], &record[n] + 5);
  }
  restore(counts_, kept, sheet);
}

bool ContactLedger::beside_hull(const IceSheet& sheet, const Vec3& position, double distance) const {
  const Layout& layout = sheet.layout;
  for (const Touch& touch : before_) {
    const Layout::Place at = layout.place(touch.p);
    const Vec3 reference(sheet.lattice.x(layout.i0 + at.il), sheet.lattice.y(layout.j0 + at.jl), touch.z);
    const Vec3 u(sheet.u[0][touch.p], sheet.u[1][touch.p], sheet.u[2][touch.p]);
    if ((reference + u - position).norm() <= distance) return true;
  }
  return false;
}

}  // namespace icebow
