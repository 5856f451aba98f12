#include "solver/watch/runaway.h"

#include <algorithm>
#include <cmath>

#include "base/text.h"

namespace icebow {
namespace {

using Place = Layout::Place;

Vec3 position(const IceSheet& sheet, const Place& at, std::size_t p) {
  const Vec3 reference(sheet.lattice.x(sheet.layout.i0 + at.il), sheet.lattice.y(sheet.layout.j0 + at.jl),
                       sheet.lattice.z(at.k));
  return reference + Vec3(sheet.u[0][p], sheet.u[1][p], sheet.u[2][p]);
}

// Extreme stretches of the particle's alive bonds to higher ends.
struct Stretches {
  double least = 0.0, most = 0.0;
};

Stretches stretches(const IceSheet& sheet, const Place& at, std::size_t p) {
  const Layout& layout = sheet.layout;
  const std::uint16_t* words =
      sheet.bits.row(at.jl, at.k) + std::ptrdiff_t(at.il / block) * sheet.bits.per_block();
  Stretches found;
  for (int s = 0; s < sheet.stencil.slots(at.k); ++s) {
    if (!((words[s] >> (at.il % block)) & 1)) continue;
    const Offset& o = sheet.stencil.half[at.k][s];
    const std::size_t q = p + (std::ptrdiff_t(o.dj) * layout.nz + o.dk) * layout.stride + o.di;
    const Vec3 y = Vec3(o.di, o.dj, o.dk) * sheet.lattice.dx + Vec3(double(sheet.u[0][q]) - sheet.u[0][p],
                                                                    double(sheet.u[1][q]) - sheet.u[1][p],
                                                                    double(sheet.u[2][q]) - sheet.u[2][p]);
    const double stretch = y.norm() / o.length - 1.0;
    found.least = std::min(found.least, stretch);
    found.most = std::max(found.most, stretch);
  }
  return found;
}

}  // namespace

std::string likely_cause(const Stepper& stepper, std::size_t p, double dt_limit) {
  const IceSheet& sheet = stepper.sheet();
  if (dt_limit > 0.0 && stepper.dt() > dt_limit)
    return text("the time step is %.3g times the stability limit", stepper.dt() / dt_limit);
  const Place at = sheet.layout.place(p);
  if (stepper.ledger().beside_hull(sheet, position(sheet, at, p), 2.0 * stepper.material().delta))
    return "contact: the hull is beside it; take a smaller time step or another contact rule";
  const Stretches found = stretches(sheet, at, p);
  if (found.least < -0.05 || found.most > 2.0 * stepper.material().s0)
    return text(
        "the ice there is strained from %.1f to %.1f %%, stiffer than the stability limit takes it to be; "
        "take a "
        "smaller time step",
        100.0 * found.least, 100.0 * found.most);
  return "not known: neither the hull nor strained ice is near; take a smaller time step";
}

}  // namespace icebow
