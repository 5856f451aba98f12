#include "solver/ice/sheet_state.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "geometry/union_find.h"

namespace icebow {
namespace {

// What a rank sends, in this order: its partition, then of each column u and the bond words of its blocks, of
// the images below a symmetry plane the words alone.
struct Part {
  int block0, block1, j0, j1;
  int images;  // columns below j0
};

template <class T>
void append(std::vector<char>& bytes, const T* data, std::size_t n) {
  const char* p = reinterpret_cast<const char*>(data);
  bytes.insert(bytes.end(), p, p + n * sizeof(T));
}

std::vector<char> packed(const IceSheet& sheet) {
  const Layout& layout = sheet.layout;
  std::vector<char> bytes;
  const Part part{sheet.partition.block0, sheet.partition.block1, sheet.partition.j0, sheet.partition.j1,
                  sheet.at_symmetry_plane() ? reach : 0};
  append(bytes, &part, 1);
  for (int jl = -part.images; jl < layout.columns; ++jl) {
    for (int k = 0; k < layout.nz && jl >= 0; ++k) {
      const std::size_t row = layout.row(jl, k), n = std::size_t(layout.blocks) * block;
      for (const Field& u : sheet.u) {
        for (std::size_t p = row; p < row + n; ++p) {
          const float value = static_cast<float>(u.get(p));
          append(bytes, &value, 1);
        }
      }
    }
    append(bytes, sheet.bits.row(jl, 0), std::size_t(layout.blocks) * sheet.bits.per_block());
  }
  return bytes;
}

// Reads one rank's part: displacements, alive and initial bonds, and joins particles that a bond still holds
// together. What comes of a half model fills both halves of the state, whose lattice is whole.
class Unpacker {
 public:
  Unpacker(const IceSheet& sheet, SheetState& state, UnionFind& pieces)
      : lattice_(state.lattice),
        below_(sheet.lattice.mirrored_columns()),
        stencil_(sheet.stencil),
        state_(state),
        pieces_(pieces),
        initial_(lattice_.particles()),
        broken_(lattice_.particles()) {}

  void write_damage() {
    for (std::size_t id = 0; id < broken_.size(); ++id) {
      state_.damage[id] = initial_[id] ? float(broken_[id]) / float(initial_[id]) : 0.0f;
    }
  }

  void read(const std::vector<char>& bytes) {
    const char* p = bytes.data();
    Part part;
    std::memcpy(&part, p, sizeof part);
    p += sizeof part;
    const int n = (part.block1 - part.block0) * block;
    std::vector<float> values(n);
    std::vector<std::uint16_t> words(std::size_t(part.block1 - part.block0) * stencil_.column_slots());
    for (int j = part.j0 - part.images; j < part.j1; ++j) {
      for (int k = 0; k < lattice_.nz && j >= part.j0; ++k) {
        for (int c = 0; c < 3; ++c) {
          std::memcpy(values.data(), p, n * sizeof(float));
          p += n * sizeof(float);
          place_row(values, c, part.block0 * block, j, k);
        }
      }
      std::memcpy(words.data(), p, words.size() * sizeof(std::uint16_t));
      p += words.size() * sizeof(std::uint16_t);
      read_bonds(j, part.block0, words);
    }
  }

 private:
  void place_row(std::vector<float>& values, int component, int i0, int j, int k) {
    std::vector<float>& u = state_.u[component];
    const int real = std::min(static_cast<int>(values.size()), lattice_.nx - i0);
    std::copy_n(values.begin(), real, u.begin() + lattice_.id(i0, below_ + j, k));
    if (below_ == 0) return;
    if (component == 1)
      for (float& value : values) value = -value;
    std::copy_n(values.begin(), real, u.begin() + lattice_.id(i0, below_ - 1 - j, k));
  }

  void read_bonds(int j, int block0, const std::vector<std::uint16_t>& words) {
    const int blocks = static_cast<int>(words.size()) / stencil_.column_slots();
    for (int b = 0; b < blocks; ++b) {
      for (int k = 0; k < lattice_.nz; ++k) {
        const std::uint16_t* slot = &words[std::size_t(b) * stencil_.column_slots() + stencil_.first_slot[k]];
        for (int l = 0; l < block; ++l) {
          const int i = (block0 + b) * block + l;
          if (i < lattice_.nx) read_family(i, j, k, slot, l);
        }
      }
    }
  }

  // The bonds of (i, j, k) to higher ends, and their images unless they cross the plane: those come by
  // themselves.
  void read_family(int i, int j, int k, const std::uint16_t* words, int lane) {
    const std::vector<Offset>& offsets = stencil_.half[k];
    for (std::size_t s = 0; s < offsets.size(); ++s) {
      const int i2 = i + offsets[s].di, j2 = j + offsets[s].dj, k2 = k + offsets[s].dk;
      if (i2 < 0 || i2 >= lattice_.nx || j2 < 0 || below_ + j2 >= lattice_.ny) continue;
      const bool alive = words[s] >> lane & 1;
      add_bond(lattice_.id(i, below_ + j, k), lattice_.id(i2, below_ + j2, k2), alive);
      if (below_ > 0 && j >= 0)
        add_bond(lattice_.id(i, below_ - 1 - j, k), lattice_.id(i2, below_ - 1 - j2, k2), alive);
    }
  }

  // Counts for both ends.
  void add_bond(std::int64_t id, std::int64_t other, bool alive) {
    ++initial_[id];
    ++initial_[other];
    if (alive) {
      pieces_.join(static_cast<std::int32_t>(id), static_cast<std::int32_t>(other));
    } else {
      ++broken_[id];
      ++broken_[other];
    }
  }

  const Lattice& lattice_;
  const int below_;  // columns of the state below column 0 of the parts
  const Stencil& stencil_;
  SheetState& state_;
  UnionFind& pieces_;
  std::vector<std::uint8_t> initial_, broken_;  // bonds of each particle
};

// Pieces tied to a held edge stand (the largest one where nothing is held); floes are at least (2h)^2 h.
void number_pieces(const IceSheet& sheet, UnionFind& set, SheetState& state) {
  const Lattice& lattice = state.lattice;
  const int below = sheet.lattice.mirrored_columns();
  const std::size_t n = lattice.particles();
  std::vector<int> size(n, 0);
  std::vector<char> standing(n, 0);
  bool any_standing = false;
  for (int j = 0; j < lattice.ny; ++j) {
    for (int k = 0; k < lattice.nz; ++k) {
      for (int i = 0; i < lattice.nx; ++i) {
        const std::int32_t root = set.find(static_cast<std::int32_t>(lattice.id(i, j, k)));
        ++size[root];
        if (!sheet.held(i, j < below ? below - 1 - j : j - below)) continue;
        standing[root] = 1;
        any_standing = true;
      }
    }
  }
  if (!any_standing) standing[std::max_element(size.begin(), size.end()) - size.begin()] = 1;

  const int floe_size = 4 * lattice.nz * lattice.nz * lattice.nz;
  std::vector<std::int32_t> floes;
  for (std::size_t root = 0; root < n; ++root) {
    if (!standing[root] && size[root] >= floe_size) floes.push_back(static_cast<std::int32_t>(root));
  }
  std::stable_sort(floes.begin(), floes.end(), [&](int a, int b) { return size[a] > size[b]; });
  std::vector<std::int32_t> number(n, -1);
  for (std::size_t root = 0; root < n; ++root) {
    if (standing[root]) number[root] = 0;
  }
  for (std::size_t f = 0; f < floes.size(); ++f) number[floes[f]] = static_cast<std::int32_t>(f) + 1;
  for (std::size_t id = 0; id < n; ++id) state.piece[id] = number[set.find(static_cast<std::int32_t>(id))];
  state.floes = static_cast<int>(floes.size());
}

}  // namespace

SheetState gather_state(const Communicator& comm, const IceSheet& sheet) {
  const std::vector<std::vector<char>> parts = comm.gather(packed(sheet));
  SheetState state;
  state.lattice = whole_sheet(sheet.lattice);
  if (!comm.is_root()) return state;
  const std::size_t n = state.lattice.particles();
  for (std::vector<float>& u : state.u) u.resize(n);
  state.damage.resize(n);
  state.piece.resize(n);
  UnionFind set(n);
  Unpacker unpacker(sheet, state, set);
  for (const std::vector<char>& bytes : parts) unpacker.read(bytes);
  unpacker.write_damage();
  number_pieces(sheet, set, state);
  return state;
}

ChannelEdges channel_edges(const SheetState& state, int i) {
  const Lattice& lattice = state.lattice;
  const auto stands = [&](int j) { return state.piece[lattice.id(i, j, lattice.nz - 1)] == 0; };
  int j_hi = lattice.ny / 2, j_lo = j_hi - 1;
  while (j_hi < lattice.ny && !stands(j_hi)) ++j_hi;
  while (j_lo >= 0 && !stands(j_lo)) --j_lo;
  return {lattice.y(j_lo) + 0.5 * lattice.dx, lattice.y(j_hi) - 0.5 * lattice.dx};
}

double channel_width(const SheetState& state, int i) {
  const ChannelEdges edges = channel_edges(state, i);
  return std::round((edges.port - edges.starboard) / state.lattice.dx) * state.lattice.dx;
}

IceCloud cloud(const SheetState& state) {
  const Lattice& lattice = state.lattice;
  IceCloud c;
  c.dx = lattice.dx;
  c.ux = state.u[0];
  c.uy = state.u[1];
  c.uz = state.u[2];
  c.damage = state.damage;
  c.piece = state.piece;
  for (int j = 0; j < lattice.ny; ++j) {
    for (int k = 0; k < lattice.nz; ++k) {
      for (int i = 0; i < lattice.nx; ++i) {
        const std::int64_t id = lattice.id(i, j, k);
        c.x.push_back(static_cast<float>(lattice.x(i) + state.u[0][id]));
        c.y.push_back(static_cast<float>(lattice.y(j) + state.u[1][id]));
        c.z.push_back(static_cast<float>(lattice.z(k) + state.u[2][id]));
      }
    }
  }
  return c;
}

void measure_sheet(const SheetState& state, double x_from, double x_to, double beam, Metrics& metrics) {
  const Lattice& lattice = state.lattice;
  const double V = lattice.particle_volume();
  std::int64_t crushed = 0, broken = 0;
  for (std::int32_t piece : state.piece) {
    crushed += piece < 0;
    broken += piece != 0;
  }
  metrics.crushed_volume = crushed * V;
  metrics.broken_volume = broken * V;
  metrics.floes = state.floes;

  double damage = 0.0, width = 0.0;
  int met = 0, stations = 0;
  for (int i = 0; i < lattice.nx; ++i) {
    const double x = lattice.x(i);
    if (x > x_to) break;
    if (x >= x_from) {
      width += channel_width(state, i);
      ++stations;
    }
    for (int j = 0; j < lattice.ny; ++j) {
      if (std::abs(lattice.y(j)) > 0.5 * beam) continue;
      for (int k = 0; k < lattice.nz; ++k, ++met) damage += state.damage[lattice.id(i, j, k)];
    }
  }
  metrics.mean_damage = met ? damage / met : std::nan("");
  metrics.channel_width = stations ? width / stations : std::nan("");
  metrics.channel_width_over_beam = metrics.channel_width / beam;
}

}  // namespace icebow
