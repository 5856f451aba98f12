// A group of ranks. MPI stays behind this wall: only communicator_native.cpp and solver/ice/halo.cpp include
// <mpi.h>.
//
// Two ways to be alone: without MPI at all (serial(), a program not started by mpirun) or as a group of one
// rank. Every call named collective must be made by all ranks of the group, with arguments of the same size.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace icebow {

class Communicator {
 public:
  static Communicator serial();  // one rank, MPI untouched

  int rank() const { return rank_; }
  int size() const { return size_; }
  bool is_root() const { return rank_ == 0; }

  // MPI counts in int, data here in std::size_t: what is larger than this many bytes travels in several
  // messages.
  static constexpr std::size_t largest_message = std::size_t(1) << 30;

  // Collective.
  Communicator split(int color) const;  // ranks of one colour form a group, in rank order
  void barrier() const;
  void broadcast(void* data, std::size_t bytes, int root = 0,
                 std::size_t most_at_once = largest_message) const;
  std::string broadcast(std::string text, int root = 0) const;
  void sum(std::int64_t* values, int n) const;  // exact, so independent of the number of ranks
  void sum(double* values, int n) const;        // order depends on MPI: never for anything compared bitwise
  double max(double value) const;
  bool all(bool value) const;  // true where every rank says true
  bool any(bool value) const;
  // Sends `bytes` to rank `to` while it receives as many from rank `from`; -1 = nobody. At most
  // largest_message.
  void shift(const void* outgoing, int to, void* incoming, int from, std::size_t bytes) const;
  // Every rank gets the numbers of all, in rank order.
  std::vector<double> gather_everywhere(const std::vector<double>& own,
                                        std::size_t most_at_once = largest_message) const;
  // Root gets every rank's bytes in rank order, the others get nothing.
  std::vector<std::vector<char>> gather(const std::vector<char>& bytes, int root = 0,
                                        std::size_t most_at_once = largest_message) const;

  struct Native;  // holds the MPI communicator; see communicator_native.h
  const Native* native() const { return native_.get(); }

  Communicator(std::shared_ptr<const Native> native, int rank, int size)
      : native_(std::move(native)), rank_(rank), size_(size) {}

 private:
  std::shared_ptr<const Native> native_;
  int rank_, size_;
};

// Collective: the words of the first rank that is in trouble; empty where none is.
std::string first_trouble(const Communicator& comm, const std::string& trouble);
// Collective: where any rank is in trouble all throw RuntimeError, with the words of the first that is.
void fail_together(const Communicator& comm, const std::string& trouble);

// The MPI library's name and version: "Open MPI v4.1.4".
std::string mpi_library();

// MPI for the lifetime of the program when mpirun started it, nothing otherwise.
class MpiSession {
 public:
  MpiSession(int& argc, char**& argv);
  ~MpiSession();
  MpiSession(const MpiSession&) = delete;
  MpiSession& operator=(const MpiSession&) = delete;

  static bool started_by_mpirun();
  Communicator world() const;

 private:
  bool active_;
};

}  // namespace icebow
