// Copies of the neighbouring ranks' edges, corners included: `reach` columns along y, two blocks along x. The
// wider copy along x lets a rank follow the bonds of the neighbour's whole edge block, block by block as
// their owner does.
#pragma once

#include <vector>

#include "base/communicator.h"
#include "solver/lattice.h"

namespace icebow {

class Halo {
 public:
  Halo(const Communicator& comm, const Partition& partition, const Layout& layout);

  // Collective. Fills the ghosts of each field (a Layout's floats) with the owners' values: first along x,
  // then whole padded rows along y, so that corners arrive in two hops.
  void exchange(const std::vector<float*>& fields);

  std::size_t bytes_sent_per_field() const;

 private:
  void exchange_x(const std::vector<float*>& fields);
  void exchange_y(const std::vector<float*>& fields);
  void copy_columns(const std::vector<float*>& fields, std::ptrdiff_t first, std::vector<float>& buffer,
                    bool pack) const;

  const Communicator& comm_;
  Partition part_;
  Layout layout_;
  std::vector<float> send_[2], receive_[2];
};

}  // namespace icebow
