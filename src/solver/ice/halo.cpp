#include "solver/ice/halo.h"

#include <algorithm>
#include <cstring>
#include <utility>

#include "base/communicator_native.h"

namespace icebow {
namespace {

constexpr int most_chunks = 4;
constexpr int tags_per_channel = 64;

// Chunks of columns of about equal size, none thinner than the reach of a bond.
std::vector<int> chunk_ends(int columns) {
  const int n = std::clamp(columns / (2 * reach), 1, most_chunks);
  std::vector<int> ends;
  for (int c = 0; c <= n; ++c) ends.push_back(columns * c / n);
  return ends;
}

// One of the nine directions as a number.
int direction(int dx, int dy) {
  return (dx + 1) + 3 * (dy + 1);
}

}  // namespace

struct Halo::Message {
  int peer, send_tag, receive_tag;
  Region own, ghost;
  std::vector<std::byte> outgoing, incoming;
  MPI_Request requests[2] = {MPI_REQUEST_NULL, MPI_REQUEST_NULL};  // receive, send
};

Halo::Halo(const Communicator& comm, const Partition& partition, const Layout& layout,
           std::vector<Field*> fields, int blocks_deep, int channel)
    : comm_(comm),
      part_(partition),
      layout_(layout),
      fields_(std::move(fields)),
      channel_(channel),
      chunk_ends_(chunk_ends(layout.columns)) {
  groups_.resize(chunk(chunks()));
  const int depth = blocks_deep * block, width = layout.blocks * block, n = layout.columns;
  for (int dy : {-1, 1}) {
    const int group = dy < 0 ? south : north;
    const int own0 = dy < 0 ? 0 : n - reach, ghost0 = dy < 0 ? -reach : n;
    add(group, 0, dy, 0, {own0, own0 + reach, 0, width}, {ghost0, ghost0 + reach, 0, width});
    add(group, -1, dy, 0, {own0, own0 + reach, 0, depth}, {ghost0, ghost0 + reach, -depth, 0});
    add(group, 1, dy, 0, {own0, own0 + reach, width - depth, width},
        {ghost0, ghost0 + reach, width, width + depth});
  }
  for (int c = 0; c < chunks(); ++c) {
    const int j0 = chunk_begin(c), j1 = chunk_end(c);
    add(chunk(c), -1, 0, c, {j0, j1, 0, depth}, {j0, j1, -depth, 0});
    add(chunk(c), 1, 0, c, {j0, j1, width - depth, width}, {j0, j1, width, width + depth});
  }
}

Halo::~Halo() {
  for (auto& group : groups_) {
    for (auto& m : group) MPI_Wait(&m->requests[1], MPI_STATUS_IGNORE);
  }
}

// The pair of messages with the neighbour in a direction: `own` goes there, `ghost` comes from there.
void Halo::add(int group, int dx, int dy, int chunk, const Region& own, const Region& ghost) {
  if (dx < 0 ? part_.west < 0 : dx > 0 && part_.east < 0) return;
  if (dy < 0 ? part_.south < 0 : dy > 0 && part_.north < 0) return;
  auto message = std::make_unique<Message>();
  message->peer = comm_.rank() + dx + dy * part_.px;
  const int base = channel_ * tags_per_channel + chunk;
  message->send_tag = base + most_chunks * direction(dx, dy);
  message->receive_tag = base + most_chunks * direction(-dx, -dy);
  message->own = own;
  message->ghost = ghost;
  message->outgoing.resize(size(own));
  message->incoming.resize(size(ghost));
  groups_[group].push_back(std::move(message));
}

std::size_t Halo::size(const Region& r) const {
  return fields_.size() * fields_[0]->element_size() * (r.jl1 - r.jl0) * layout_.nz * (r.x1 - r.x0);
}

void Halo::copy(const Region& r, std::vector<std::byte>& buffer, bool pack) const {
  std::byte* packed = buffer.data();
  for (Field* field : fields_) {
    const std::size_t size = field->element_size(), length = (r.x1 - r.x0) * size;
    for (int jl = r.jl0; jl < r.jl1; ++jl) {
      for (int k = 0; k < layout_.nz; ++k, packed += length) {
        std::byte* const row = field->bytes() + (std::ptrdiff_t(layout_.row(jl, k)) + r.x0) * size;
        if (pack) {
          std::memcpy(packed, row, length);
        } else {
          std::memcpy(row, packed, length);
        }
      }
    }
  }
}

void Halo::start() {
  for (auto& group : groups_) {
    for (auto& m : group) {
      MPI_Irecv(m->incoming.data(), static_cast<int>(m->incoming.size()), MPI_BYTE, m->peer, m->receive_tag,
                comm_.native()->comm, &m->requests[0]);
    }
  }
}

void Halo::send(int group) {
  for (auto& m : groups_[group]) {
    // The message of the step before. Not in wait(): the neighbour may take it later than it sends its own.
    MPI_Wait(&m->requests[1], MPI_STATUS_IGNORE);
    copy(m->own, m->outgoing, true);
    MPI_Isend(m->outgoing.data(), static_cast<int>(m->outgoing.size()), MPI_BYTE, m->peer, m->send_tag,
              comm_.native()->comm, &m->requests[1]);
  }
}

void Halo::wait(int group) {
  for (auto& m : groups_[group]) {
    MPI_Wait(&m->requests[0], MPI_STATUS_IGNORE);
    copy(m->ghost, m->incoming, false);
  }
}

void Halo::exchange() {
  start();
  for (int group = 0; group < chunk(chunks()); ++group) send(group);
  for (int group = 0; group < chunk(chunks()); ++group) wait(group);
}

std::size_t Halo::bytes_sent() const {
  std::size_t bytes = 0;
  for (const auto& group : groups_) {
    for (const auto& m : group) bytes += m->outgoing.size();
  }
  return bytes;
}

}  // namespace icebow
