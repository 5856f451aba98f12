// Copies of the neighbouring ranks' edges, corners included: `reach` columns along y, whole blocks along x.
// The wider copy along x lets a rank follow the bonds of the neighbour's edge block as their owner does.
//
// Non-blocking, in groups that can be sent as soon as their particles are ready and waited for when they are
// needed: `south` and `north` (the edge columns, their corners with them), and chunks of columns whose edges
// go west and east. Messages are packed: a ghost is only written in wait().
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "base/communicator.h"
#include "solver/lattice/field.h"
#include "solver/lattice/lattice.h"

namespace icebow {

class Halo {
 public:
  // For these fields, with `blocks_deep` (at most ghost_blocks) blocks along x. Two halos that are in flight
  // together need different `channel`s (0, 1, ..).
  Halo(const Communicator& comm, const Partition& partition, const Layout& layout, std::vector<Field*> fields,
       int blocks_deep, int channel);
  ~Halo();
  Halo(const Halo&) = delete;
  Halo& operator=(const Halo&) = delete;

  static constexpr int south = 0, north = 1;
  static constexpr int chunk(int c) { return 2 + c; }
  int chunks() const { return static_cast<int>(chunk_ends_.size()) - 1; }
  // Columns [chunk_begin(c), chunk_end(c)) counted from the first owned one; each chunk but a single one
  // has at least `reach` columns.
  int chunk_begin(int c) const { return chunk_ends_[c]; }
  int chunk_end(int c) const { return chunk_ends_[c + 1]; }

  // Every rank makes the same calls, but no call waits for the others except wait(): start(), then send() and
  // wait() once for each group in any order that sends before it waits.
  void start();
  void send(int group);
  void wait(int group);
  void exchange();  // all of it at once

  std::size_t bytes_sent() const;  // by this rank in one exchange

 private:
  struct Region {
    int jl0, jl1, x0, x1;  // columns, floats from the first owned one
  };
  struct Message;
  void add(int group, int dx, int dy, int chunk, const Region& own, const Region& ghost);
  std::size_t size(const Region& region) const;
  void copy(const Region& region, std::vector<std::byte>& buffer, bool pack) const;

  Communicator comm_;
  Partition part_;
  Layout layout_;
  std::vector<Field*> fields_;
  int channel_;
  std::vector<int> chunk_ends_;
  std::vector<std::vector<std::unique_ptr<Message>>> groups_;
};

}  // namespace icebow
