#include "solver/watch/crack_watch.h"

#include <algorithm>
#include <cmath>

namespace icebow {
namespace {

// What a rank tells the others of a column.
constexpr std::size_t event_values = 5;  // i, j, whether crushed, cos2, sin2

std::int64_t key(std::int64_t i, std::int64_t j) {
  return (i << 24) + j;
}

// Broken bonds of one column; integers, so the order in which they are met does not matter.
struct Tally {
  std::int64_t broken = 0, xx = 0, xy = 0, yy = 0;

  void add(const Offset& o) {
    ++broken;
    xx += o.di * o.di;
    xy += o.di * o.dj;
    yy += o.dj * o.dj;
  }
};

// Broken bonds of a rank's own columns. Every bond counts at both of its ends.
class Tallies {
 public:
  explicit Tallies(const IceSheet& sheet)
      : sheet_(sheet),
        layout_(sheet.layout),
        width_(layout_.blocks * block),
        tallies_(std::size_t(layout_.columns) * width_) {
    for (int jl = -reach; jl < layout_.columns; ++jl) {
      for (int b = -1; b <= layout_.blocks; ++b) {
        for (int k = 0; k < layout_.nz; ++k) add_block(jl, k, b);
      }
    }
  }

  const Tally& at(int jl, int il) const { return tallies_[std::size_t(jl) * width_ + il]; }

 private:
  void add_block(int jl, int k, int b) {
    const std::vector<Offset>& offsets = sheet_.stencil.half[k];
    const std::uint16_t* words = sheet_.bits.row(jl, k) + std::ptrdiff_t(b) * sheet_.bits.per_block();
    for (std::size_t s = 0; s < offsets.size(); ++s) {
      if (words[s] == 0xffffu) continue;  // most ice is whole
      const unsigned whole =
          BondBits::whole(sheet_.lattice, offsets[s], layout_.i0 + b * block, layout_.j0 + jl);
      for (unsigned broken = whole & ~unsigned(words[s]); broken != 0; broken &= broken - 1) {
        const int il = b * block + __builtin_ctz(broken);
        add(jl, il, offsets[s]);
        add(jl + offsets[s].dj, il + offsets[s].di, offsets[s]);
      }
    }
  }
  void add(int jl, int il, const Offset& o) {
    if (jl < 0 || jl >= layout_.columns || il < 0 || il >= width_) return;
    tallies_[std::size_t(jl) * width_ + il].add(o);
  }

  const IceSheet& sheet_;
  const Layout& layout_;
  int width_;
  std::vector<Tally> tallies_;
};

// Bonds that the particles of a column began with; those among themselves count for both ends.
std::int64_t initial_bonds(const IceSheet& sheet, int i, int j) {
  const Lattice& lattice = sheet.lattice;
  std::int64_t n = 0;
  for (const std::vector<Offset>& family : sheet.stencil.family) {
    for (const Offset& o : family) {
      const int i2 = i + o.di, j2 = j + o.dj;
      n += i2 >= 0 && i2 < lattice.nx && j2 >= -lattice.mirrored_columns() && j2 < lattice.ny;
    }
  }
  return n;
}

// Beside the edge where a moving window was cut, bonds are gone that nothing broke.
bool beside_cut(const Lattice& lattice, int i) {
  return lattice.first > 0 && i < reach;
}

}  // namespace

CrackWatch::CrackWatch(double dx, double advance_per_sample)
    : samples_per_look_(std::max<std::int64_t>(1, std::llround(std::floor(dx / advance_per_sample)))) {}

void CrackWatch::look(const Communicator& comm, const IceSheet& sheet, double advance) {
  const Tallies tallies(sheet);
  const Layout& layout = sheet.layout;
  std::vector<double> events;
  for (int jl = 0; jl < layout.columns; ++jl) {
    for (int il = 0; il < layout.blocks * block; ++il) {
      const Tally& t = tallies.at(jl, il);
      const int i = layout.i0 + il, j = layout.j0 + jl;
      if (t.broken == 0 || beside_cut(sheet.lattice, i)) continue;
      const std::int64_t initial = initial_bonds(sheet, i, j);
      if (4 * t.broken < initial) continue;
      const bool crushed = 4 * t.broken >= 3 * initial;
      const auto before = known_.find(key(sheet.lattice.first + i, j));
      if (before != known_.end() && (!crushed || std::isfinite(columns_[before->second].crushed))) continue;
      const double all = std::max(1.0, double(t.xx + t.yy));
      events.insert(events.end(), {double(sheet.lattice.first + i), double(j), double(crushed),
                                   double(t.xx - t.yy) / all, 2.0 * double(t.xy) / all});
    }
  }
  learn(comm.gather_everywhere(events), advance);
}

void CrackWatch::learn(const std::vector<double>& events, double advance) {
  const std::size_t old = columns_.size();
  for (std::size_t n = 0; n + event_values <= events.size(); n += event_values) {
    const double* e = &events[n];
    CrackedColumn column{static_cast<std::int64_t>(e[0]), static_cast<std::int64_t>(e[1]), advance};
    if (e[2] != 0.0) column.crushed = advance;
    column.cos2 = e[3];
    column.sin2 = e[4];
    const auto before = known_.find(key(column.i, column.j));
    if (before == known_.end()) {
      columns_.push_back(column);
    } else {
      columns_[before->second].crushed = advance;
    }
  }
  const auto fresh = columns_.begin() + static_cast<std::ptrdiff_t>(old);
  std::sort(fresh, columns_.end(),
            [](const auto& a, const auto& b) { return key(a.i, a.j) < key(b.i, b.j); });
  for (std::size_t n = old; n < columns_.size(); ++n) known_[key(columns_[n].i, columns_[n].j)] = n;
}

void CrackWatch::restore(std::vector<CrackedColumn> columns) {
  columns_ = std::move(columns);
  known_.clear();
  for (std::size_t n = 0; n < columns_.size(); ++n) known_[key(columns_[n].i, columns_[n].j)] = n;
}

}  // namespace icebow
