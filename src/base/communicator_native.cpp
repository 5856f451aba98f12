#include "base/communicator_native.h"

#include <cstdlib>

#include "base/errors.h"

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

void Communicator::broadcast(void* data, std::size_t bytes, int root) const {
  if (native_) MPI_Bcast(data, static_cast<int>(bytes), MPI_BYTE, root, native_->comm);
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

std::vector<std::vector<char>> Communicator::gather(const std::vector<char>& bytes, int root) const {
  if (!native_) return {bytes};
  const int length = static_cast<int>(bytes.size());
  std::vector<int> lengths(size_), starts(size_);
  MPI_Gather(&length, 1, MPI_INT, lengths.data(), 1, MPI_INT, root, native_->comm);
  std::size_t total = 0;
  for (int r = 0; r < size_; ++r) {
    starts[r] = static_cast<int>(total);
    total += lengths[r];
  }
  std::vector<char> all_bytes(rank_ == root ? total : 0);
  MPI_Gatherv(bytes.data(), length, MPI_BYTE, all_bytes.data(), lengths.data(), starts.data(), MPI_BYTE, root,
              native_->comm);
  std::vector<std::vector<char>> parts;
  if (rank_ != root) return parts;
  for (int r = 0; r < size_; ++r) {
    parts.emplace_back(all_bytes.begin() + starts[r], all_bytes.begin() + starts[r] + lengths[r]);
  }
  return parts;
}

void Communicator::shift(const void* outgoing, int to, void* incoming, int from, std::size_t bytes) const {
  if (!native_) return;
  const int n = static_cast<int>(bytes), tag = 1;
  MPI_Sendrecv(outgoing, n, MPI_BYTE, to < 0 ? MPI_PROC_NULL : to, tag, incoming, n, MPI_BYTE,
               from < 0 ? MPI_PROC_NULL : from, tag, native_->comm, MPI_STATUS_IGNORE);
}

std::vector<double> Communicator::gather_everywhere(const std::vector<double>& own) const {
  if (!native_) return own;
  const int length = static_cast<int>(own.size());
  std::vector<int> lengths(size_), starts(size_);
  MPI_Allgather(&length, 1, MPI_INT, lengths.data(), 1, MPI_INT, native_->comm);
  int total = 0;
  for (int r = 0; r < size_; ++r) {
    starts[r] = total;
    total += lengths[r];
  }
  std::vector<double> all(total);
  MPI_Allgatherv(own.data(), length, MPI_DOUBLE, all.data(), lengths.data(), starts.data(), MPI_DOUBLE,
                 native_->comm);
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
