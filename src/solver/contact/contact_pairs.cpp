#include "solver/contact/contact_pairs.h"

#include <algorithm>
#include <numeric>
#include <tuple>

#include "geometry/point_cells.h"
#include "solver/ice/bond_query.h"
#include "solver/ice/near_cracks.h"

namespace icebow {
namespace {

constexpr int numbers = 6;  // of a candidate: place in the lattice, position
// Cells reach so many thicknesses above and below the sheet: about a ship's draught.
constexpr double thicknesses = 12.0;

}  // namespace

ContactPairs::Particle ContactPairs::state(const IceSheet& sheet, const Own& own) {
  const std::size_t p = own.address;
  return {Vec3(sheet.lattice.x(own.i) + sheet.u[0][p], sheet.lattice.y(own.j) + sheet.u[1][p],
               sheet.lattice.z(own.k) + sheet.u[2][p]),
          Vec3(sheet.v[0][p], sheet.v[1][p], sheet.v[2][p])};
}

void ContactPairs::find(const IceSheet& sheet) {
  const Layout& layout = sheet.layout;
  all_.clear();
  partners_.clear();
  own_.clear();
  std::vector<double> mine;
  near_cracks(comm_, sheet, [&](int jl, int k, int il) {
    own_.push_back({layout.i0 + il, layout.j0 + jl, k, layout.row(jl, k) + il});
    const Own& own = own_.back();
    const Vec3 x = state(sheet, own).position;
    mine.insert(mine.end(), {double(own.i), double(own.j), double(k), x.x(), x.y(), x.z()});
  });
  const std::vector<double> sizes = comm_.gather_everywhere({double(own_.size())});
  const int first = static_cast<int>(std::accumulate(sizes.begin(), sizes.begin() + comm_.rank(), 0.0));
  pair_up(sheet, candidates(comm_.gather_everywhere(mine), sheet.lattice.half), first);
  keep_used(first);
  refresh(sheet);
}

std::vector<ContactPairs::Candidate> ContactPairs::candidates(const std::vector<double>& everyone,
                                                              bool half) const {
  std::vector<Candidate> all;
  const int count = static_cast<int>(everyone.size() / numbers);
  for (int n = 0; n < count; ++n) {
    const double* v = &everyone[std::size_t(numbers) * n];
    all.push_back({int(v[0]), int(v[1]), int(v[2]), Vec3(v[3], v[4], v[5]), false, n});
  }
  for (int n = 0; half && n < count; ++n) {
    Candidate image = all[n];
    if (image.position.y() >= within_) continue;
    image.j = -1 - image.j;
    image.position.y() = -image.position.y();
    image.image = true;
    all.push_back(image);
  }
  return all;
}

// Partners by their number among all candidates, for now.
void ContactPairs::pair_up(const IceSheet& sheet, const std::vector<Candidate>& all, int first) {
  const Lattice& lattice = sheet.lattice;
  std::vector<Vec3> positions;
  for (const Candidate& c : all) positions.push_back(c.position);
  const double side = 0.5 * lattice.width(), depth = thicknesses * lattice.nz * lattice.dx;
  const PointCells cells(positions, {lattice.x(0), lattice.half ? -within_ : -side, -depth},
                         {lattice.x(lattice.nx), side, depth}, within_);
  const BondQuery bonds(sheet);
  std::vector<const Candidate*> found;
  for (int n = 0; n < static_cast<int>(own_.size()); ++n) {
    const Candidate& self = all[first + n];
    found.clear();
    cells.for_each_near(self.position, [&](int m) {
      const Candidate& other = all[m];
      if (m != first + n && !bonds.alive({self.i, self.j, self.k}, {other.i, other.j, other.k}))
        found.push_back(&other);
    });
    if (found.empty()) continue;
    std::sort(found.begin(), found.end(), [](const Candidate* a, const Candidate* b) {
      return std::tie(a->j, a->k, a->i) < std::tie(b->j, b->k, b->i);
    });
    const int begin = static_cast<int>(partners_.size());
    for (const Candidate* other : found) partners_.push_back({other->origin, other->image});
    all_.push_back({own_[n].address, first + n, begin, static_cast<int>(partners_.size())});
  }
}

// Who lends which particles to others; and from numbers among all candidates to places in particles_.
void ContactPairs::keep_used(int first) {
  const int count = static_cast<int>(own_.size());
  const auto is_own = [&](int n) { return n >= first && n < first + count; };
  std::vector<double> needed;
  for (const Partner& p : partners_) {
    if (!is_own(p.particle)) needed.push_back(p.particle);
  }
  std::vector<double> wanted = comm_.gather_everywhere(needed);
  std::sort(wanted.begin(), wanted.end());
  wanted.erase(std::unique(wanted.begin(), wanted.end()), wanted.end());
  shared_ = !wanted.empty();

  std::vector<int> place(count, -1);
  std::vector<Own> used;
  const auto use = [&](int n) {
    int& at = place[n - first];
    if (at < 0) {
      at = static_cast<int>(used.size());
      used.push_back(own_[n - first]);
    }
    return at;
  };
  for (Of& of : all_) of.particle = use(of.particle);
  lent_.clear();
  for (const double n : wanted) {
    if (is_own(int(n))) lent_.push_back(use(int(n)));
  }
  for (Partner& p : partners_) {
    if (is_own(p.particle)) p.particle = -1 - use(p.particle);
  }
  own_ = used;
  for (Partner& p : partners_) {
    const auto among = std::lower_bound(wanted.begin(), wanted.end(), double(p.particle)) - wanted.begin();
    p.particle = p.particle < 0 ? -1 - p.particle : static_cast<int>(own_.size() + among);
  }
  particles_.assign(own_.size() + wanted.size(), Particle{Vec3::Zero(), Vec3::Zero()});
}

void ContactPairs::refresh(const IceSheet& sheet) {
  for (std::size_t n = 0; n < own_.size(); ++n) particles_[n] = state(sheet, own_[n]);
  if (!shared_) return;
  std::vector<double> lent;
  for (const int n : lent_) {
    const Particle& p = particles_[n];
    lent.insert(lent.end(), {p.position.x(), p.position.y(), p.position.z(), p.velocity.x(), p.velocity.y(),
                             p.velocity.z()});
  }
  // In rank order, as the candidates are: `wanted`, one after the other.
  const std::vector<double> borrowed = comm_.gather_everywhere(lent);
  for (std::size_t n = 0; n < borrowed.size() / 6; ++n) {
    const double* v = &borrowed[6 * n];
    particles_[own_.size() + n] = {Vec3(v[0], v[1], v[2]), Vec3(v[3], v[4], v[5])};
  }
}

}  // namespace icebow
