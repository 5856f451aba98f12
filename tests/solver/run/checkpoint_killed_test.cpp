// What is left when a run is killed, or runs out of disk, while it writes its checkpoint.
#include <signal.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>

#include "base/errors.h"
#include "tests/support/checkpoint_case.h"

using namespace icebow;

namespace {

namespace fs = std::filesystem;

// A sheet whose checkpoint takes a while, and a run that writes one at each sample.
struct Case {
  Case() {
    s.sheet.length = 6.4;
    s.advance = 4.0;
    options.checkpoint_file = folder.file("checkpoint.h5");
    options.checkpoint_every_s = 1e-9;
    options.on_resume = [this](std::int64_t step) { resumed_at = step; };
  }
  Communicator comm = Communicator::serial();
  TestFolder folder{comm, "checkpoint_killed"};
  Scenario s = breaking_ice();
  RunOptions options;
  std::int64_t resumed_at = -1;

  RunResult run_on() {
    RunOptions first_sample = options;
    first_sample.checkpoint_every_s = 0.0;
    first_sample.on_progress = [](const Progress&) {};
    first_sample.stop = [] { return true; };
    return simulate(comm, tiny_hull(), s, first_sample);
  }
};

void kill_while_writing(const Case& c) {
  const pid_t child = ::fork();
  if (child == 0) {
    simulate(c.comm, tiny_hull(), c.s, c.options);
    ::_exit(0);
  }
  // From the first checkpoint on, wait for one that is being written.
  const std::string unfinished = c.options.checkpoint_file + ".tmp" + std::to_string(child);
  for (int turn = 0; turn < 200000; ++turn) {
    if (fs::exists(c.options.checkpoint_file) && fs::exists(unfinished)) break;
    ::usleep(50);
  }
  ::kill(child, SIGKILL);
  int status = 0;
  ::waitpid(child, &status, 0);
  REQUIRE(WIFSIGNALED(status));
}

}  // namespace

TEST_CASE("a run killed while it writes goes on from the checkpoint before") {
  Case c;
  std::int64_t before = 0;
  for (int kill = 0; kill < 4; ++kill) {
    kill_while_writing(c);
    REQUIRE(c.run_on().status == RunStatus::interrupted);
    CHECK(c.resumed_at > before);
    before = c.resumed_at;
  }
}

TEST_CASE("half a file beside a good one is nobody's business") {
  Case c;
  const RunResult first = c.run_on();
  REQUIRE(first.status == RunStatus::interrupted);
  const std::string unfinished = c.options.checkpoint_file + ".tmp";
  fs::copy_file(c.options.checkpoint_file, unfinished);
  fs::resize_file(unfinished, fs::file_size(unfinished) / 3);
  REQUIRE(c.run_on().status == RunStatus::interrupted);
  CHECK(c.resumed_at == first.steps);
  CHECK_FALSE(fs::exists(unfinished));
}

TEST_CASE("a disk that is full is an error, and the checkpoint before stays") {
  Case c;
  const RunResult first = c.run_on();
  const auto size = fs::file_size(c.options.checkpoint_file);
  ::signal(SIGXFSZ, SIG_IGN);
  rlimit usual{};
  ::getrlimit(RLIMIT_FSIZE, &usual);
  const rlimit small{size / 2, usual.rlim_max};
  ::setrlimit(RLIMIT_FSIZE, &small);
  CHECK_THROWS_AS(c.run_on(), RuntimeError);
  ::setrlimit(RLIMIT_FSIZE, &usual);
  CHECK(fs::file_size(c.options.checkpoint_file) == size);
  CHECK_FALSE(fs::exists(c.options.checkpoint_file + ".tmp" + std::to_string(::getpid())));
  c.resumed_at = -1;
  REQUIRE(c.run_on().status == RunStatus::interrupted);
  CHECK(c.resumed_at == first.steps);
}
