#include "base/communicator_native.h"

#include <algorithm>
#include <cstdlib>

#include "base/collective.h"
#include "base/errors.h"
#include "base/mailbox.h"

namespace icebow {
namespace {

Communicator wrap(MPI_Comm comm, bool owned) {
  auto native = std::make_shared<Communicator::Native>();
  native->comm = comm;
  native->owned = owned;
  int rank = 0, size = 1;
  MPI_Comm_rank(comm, &rank);
  MPI_Comm_size(comm, &size);
  return Communicator(native, rank, size);
}

// send(offset, count) for each message of at most so many bytes.
template <class Send>
void in_messages(std::size_t bytes, std::size_t most_at_once, const Send& send) {
  for (std::size_t offset = 0; offset < bytes; offset += most_at_once)
    send(offset, static_cast<int>(std::min(most_at_once, bytes - offset)));
}

std::vector<std::uint64_t> everywhere(std::uint64_t own, int ranks, MPI_Comm comm) {
  std::vector<std::uint64_t> all(ranks);
  MPI_Allgather(&own, 1, MPI_UINT64_T, all.data(), 1, MPI_UINT64_T, comm);
  return all;
}

constexpr int gather_tag = 2, mail_tag = 3;

}  // namespace

Communicator::Native::~Native() {
  int finalized = 0;
  MPI_Finalized(&finalized);
  if (owned && !finalized) MPI_Comm_free(&comm);
}

Communicator Communicator::serial() {
  return Communicator(nullptr, 0, 1);
}

Communicator Communicator::split(int color) const {
  if (!native_) return *this;
  MPI_Comm part = MPI_COMM_NULL;
  MPI_Comm_split(native_->comm, color, rank_, &part);
  return wrap(part, true);
}

void Communicator::barrier() const {
  if (native_) MPI_Barrier(native_->comm);
}

void Communicator::broadcast(void* data, std::size_t bytes, int root, std::size_t most_at_once) const {
  if (!native_) return;
  in_messages(bytes, most_at_once, [&](std::size_t offset, int count) {
    MPI_Bcast(static_cast<char*>(data) + offset, count, MPI_BYTE, root, native_->comm);
  });
}

std::string Communicator::broadcast(std::string text, int root) const {
  std::uint64_t length = text.size();
  broadcast(&length, sizeof length, root);
  text.resize(length);
  broadcast(text.data(), length, root);
  return text;
}

void Communicator::sum(std::int64_t* values, int n) const {
  if (native_) MPI_Allreduce(MPI_IN_PLACE, values, n, MPI_INT64_T, MPI_SUM, native_->comm);
}

void Communicator::sum(double* values, int n) const {
  if (native_) MPI_Allreduce(MPI_IN_PLACE, values, n, MPI_DOUBLE, MPI_SUM, native_->comm);
}

double Communicator::max(double value) const {
  if (native_) MPI_Allreduce(MPI_IN_PLACE, &value, 1, MPI_DOUBLE, MPI_MAX, native_->comm);
  return value;
}

bool Communicator::all(bool value) const {
  return max(value ? 0.0 : 1.0) == 0.0;
}
bool Communicator::any(bool value) const {
  return max(value ? 1.0 : 0.0) == 1.0;
}

std::vector<std::vector<char>> Communicator::gather(const std::vector<char>& bytes, int root,
                                                    std::size_t most_at_once) const {
  if (!native_) return {bytes};
  const std::vector<std::uint64_t> lengths = everywhere(bytes.size(), size_, native_->comm);
  std::vector<std::vector<char>> parts;
  if (rank_ != root) {
    in_messages(bytes.size(), most_at_once, [&](std::size_t offset, int count) {
      MPI_Send(bytes.data() + offset, count, MPI_BYTE, root, gather_tag, native_->comm);
    });
    return parts;
  }
  for (int r = 0; r < size_; ++r) {
    if (r == root) {
      parts.push_back(bytes);
      continue;
    }
    parts.emplace_back(lengths[r]);
    in_messages(lengths[r], most_at_once, [&](std::size_t offset, int count) {
      MPI_Recv(parts.back().data() + offset, count, MPI_BYTE, r, gather_tag, native_->comm,
               MPI_STATUS_IGNORE);
    });
  }
  return parts;
}

void Communicator::shift(const void* outgoing, int to, void* incoming, int from, std::size_t bytes) const {
  if (!native_) return;
  const int n = static_cast<int>(bytes), tag = 1;
  MPI_Sendrecv(outgoing, to < 0 ? 0 : n, MPI_BYTE, to < 0 ? MPI_PROC_NULL : to, tag, incoming,
               from < 0 ? 0 : n, MPI_BYTE, from < 0 ? MPI_PROC_NULL : from, tag, native_->comm,
               MPI_STATUS_IGNORE);
}

std::vector<double> Communicator::gather_everywhere(const std::vector<double>& own,
                                                    std::size_t most_at_once) const {
  if (!native_) return own;
  const std::vector<std::uint64_t> lengths = everywhere(own.size(), size_, native_->comm);
  std::vector<std::uint64_t> starts(size_);
  for (int r = 1; r < size_; ++r) starts[r] = starts[r - 1] + lengths[r - 1];
  std::vector<double> all(starts.back() + lengths.back());
  if (all.size() * sizeof(double) <= most_at_once) {
    const std::vector<int> counts(lengths.begin(), lengths.end()), offsets(starts.begin(), starts.end());
    MPI_Allgatherv(own.data(), counts[rank_], MPI_DOUBLE, all.data(), counts.data(), offsets.data(),
                   MPI_DOUBLE, native_->comm);
    return all;
  }
  std::copy(own.begin(), own.end(), all.begin() + static_cast<std::ptrdiff_t>(starts[rank_]));
  for (int r = 0; r < size_; ++r)
    broadcast(all.data() + starts[r], lengths[r] * sizeof(double), r, most_at_once);
  return all;
}

std::string first_trouble(const Communicator& comm, const std::string& trouble) {
  const double turn = comm.max(trouble.empty() ? -1.0 : double(comm.size() - comm.rank()));
  return turn > 0.0 ? comm.broadcast(trouble, comm.size() - static_cast<int>(turn)) : std::string();
}

void fail_together(const Communicator& comm, const std::string& trouble) {
  const std::string first = first_trouble(comm, trouble);
  if (!first.empty()) throw RuntimeError(first);
}

std::string mpi_library() {
  char text[MPI_MAX_LIBRARY_VERSION_STRING] = "";
  int length = 0;
  MPI_Get_library_version(text, &length);
  const std::string words(text, static_cast<std::size_t>(length));
  return words.substr(0, words.find_first_of(",\n"));
}

void Mailbox::send(int to, const std::string& text) const {
  MPI_Send(text.data(), static_cast<int>(text.size()), MPI_CHAR, to, mail_tag, comm_.native()->comm);
}

std::optional<Mail> Mailbox::take() const {
  int there = 0, length = 0;
  MPI_Status status;
  MPI_Iprobe(MPI_ANY_SOURCE, mail_tag, comm_.native()->comm, &there, &status);
  if (there == 0) return {};
  MPI_Get_count(&status, MPI_CHAR, &length);
  Mail mail{status.MPI_SOURCE, std::string(static_cast<std::size_t>(length), '\0')};
  MPI_Recv(mail.text.data(), length, MPI_CHAR, mail.from, mail_tag, comm_.native()->comm, MPI_STATUS_IGNORE);
  return mail;
}

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

bool MpiSession::started_by_mpirun() {
  return std::getenv("OMPI_COMM_WORLD_SIZE") != nullptr || std::getenv("PMIX_RANK") != nullptr ||
         std::getenv("PMI_RANK") != nullptr;
}

MpiSession::MpiSession(int& argc, char**& argv) : active_(started_by_mpirun()) {
  if (active_) MPI_Init(&argc, &argv);
}

MpiSession::~MpiSession() {
  if (active_) MPI_Finalize();
}

Communicator MpiSession::world() const {
  return active_ ? wrap(MPI_COMM_WORLD, false) : Communicator::serial();
}

}  // namespace icebow
