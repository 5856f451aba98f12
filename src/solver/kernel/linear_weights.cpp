#include "solver/kernel/linear_weights.h"

#include <algorithm>
#include <array>
#include <cstdlib>

namespace icebow {
namespace {

using Steps = std::array<int, 3>;  // di, dj, dk

std::map<Steps, Offset> all_offsets(const Stencil& stencil) {
  std::map<Steps, Offset> offsets;
  for (const auto& family : stencil.family)
    for (const Offset& o : family) offsets[{o.di, o.dj, o.dk}] = o;
  return offsets;
}

template <class Real>
std::vector<LinearGroup<Real>> make_groups(const std::map<Steps, Offset>& offsets, const Layout& layout,
                                           bool mirrored) {
  std::map<std::array<int, 2>, int> layers;  // of a column of neighbours: how far up
  for (const auto& [steps, offset] : offsets) {
    int& dk = layers[{steps[0], steps[1]}];
    dk = std::max(dk, std::abs(steps[2]));
  }
  std::map<std::tuple<int, bool>, LinearGroup<Real>> groups;
  for (const auto& [steps, reaches] : layers) {
    const auto [di, dj] = steps;
    if (mirrored && di < 0) continue;
    const bool pair = mirrored && di > 0;
    // Few long loops: the short columns get weights of zero.
    const int dk = std::max(reaches, std::min(2, layout.nz - 1));
    LinearGroup<Real>& group = groups[{dk, pair}];
    group.dk = dk;
    group.mirrored = pair;
    const std::ptrdiff_t across = std::ptrdiff_t(dj) * layout.nz * layout.stride;
    group.columns.push_back({across + di, across - di, static_cast<Real>(di), static_cast<Real>(dj)});
  }
  std::vector<LinearGroup<Real>> list;
  for (auto& [key, group] : groups) list.push_back(std::move(group));
  return list;
}

// Constants of the particles (i .. i + particles - 1, j, all layers).
template <class Real>
class WeightsBuilder {
 public:
  WeightsBuilder(const Lattice& lattice, const std::map<Steps, Offset>& offsets, BondWeights& bonds)
      : lattice_(lattice), offsets_(offsets), bonds_(bonds) {}

  LinearWeights<Real> build(const std::vector<LinearGroup<Real>>& groups, int i, int j, int particles) {
    LinearWeights<Real> w;
    w.groups = &groups;
    const int nz = lattice_.nz;
    own_dilatation_.assign(std::size_t(nz) * own_dilatation_constants * particles, 0.0);
    own_force_.assign(std::size_t(nz) * own_force_constants * particles, 0.0);
    for (const auto& group : groups) {
      for (const auto& column : group.columns) {
        for (int m = 0; m < nz; ++m) {
          for (int l = std::max(0, m - group.dk); l <= std::min(nz - 1, m + group.dk); ++l) {
            const Steps steps{static_cast<int>(column.di), static_cast<int>(column.dj), m - l};
            add(w, steps, group.mirrored, i, j, l, particles);
          }
        }
      }
    }
    w.own_dilatation.assign(own_dilatation_.begin(), own_dilatation_.end());
    w.own_force.assign(own_force_.begin(), own_force_.end());
    return w;
  }

 private:
  void add(LinearWeights<Real>& w, const Steps& steps, bool mirrored, int i, int j, int l, int particles) {
    const auto offset = offsets_.find(steps);  // not there: the particle itself
    const double dx = lattice_.dx;
    const std::size_t first = w.force.size();
    w.force.resize(first + 2 * std::size_t(particles));
    for (int p = 0; p < particles; ++p) {
      double W = 0.0, B = 0.0, A = 0.0;
      if (offset != offsets_.end()) {
        const BondWeight bond = bonds_(i + p, j, l, offset->second);
        const double L2 = offset->second.length * offset->second.length;
        W = bond.dilatation * dx / L2;
        B = bond.distortion * dx * dx / L2;
        A = bond.pressure * dx;
      }
      w.dilatation.push_back(static_cast<Real>(W));
      w.force[first + p] = static_cast<Real>(B);
      w.force[first + particles + p] = static_cast<Real>(A);
      add_own(steps, W, B, A, l, p, particles);
      if (mirrored) add_own({-steps[0], steps[1], steps[2]}, W, B, A, l, p, particles);
    }
  }

  void add_own(const Steps& xi, double W, double B, double A, int l, int p, int particles) {
    double* const d = &own_dilatation_[std::size_t(l) * own_dilatation_constants * particles + p];
    double* const f = &own_force_[std::size_t(l) * own_force_constants * particles + p];
    constexpr int pairs[6][2] = {{0, 0}, {1, 1}, {2, 2}, {0, 1}, {0, 2}, {1, 2}};
    for (int n = 0; n < 6; ++n) f[n * particles] += B * xi[pairs[n][0]] * xi[pairs[n][1]];
    for (int c = 0; c < 3; ++c) {
      d[c * particles] += W * xi[c];
      f[(6 + c) * particles] += A * xi[c];
    }
  }

  const Lattice& lattice_;
  const std::map<Steps, Offset>& offsets_;
  BondWeights& bonds_;
  std::vector<double> own_dilatation_, own_force_;
};

}  // namespace

template <class Real>
LinearTables<Real>::LinearTables(const Lattice& lattice, const Layout& layout, const Stencil& stencil,
                                 const Material& material, const BondTableOptions& options)
    : blocks_(layout.blocks) {
  const std::map<Steps, Offset> offsets = all_offsets(stencil);
  groups_.reset(
      new Groups{make_groups<Real>(offsets, layout, true), make_groups<Real>(offsets, layout, false)});
  BondWeights bonds(lattice, stencil, material, options);
  WeightsBuilder<Real> builder(lattice, offsets, bonds);
  for (int b = 0; b < blocks_; ++b) ends_.push_back(!is_interior(lattice, layout.i0 + b * block));
  for (int jl = 0; jl < layout.columns; ++jl) {
    const int j = layout.j0 + jl;
    for (int b = 0; b < blocks_; ++b) {
      const Class key{std::min(j + lattice.mirrored_columns(), edge_influence),
                      std::min(lattice.ny - 1 - j, edge_influence), ends_[b] ? b : -1};
      auto [entry, is_new] = weights_.try_emplace(key);
      if (is_new) {
        const int i = layout.i0 + b * block;
        entry->second =
            builder.build(ends_[b] ? groups_->single : groups_->mirrored, i, j, ends_[b] ? block : 1);
      }
      at_.push_back(&entry->second);
    }
  }
}

template class LinearTables<float>;
template class LinearTables<double>;

}  // namespace icebow
