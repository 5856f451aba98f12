#include "base/everywhere_gather.h"

#include <numeric>
#include <utility>

#include "base/communicator_native.h"

namespace icebow {

struct EverywhereGather::Message {
  Communicator comm;
  std::vector<int> counts, offsets;
  std::vector<double> own, all;
  MPI_Request request = MPI_REQUEST_NULL;
  bool under_way = false;
};

EverywhereGather::EverywhereGather(const Communicator& comm, std::size_t own)
    : message_(new Message{comm, {}, {}, {}, {}}) {
  for (const double n : comm.gather_everywhere({double(own)})) {
    message_->offsets.push_back(static_cast<int>(message_->all.size()));
    message_->counts.push_back(static_cast<int>(n));
    message_->all.resize(message_->all.size() + static_cast<std::size_t>(n));
  }
}

// A message that nobody waits for any more may still arrive: its room stays.
EverywhereGather::~EverywhereGather() {
  if (message_ && message_->under_way) static_cast<void>(message_.release());
}

EverywhereGather::EverywhereGather(EverywhereGather&&) noexcept = default;
EverywhereGather& EverywhereGather::operator=(EverywhereGather&& other) noexcept {
  message_.swap(other.message_);
  return *this;
}

std::size_t EverywhereGather::size() const {
  return message_->all.size();
}

bool EverywhereGather::under_way() const {
  return message_->under_way;
}

void EverywhereGather::start(const std::vector<double>& own) {
  Message& m = *message_;
  m.own = own;
  m.under_way = true;
  if (const Communicator::Native* const native = m.comm.native())
    MPI_Iallgatherv(m.own.data(), m.counts[m.comm.rank()], MPI_DOUBLE, m.all.data(), m.counts.data(),
                    m.offsets.data(), MPI_DOUBLE, native->comm, &m.request);
}

const std::vector<double>& EverywhereGather::finish() {
  Message& m = *message_;
  if (m.comm.native()) {
    MPI_Wait(&m.request, MPI_STATUS_IGNORE);
  } else {
    m.all = m.own;
  }
  m.under_way = false;
  return m.all;
}

}  // namespace icebow
