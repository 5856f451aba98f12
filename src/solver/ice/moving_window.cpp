// The part of IceSheet that lets the lattice move with the ship.
#include <algorithm>
#include <cstring>

#include "solver/ice/sheet.h"

namespace icebow {

void IceSheet::drop_first_block(const Communicator& comm) {
  shift_fields(comm);
  shift_bonds(comm);
  find_cracks();
  hold_far_end_together();
  start_at(lattice.first + block);
}

// Waves are reflected where the far end is held: weak ice would break there, and be cracked before the ship
// comes. So the bonds of the last block do not break, until it is the last no more.
void IceSheet::hold_far_end_together() {
  const int last = lattice.blocks() - 1 - layout.i0 / block;
  const auto strengthen = [this](int b, double by) {
    if (b < 0 || b >= layout.blocks) return;
    for (int row = 0; row < layout.columns * layout.nz; ++row) {
      const std::size_t first = layout.row(row / layout.nz, row % layout.nz) + std::size_t(b) * block;
      for (std::size_t p = first; p < first + block; ++p)
        if (extra_strength[p] >= 0.0) extra_strength[p] = by;
    }
  };
  strengthen(last - 1, 0.0);
  strengthen(last, held_together);
}

void IceSheet::start_at(int first) {
  lattice.first = first;
}

// A rank hands its first block on to the west; the last rank's new one is at rest.
void IceSheet::shift_fields(const Communicator& comm) {
  std::vector<Field*> all;
  for (Field* group : {u, v, residual, acceleration})
    for (int c = 0; c < 3; ++c) all.push_back(&group[c]);
  all.push_back(&theta);
  all.push_back(&extra_strength);
  all.push_back(&crushed_depth);
  all.push_back(&touched_face);
  const std::size_t size = theta.element_size(), piece = block * size, rows = layout.columns * layout.nz;
  const std::size_t width = std::size_t(layout.blocks) * piece;
  std::vector<std::byte> outgoing(all.size() * rows * piece), incoming(outgoing.size());
  const auto for_rows = [&](auto visit) {
    std::size_t n = 0;
    for (Field* field : all)
      for (int jl = 0; jl < layout.columns; ++jl)
        for (int k = 0; k < layout.nz; ++k, n += piece) visit(field->bytes() + layout.row(jl, k) * size, n);
  };
  for_rows([&](std::byte* row, std::size_t n) { std::memcpy(&outgoing[n], row, piece); });
  comm.shift(outgoing.data(), partition.west, incoming.data(), partition.east, outgoing.size());
  for_rows([&](std::byte* row, std::size_t n) {
    std::memmove(row, row + piece, width - piece);
    std::memcpy(row + width - piece, &incoming[n], piece);
  });
}

// The block handed on, and those beside it, come from the rank that followed their bonds: of copies a rank
// follows only bonds of its own particles. What either has seen break is broken.
void IceSheet::shift_bonds(const Communicator& comm) {
  const std::size_t per_block = bits.per_block(), columns = layout.columns + reach, handed = 3 * per_block;
  const int blocks = layout.blocks;
  std::vector<std::uint16_t> words(columns * handed), east_words(words.size());
  std::vector<std::uint8_t> states(columns * layout.nz), east_states(states.size());
  for (int jl = -reach; jl < layout.columns; ++jl) {
    std::copy_n(bits.row(jl, 0) - per_block, handed, &words[(jl + reach) * handed]);
    for (int k = 0; k < layout.nz; ++k) states[(jl + reach) * layout.nz + k] = state(jl, k)[0];
  }
  comm.shift(words.data(), partition.west, east_words.data(), partition.east, words.size() * sizeof words[0]);
  comm.shift(states.data(), partition.west, east_states.data(), partition.east, states.size());
  for (int jl = -reach; jl < layout.columns; ++jl) {
    std::uint16_t* const column = bits.row(jl, 0);
    std::memmove(column - per_block, column, (blocks + 1) * per_block * sizeof(std::uint16_t));
    std::fill_n(column + blocks * per_block, per_block, std::uint16_t(0));
    for (int k = 0; k < layout.nz; ++k) {
      std::uint8_t* const row = state(jl, k);
      std::memmove(row - 1, row, blocks + 1);
      row[blocks - 1] = partition.east < 0 ? std::uint8_t(calm) : east_states[(jl + reach) * layout.nz + k];
    }
    if (partition.east >= 0) {
      const std::uint16_t* const from = &east_words[(jl + reach) * handed];
      std::uint16_t* const to = column + (blocks - 2) * std::ptrdiff_t(per_block);
      for (std::size_t n = 0; n < 2 * per_block; ++n) to[n] &= from[n];
      std::copy_n(from + 2 * per_block, per_block, to + 2 * per_block);
    }
    mend_bonds(jl);
  }
}

// At the ends of the lattice: bonds into the dropped block are gone, fresh ice is whole and bonded to what
// was the end before. Of copies too.
void IceSheet::mend_bonds(int jl) {
  const int j = layout.j0 + jl, last = lattice.blocks() - 1 - layout.i0 / block;
  const auto words_of = [&](int b, int k) { return bits.row(jl, k) + std::ptrdiff_t(b) * bits.per_block(); };
  const auto followed = [&](int b) { return b >= -1 && b <= layout.blocks; };
  for (int k = 0; k < layout.nz; ++k) {
    for (int s = 0; s < stencil.slots(k); ++s) {
      const Offset& o = stencil.half[k][s];
      if (partition.west < 0) {
        words_of(-1, k)[s] = 0;  // the dropped block's
        words_of(0, k)[s] &= BondBits::whole(lattice, o, layout.i0, j);
      }
      if (followed(last)) words_of(last, k)[s] = BondBits::whole(lattice, o, layout.i0 + last * block, j);
      if (o.di <= 0 || !followed(last - 1)) continue;
      const unsigned beyond = 0xffffu & ~(0xffffu >> o.di);
      words_of(last - 1, k)[s] |= BondBits::whole(lattice, o, layout.i0 + (last - 1) * block, j) & beyond;
    }
  }
}

}  // namespace icebow
