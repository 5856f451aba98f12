// A free block of ice without a ship: set displacements, ask for dilatation and acceleration.
#pragma once

#include <algorithm>
#include <functional>

#include "base/communicator.h"
#include "base/vec.h"
#include "solver/ice/halo.h"
#include "solver/ice/mirror.h"
#include "solver/ice/sheet.h"

namespace icebow {

class IceBlock {
 public:
  explicit IceBlock(const Scenario& s, const Communicator& comm = Communicator::serial(),
                    const Kernels& kernel = kernels())
      : lattice(make_lattice(s)),
        material(make_material(s.ice, s.numerics.dx, s.numerics.horizon_ratio)),
        comm_(comm),
        sheet(s, lattice, make_partition(lattice, comm.rank(), comm.size()), material, kernel),
        displacements_(comm_, sheet.partition, sheet.layout, {&sheet.u[0], &sheet.u[1], &sheet.u[2]},
                       ghost_blocks, 0),
        dilatations_(comm_, sheet.partition, sheet.layout, {&sheet.theta}, 1, 1) {}

  using Function = std::function<Vec3(const Vec3&)>;

  template <class Visit>
  void for_each(Visit visit) const {
    for (int jl = 0; jl < sheet.layout.columns; ++jl)
      for (int k = 0; k < lattice.nz; ++k)
        for (int l = 0; l < sheet.layout.blocks * block && sheet.layout.i0 + l < lattice.nx; ++l)
          visit(sheet.layout.i0 + l, sheet.layout.j0 + jl, k, sheet.layout.row(jl, k) + l);
  }
  Vec3 position(int i, int j, int k) const { return {lattice.x(i), lattice.y(j), lattice.z(k)}; }

  void displace(const Function& u) {
    for_each([&](int i, int j, int k, std::size_t p) {
      const Vec3 value = u(position(i, j, k));
      for (int c = 0; c < 3; ++c) sheet.u[c][p] = value[c];
    });
  }

  // Dilatation and force of the displacements as they are; returns how many bonds broke.
  std::int64_t accelerate() {
    for (std::size_t p = 0; p < sheet.layout.size; ++p) {
      sheet.theta[p] = 0.0;
      for (Field& a : sheet.acceleration) a[p] = 0.0;
    }
    displacements_.exchange();
    mirror_displacements(sheet);
    const std::int64_t broken = sheet.dilatation();
    dilatations_.exchange();
    mirror_dilatations(sheet);
    sheet.force();
    return broken;
  }
  Vec3 acceleration(std::size_t p) const {
    return {sheet.acceleration[0][p], sheet.acceleration[1][p], sheet.acceleration[2][p]};
  }
  Vec3 velocity(std::size_t p) const { return {sheet.v[0][p], sheet.v[1][p], sheet.v[2][p]}; }
  double largest_acceleration() const {
    double largest = 0.0;
    for_each([&](int, int, int, std::size_t p) { largest = std::max(largest, acceleration(p).norm()); });
    return largest;
  }

  const Lattice lattice;
  const Material material;

 private:
  Communicator comm_;

 public:
  IceSheet sheet;

 private:
  Halo displacements_, dilatations_;
};

}  // namespace icebow
