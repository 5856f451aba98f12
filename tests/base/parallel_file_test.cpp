// One HDF5 file that all ranks write and read together.
#include "base/parallel_file.h"

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
