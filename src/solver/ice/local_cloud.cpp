#include "solver/ice/local_cloud.h"

#include "solver/ice/local_bonds.h"

namespace icebow {
namespace {

std::vector<float> damage(const NearbyParticles& near) {
  std::vector<std::uint8_t> initial(near.size()), broken(near.size());
  near.for_each_bond([&](std::int32_t a, std::int32_t b, bool alive) {
    ++initial[a];
    ++initial[b];
    broken[a] += !alive;
    broken[b] += !alive;
  });
  std::vector<float> values;
  near.for_each_own([&](int jl, int k, int il) {
    const std::int32_t n = near.number(jl, k, il);
    values.push_back(initial[n] ? float(broken[n]) / float(initial[n]) : 0.0f);
  });
  return values;
}

// Adds a half model's other half, beyond the plane y = 0. Pieces are there already.
void append_mirror_images(IceCloud& c) {
  const auto append = [](std::vector<float>& values, float sign) {
    const std::size_t n = values.size();
    for (std::size_t i = 0; i < n; ++i) values.push_back(sign * values[i]);
  };
  for (std::vector<float>* even : {&c.x, &c.z, &c.ux, &c.uz, &c.vx, &c.vz, &c.damage}) append(*even, 1.0f);
  for (std::vector<float>* odd : {&c.y, &c.uy, &c.vy}) append(*odd, -1.0f);
}

}  // namespace

IceCloud local_cloud(const Communicator& comm, const IceSheet& sheet) {
  const NearbyParticles near(sheet);
  const Lattice& lattice = sheet.lattice;
  IceCloud c;
  c.dx = lattice.dx;
  c.piece = local_pieces(comm, sheet);
  c.damage = damage(near);
  near.for_each_own([&](int jl, int k, int il) {
    const std::size_t p = sheet.layout.row(jl, k) + il;
    const auto at = [p](const auto& field) { return static_cast<float>(field[p]); };
    c.ux.push_back(at(sheet.u[0]));
    c.uy.push_back(at(sheet.u[1]));
    c.uz.push_back(at(sheet.u[2]));
    c.vx.push_back(at(sheet.v[0]));
    c.vy.push_back(at(sheet.v[1]));
    c.vz.push_back(at(sheet.v[2]));
    c.x.push_back(static_cast<float>(lattice.x(sheet.layout.i0 + il) + sheet.u[0][p]));
    c.y.push_back(static_cast<float>(lattice.y(sheet.layout.j0 + jl) + sheet.u[1][p]));
    c.z.push_back(static_cast<float>(lattice.z(k) + sheet.u[2][p]));
  });
  if (lattice.half) append_mirror_images(c);
  return c;
}

}  // namespace icebow
