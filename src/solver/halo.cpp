#include "solver/halo.h"

#include "base/communicator_native.h"

namespace icebow {
namespace {

constexpr int depth_x = ghost_blocks * block;
constexpr int to_lower = 71, to_upper = 72;  // tags: towards smaller or larger x (then y)

}  // namespace

Halo::Halo(const Communicator& comm, const Partition& partition, const Layout& layout)
    : comm_(comm), part_(partition), layout_(layout) {}

void Halo::exchange(const std::vector<float*>& fields) {
  if (part_.px > 1) exchange_x(fields);
  if (part_.py > 1) exchange_y(fields);
}

void Halo::copy_columns(const std::vector<float*>& fields, std::ptrdiff_t first, std::vector<float>& buffer,
                        bool pack) const {
  std::size_t n = 0;
  for (float* field : fields) {
    for (int jl = 0; jl < layout_.columns; ++jl) {
      for (int k = 0; k < layout_.nz; ++k) {
        float* column = field + layout_.row(jl, k) + first;
        for (int c = 0; c < depth_x; ++c, ++n) {
          if (pack) {
            buffer[n] = column[c];
          } else {
            column[c] = buffer[n];
          }
        }
      }
    }
  }
}

void Halo::exchange_x(const std::vector<float*>& fields) {
  const std::size_t n = fields.size() * layout_.columns * layout_.nz * depth_x;
  const std::ptrdiff_t width = std::ptrdiff_t(layout_.blocks) * block;
  const int neighbour[2] = {part_.west, part_.east};
  const std::ptrdiff_t own[2] = {0, width - depth_x}, ghost[2] = {-depth_x, width};
  const MPI_Comm mpi = comm_.native()->comm;
  MPI_Request requests[4];
  int started = 0;
  for (int side = 0; side < 2; ++side) {
    if (neighbour[side] < 0) continue;
    receive_[side].resize(n);
    MPI_Irecv(receive_[side].data(), static_cast<int>(n), MPI_FLOAT, neighbour[side],
              side == 0 ? to_upper : to_lower, mpi, &requests[started++]);
  }
  for (int side = 0; side < 2; ++side) {
    if (neighbour[side] < 0) continue;
    send_[side].resize(n);
    copy_columns(fields, own[side], send_[side], true);
    MPI_Isend(send_[side].data(), static_cast<int>(n), MPI_FLOAT, neighbour[side],
              side == 0 ? to_lower : to_upper, mpi, &requests[started++]);
  }
  MPI_Waitall(started, requests, MPI_STATUSES_IGNORE);
  for (int side = 0; side < 2; ++side) {
    if (neighbour[side] >= 0) copy_columns(fields, ghost[side], receive_[side], false);
  }
}

void Halo::exchange_y(const std::vector<float*>& fields) {
  // `reach` columns of all layers are contiguous, ghosts along x included.
  const int n = static_cast<int>(reach * layout_.nz * layout_.stride);
  const int neighbour[2] = {part_.south, part_.north};
  const int own[2] = {0, layout_.columns - reach}, ghost[2] = {-reach, layout_.columns};
  const MPI_Comm mpi = comm_.native()->comm;
  std::vector<MPI_Request> requests;
  requests.reserve(4 * fields.size());
  const auto start_of = [&](float* field, int jl) { return field + layout_.row(jl, 0) - depth_x; };
  for (float* field : fields) {
    for (int side = 0; side < 2; ++side) {
      if (neighbour[side] < 0) continue;
      requests.emplace_back();
      MPI_Irecv(start_of(field, ghost[side]), n, MPI_FLOAT, neighbour[side], side == 0 ? to_upper : to_lower,
                mpi, &requests.back());
    }
  }
  for (float* field : fields) {
    for (int side = 0; side < 2; ++side) {
      if (neighbour[side] < 0) continue;
      requests.emplace_back();
      MPI_Isend(start_of(field, own[side]), n, MPI_FLOAT, neighbour[side], side == 0 ? to_lower : to_upper,
                mpi, &requests.back());
    }
  }
  MPI_Waitall(static_cast<int>(requests.size()), requests.data(), MPI_STATUSES_IGNORE);
}

std::size_t Halo::bytes_sent_per_field() const {
  const std::size_t x_sides = (part_.west >= 0) + (part_.east >= 0),
                    y_sides = (part_.south >= 0) + (part_.north >= 0);
  return sizeof(float) *
         (x_sides * layout_.columns * layout_.nz * depth_x + y_sides * reach * layout_.nz * layout_.stride);
}

}  // namespace icebow
