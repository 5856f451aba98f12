#include "study/evaluate/evaluation.h"

#include <catch2/catch.hpp>

using namespace icebow;

TEST_CASE("an evaluation comes back as it was stored, but its reason commands no terminal") {
  Evaluation e;
  e.key = "k", e.name = "d001", e.status = EvaluationStatus::failed;
  e.reason = "too \x1b[31mred";
  e.parameters = {{"/bow/stem_deg", 21.5}};
  e.result = {{"a", 1}};
  e.wall_seconds = 2.5;
  const Evaluation back = evaluation_from_json(to_json(e));
  CHECK(back.key == "k");
  CHECK(back.name == "d001");
  CHECK(back.status == EvaluationStatus::failed);
  CHECK(back.reason == "too ?[31mred");
  CHECK(back.parameters == e.parameters);
  CHECK(back.result == e.result);
  CHECK(back.wall_seconds == 2.5);
}
