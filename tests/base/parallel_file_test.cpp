// One HDF5 file that all ranks write and read together.
#include "base/parallel_file.h"

#include <signal.h>
#include <sys/resource.h>

#include <algorithm>
#include <catch2/catch.hpp>

#include "base/errors.h"
#include "tests/support/main.h"
#include "tests/support/test_folder.h"

using namespace icebow;

TEST_CASE("lists and texts come back on every rank, empty ones too") {
  const Communicator& world = test_world();
  const TestFolder folder(world, "parallel_file");
  const std::string path = folder.file("lists.h5");
  ParallelFile written = ParallelFile::create(world, path);
  const bool root = world.is_root();
  written.write_list("numbers", std::vector<double>{root ? 1.5 : 0.0, root ? -2.0 : 0.0});
  written.write_list("none", std::vector<std::int64_t>{});
  written.write_text("text", "sheet");
  written.write_text("silence", "");
  written.write_texts("names", root ? std::vector<std::string>{"Steep stem", "", "B\u00f8rge"}
                                    : std::vector<std::string>{"x"});
  written.write_texts("no names", {});
  written.close();
  ParallelFile read = ParallelFile::open(world, path);
  CHECK(read.read_list<double>("numbers") == std::vector<double>{1.5, -2.0});
  CHECK(read.read_list<std::int64_t>("none").empty());
  CHECK(read.read_text("text") == "sheet");
  CHECK(read.read_text("silence").empty());
  CHECK(read.read_texts("names") == std::vector<std::string>{"Steep stem", "", "B\u00f8rge"});
  CHECK(read.read_texts("no names").empty());
  CHECK_THROWS_WITH(read.read_texts("numbers"), Catch::Contains("no list of texts"));
  CHECK_THROWS_WITH(read.read_text("other"), Catch::Contains(path));
}

TEST_CASE("lists and texts are the root's where the ranks' differ in length, and what follows is whole") {
  const Communicator& world = test_world();
  const TestFolder folder(world, "parallel_file_lengths");
  const std::string path = folder.file("lengths.h5");
  const std::size_t rank = world.rank();
  ParallelFile written = ParallelFile::create(world, path);
  written.write_list("numbers", std::vector<double>(3 + 1000 * rank, 2.5));
  written.write_list("roots alone", std::vector<double>(rank == 0 ? 2 : 0, 1.5));
  written.write_text("text", std::string(20 - rank, 'x'));
  const Slab own{{1000u * world.size()}, {1000 * rank}, {1000}};
  const std::vector<std::int64_t> values(1000, rank);
  written.write("own", own, values.data(), Slab::whole({1000}));
  written.close();
  ParallelFile read = ParallelFile::open(world, path);
  CHECK(read.read_list<double>("numbers") == std::vector<double>(3, 2.5));
  CHECK(read.read_list<double>("roots alone") == std::vector<double>(2, 1.5));
  CHECK(read.read_text("text") == std::string(20, 'x'));
  std::vector<std::int64_t> back(1000, -1);
  read.read("own", own, back.data(), Slab::whole({1000}));
  CHECK(back == values);
}

TEST_CASE("a directory that is not there is named on every rank") {
  const Communicator& world = test_world();
  CHECK_THROWS_WITH(ParallelFile::create(world, "/nonexistent/c.h5"), Catch::Contains("/nonexistent/c.h5"));
  CHECK_THROWS_AS(ParallelFile::open(world, "/nonexistent/c.h5"), RuntimeError);
}

TEST_CASE("parts of an array with gaps in memory come back on every rank, and on one") {
  const Communicator& world = test_world();
  const TestFolder folder(world, "parallel_file_parts");
  const std::string path = folder.file("parts.h5");
  const std::uint64_t ranks = static_cast<std::uint64_t>(world.size()),
                      own = static_cast<std::uint64_t>(world.rank());
  // Three rows; the rank's two columns stand in the middle of four in its memory. The last rank has none.
  const bool has = own + 1 < ranks || ranks == 1;
  const Slab in_file{{3, 2 * ranks}, {0, 2 * own}, {3, has ? 2u : 0u}},
      in_memory{{3, 4}, {0, 1}, {3, has ? 2u : 0u}};
  std::vector<double> memory(12, -1.0), back(12, -2.0);
  for (std::uint64_t row = 0; row < 3; ++row) {
    for (std::uint64_t k = 0; k < 2; ++k) memory[4 * row + 1 + k] = 100.0 * row + 2.0 * own + k;
  }
  ParallelFile written = ParallelFile::create(world, path, Checksums::yes);
  written.write("array", in_file, memory.data(), in_memory);
  written.close();
  ParallelFile read = ParallelFile::open(world, path);
  read.read("array", in_file, back.data(), in_memory);
  for (std::uint64_t k = 0; k < 12; ++k) CHECK(back[k] == (has && k % 4 % 3 != 0 ? memory[k] : -2.0));
  std::vector<double> all(3 * 2 * ranks);
  read.read("array", Slab::whole({3, 2 * ranks}), all.data(), Slab::whole({3, 2 * ranks}));
  for (std::uint64_t row = 0; row < 3; ++row) {
    for (std::uint64_t k = 0; k < 2 * std::max<std::uint64_t>(ranks - 1, 1); ++k)
      CHECK(all[2 * ranks * row + k] == 100.0 * row + k);
  }
}

TEST_CASE(
    "a disk that is full is an error on every rank, wherever it strikes, and nobody waits for another") {
  const Communicator& world = test_world();
  const TestFolder folder(world, "parallel_file_full");
  const std::string path = folder.file("full.h5");
  const std::uint64_t ranks = static_cast<std::uint64_t>(world.size()),
                      own = static_cast<std::uint64_t>(world.rank());
  ::signal(SIGXFSZ, SIG_IGN);
  rlimit usual{};
  ::getrlimit(RLIMIT_FSIZE, &usual);
  const std::vector<double> values(20000, 1.5);
  const auto write = [&](rlim_t most) {
    rlimit small = usual;
    small.rlim_cur = most;
    if (world.is_root()) ::setrlimit(RLIMIT_FSIZE, &small);
    std::string trouble;
    try {
      ParallelFile file = ParallelFile::create(world, path, Checksums::yes);
      file.group("/parts");
      for (const char* name : {"/parts/a", "/parts/b"})
        file.write(name, Slab{{20000 * ranks}, {20000 * own}, {20000}}, values.data(), Slab::whole({20000}));
      file.attribute("/", "one", std::vector<std::int64_t>{1});
      file.close();
    } catch (const RuntimeError& error) {
      trouble = error.what();
    }
    ::setrlimit(RLIMIT_FSIZE, &usual);
    return trouble;
  };
  CHECK(write(usual.rlim_cur).empty());
  for (const rlim_t most : {0u, 1u, 1000u, 100000u, 250000u}) {  // of 320,000 bytes a rank
    CAPTURE(most);
    CHECK(write(most) == "cannot write " + path + ": File too large");
  }
}
