#include "study/evaluate/progress_json.h"

#include <catch2/catch.hpp>

using namespace icebow;

TEST_CASE("a line of progress is read back; one whose steps are no counts is none") {
  Progress sent;
  sent.step = 3, sent.steps = 10, sent.advance = 0.5, sent.load = -1e3;
  const auto read = progress_from_line(progress_line(sent));
  REQUIRE(read);
  CHECK(read->step == 3);
  CHECK(read->steps == 10);
  CHECK(read->advance == 0.5);
  CHECK(read->load == -1e3);
  for (const char* line :
       {R"({"step": 3, "steps": 1e37})", R"({"step": -1, "steps": 3})", R"({"step": 4, "steps": 3})",
        R"({"step": "3", "steps": [1]})", "a library says hello", "[1]", ""}) {
    INFO(line);
    const auto other = progress_from_line(line);
    CHECK((!other || (other->step == 0 && other->steps == 0)));
  }
}

TEST_CASE("a line of a child that nests without end is no line of ours") {
  const std::string deep(100000, '[');
  CHECK_FALSE(progress_from_line(R"({"step": 1, "steps": 2, "a": )" + deep));
  CHECK_FALSE(trouble_from_line(R"({"machine_trouble": )" + deep));
  CHECK(trouble_from_line(trouble_line("the disk is full")) == "the disk is full");
}
