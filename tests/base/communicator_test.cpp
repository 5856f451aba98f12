#include <catch2/catch.hpp>
#include <numeric>

#include "base/collective.h"
#include "base/errors.h"
#include "tests/support/main.h"

using namespace icebow;

namespace {

// Other numbers, and another count of them, on every rank.
std::vector<double> numbers_of(int rank) {
  std::vector<double> numbers(3 + 5 * static_cast<std::size_t>(rank));
  std::iota(numbers.begin(), numbers.end(), 1000.0 * rank);
  return numbers;
}

std::vector<double> numbers_of_all(const Communicator& comm) {
  std::vector<double> all;
  for (int r = 0; r < comm.size(); ++r) {
    const std::vector<double> part = numbers_of(r);
    all.insert(all.end(), part.begin(), part.end());
  }
  return all;
}

struct Pair {
  std::int64_t id;
  float value;
};

}  // namespace

TEST_CASE("what is larger than a message arrives in several") {
  const Communicator& comm = test_world();
  for (const std::size_t most_at_once :
       {std::size_t(1), std::size_t(7), std::size_t(64), Communicator::largest_message}) {
    CAPTURE(most_at_once);
    CHECK(comm.gather_everywhere(numbers_of(comm.rank()), most_at_once) == numbers_of_all(comm));

    const std::string own(10 + 3 * static_cast<std::size_t>(comm.rank()),
                          static_cast<char>('a' + comm.rank()));
    const auto parts = comm.gather({own.begin(), own.end()}, 0, most_at_once);
    REQUIRE(parts.size() == (comm.is_root() ? static_cast<std::size_t>(comm.size()) : 0u));
    for (std::size_t r = 0; r < parts.size(); ++r)
      CHECK(std::string(parts[r].begin(), parts[r].end()) ==
            std::string(10 + 3 * r, static_cast<char>('a' + r)));

    std::vector<double> sent = numbers_of(comm.rank());
    sent.resize(8);
    comm.broadcast(sent.data(), sent.size() * sizeof(double), comm.size() - 1, most_at_once);
    std::vector<double> last = numbers_of(comm.size() - 1);
    last.resize(8);
    CHECK(sent == last);
  }
}

TEST_CASE("structs are gathered and broadcast, empty lists too") {
  const Communicator& comm = test_world();
  std::vector<Pair> own(static_cast<std::size_t>(comm.rank()), Pair{comm.rank(), 0.5f});  // none on the root
  const std::vector<Pair> all = gather(comm, own);
  CHECK(all.size() == (comm.is_root() ? static_cast<std::size_t>(comm.size() * (comm.size() - 1) / 2) : 0u));
  if (!all.empty()) CHECK(all.back().id == comm.size() - 1);

  std::vector<Pair> told;
  if (comm.is_root()) told = {{7, 1.5f}, {8, 2.5f}};
  broadcast(comm, told);
  REQUIRE(told.size() == 2);
  CHECK(told[1].id == 8);
  double number = comm.is_root() ? 3.0 : 0.0;
  broadcast(comm, number);
  CHECK(number == 3.0);
}

TEST_CASE("where one rank fails, all fail with its words") {
  const Communicator& comm = test_world();
  const int last = comm.size() - 1;
  const auto fails_on = [&](int rank) {
    return [&comm, rank] {
      if (comm.rank() == rank) throw RuntimeError("disk full on rank " + std::to_string(rank));
    };
  };
  CHECK_THROWS_WITH(act_together(comm, fails_on(last)), "disk full on rank " + std::to_string(last));
  CHECK_THROWS_WITH(act_on_root(comm, fails_on(0)), "disk full on rank 0");
  CHECK_NOTHROW(act_together(comm, [] {}));
  if (last > 0) CHECK_NOTHROW(act_on_root(comm, fails_on(last)));
}

TEST_CASE("numbers of all ranks travel while the ranks do something else") {
  const Communicator& comm = test_world();
  EverywhereGather gather(comm, numbers_of(comm.rank()).size());
  CHECK(gather.size() == numbers_of_all(comm).size());
  for (int round = 0; round < 3; ++round) {
    std::vector<double> own = numbers_of(comm.rank()), all = numbers_of_all(comm);
    for (double& x : own) x += round;
    for (double& x : all) x += round;
    CHECK_FALSE(gather.under_way());
    gather.start(own);
    own.clear();
    CHECK(comm.max(comm.rank()) == comm.size() - 1);  // another collective in between
    CHECK(gather.under_way());
    CHECK(gather.finish() == all);
  }
  // Of another size from now on; one that nobody finishes does no harm.
  gather = EverywhereGather(comm, 1);
  gather.start({double(comm.rank())});
}
