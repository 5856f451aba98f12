#include "base/guarded_work.h"

#include <unistd.h>

#include <catch2/catch.hpp>
#include <csignal>

using namespace icebow;

TEST_CASE("what a copy of the program returns comes back whole, and nothing else of it") {
  int here = 1;
  const std::string large(3'000'000, 'x');  // more than a pipe holds
  const GuardedResult result = guarded_work(
      [&] {
        here = 2;
        return large;
      },
      60);
  CHECK(result.trouble.empty());
  CHECK(result.bytes == large);
  CHECK(here == 1);
}

TEST_CASE("a crash, an exit and a hang of the copy are told, and we live on") {
  const auto trouble = [](void (*misbehave)()) {
    return guarded_work(
               [=] {
                 misbehave();
                 return std::string("done");
               },
               1)
        .trouble;
  };
  CHECK_THAT(trouble([] { raise(SIGSEGV); }), Catch::Contains("signal 11"));
  CHECK_THAT(trouble([] { _exit(3); }), Catch::Contains("exit code 3"));
  CHECK_THAT(trouble([] {
               for (;;) pause();
             }),
             Catch::Contains("longer than 1 s"));
}
