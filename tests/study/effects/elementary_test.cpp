#include "study/effects/elementary.h"

#include <catch2/catch.hpp>
#include <cmath>

#include "study/plan/sampling.h"

namespace icebow {
namespace {

// Loads 1e6 + 3e5 a + 1e5 b^2 over the designs of 30 trajectories, a from 10 to 40, b from 0 to 1; c idle.
Ranking morris_study() {
  std::vector<Evaluation> all;
  for (const auto& u : morris(3, 30, 3)) {
    Evaluation e;
    e.key = e.name = "d" + std::to_string(all.size());
    e.status = EvaluationStatus::ok;
    e.parameters = {{"/bow/a_deg", 10.0 + 30.0 * u[0]}, {"/bow/b_deg", u[1]}, {"/bow/c_deg", u[2]}};
    e.result = {{"metrics", {{"full_scale", {{"mean_load_N", 1e6 + 3e5 * u[0] + 1e5 * u[1] * u[1]}}}}}};
    all.push_back(e);
  }
  return rank_designs(all, "mean_load");
}

}  // namespace

TEST_CASE(
    "elementary effects: a line is the same everywhere, a square is not, an idle parameter does nothing") {
  const auto effects = elementary_effects(morris_study());
  REQUIRE(effects.size() == 3);
  CHECK(effects[0].pointer == "/bow/a_deg");
  CHECK(effects[0].steps >= 30);
  CHECK(effects[0].mean == Approx(3e5));
  CHECK(effects[0].mean_size == Approx(3e5));
  CHECK(effects[0].deviation < 1.0);  // of 3e5: rounding
  CHECK(effects[1].pointer == "/bow/b_deg");
  // From 0 to 2/3: (4/9) / (2/3) = 2/3; from 1/3 to 1: (8/9) / (2/3) = 4/3.
  CHECK(std::fabs(effects[1].mean - 1e5) < 2.0 * effects[1].mean_size_ci95);
  CHECK(effects[1].deviation == Approx(1e5 / 3.0).epsilon(0.1));  // both steps are equally likely
  CHECK(effects[2].mean_size == 0.0);
}

}  // namespace icebow
