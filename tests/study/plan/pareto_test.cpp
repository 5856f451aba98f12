#include "study/plan/pareto.h"

#include <catch2/catch.hpp>
#include <limits>
#include <random>

#include "study/plan/ranking.h"

namespace icebow {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

Objectives exact(double first, double second) {
  return {{first, 0.0, infinite}, {second, 0.0, infinite}};
}

Objectives noisy(double first, double error, double second) {
  return {{first, error, infinite}, {second, 0.0, infinite}};
}

std::string places(const std::vector<Objectives>& designs) {
  std::string letters;
  for (const FrontPlace place : front_places(designs))
    letters += place == FrontPlace::none ? '-' : *to_string(place);
  return letters;
}

Evaluation ship(const std::string& name, double load, double ci95, double displacement) {
  Evaluation e;
  e.name = name, e.status = EvaluationStatus::ok;
  e.result = {{"metrics", {{"full_scale", {{"mean_load_N", load}, {"mean_load_ci95_N", ci95}}}}},
              {"hydrostatics", {{"displacement_kg", displacement}}}};
  return e;
}

}  // namespace

TEST_CASE("exact numbers: a design is off the front where another is as good in both and better in one") {
  CHECK(places({exact(1, 4), exact(2, 2), exact(4, 1), exact(3, 3), exact(2, 3)}) == "fffdd");
  CHECK(places({exact(1, 1), exact(1, 1), exact(1, 2), exact(2, 1)}) == "ffdd");
  CHECK(places({exact(1, 1), exact(NAN, 0), exact(0, NAN)}) == "f--");
  CHECK(places({}).empty());
}

TEST_CASE("a load that is not told apart leaves the place open; beyond the interval it is decided") {
  // b's load is above a's by 1, with an error of the difference of 1.4: nobody knows. c's by 10.
  CHECK(places({noisy(10, 1, 1), noisy(11, 1, 2), noisy(20, 1, 3)}) == "fod");
  CHECK(places({noisy(10, infinite, 1), noisy(20, 1, 2)}) == "fo");
}

TEST_CASE("what a noisy design of the front leaves open another one may settle") {
  // The best load is hardly known; the second best settles the third.
  CHECK(places({noisy(10, 20, 1), noisy(11, 0.1, 2), noisy(15, 0.1, 3)}) == "fod");
}

TEST_CASE("the front is that of the definition, pair by pair") {
  std::mt19937 random(5);
  std::uniform_int_distribution<int> few(0, 12);  // so that equal numbers come up
  for (int trial = 0; trial < 50; ++trial) {
    std::vector<Objectives> designs;
    for (int i = 0; i < 40; ++i) designs.push_back(exact(few(random), few(random)));
    const std::vector<FrontPlace> found = front_places(designs);
    for (std::size_t i = 0; i < designs.size(); ++i) {
      bool dominated = false;
      for (const Objectives& other : designs) {
        const double a = other.first.mean - designs[i].first.mean,
                     b = other.second.mean - designs[i].second.mean;
        dominated = dominated || (a <= 0 && b <= 0 && a + b < 0);
      }
      REQUIRE((found[i] == FrontPlace::front) == !dominated);
    }
  }
}

TEST_CASE("a ranking with two objectives: load by Welch's test, displacement as it is, the largest best") {
  const SecondObjective displacement = {"/hydrostatics/displacement_kg", true};
  const std::vector<Evaluation> ships = {ship("light", 100, 5, 1e7), ship("middle", 103, 5, 2e7),
                                         ship("heavy", 200, 5, 3e7), ship("bad", 300, 5, 2e7),
                                         ship("close", 105, 5, 2e7)};
  const Ranking r = rank_designs(ships, "mean_load", displacement);
  CHECK(names_at(r, FrontPlace::front) == std::vector<std::string>{"light", "middle", "heavy"});
  CHECK(names_at(r, FrontPlace::open) == std::vector<std::string>{"close"});
  CHECK(names_at(r, FrontPlace::dominated) == std::vector<std::string>{"bad"});
  CHECK(r.rows[0].second == 1e7);
  CHECK(r.rows[0].second_ci95 == 0.0);
  const Json json = to_json(r);
  CHECK(json.at("second") == Json({{"by", "/hydrostatics/displacement_kg"}, {"best", "largest"}}));
  CHECK(json.at("designs")[4].at("front") == "dominated");
  CHECK_FALSE(to_json(rank_designs(ships, "mean_load")).at("designs")[0].contains("front"));
  const Ranking smallest = rank_designs(ships, "mean_load", {"/hydrostatics/displacement_kg", false});
  CHECK(names_at(smallest, FrontPlace::front) == std::vector<std::string>{"light"});
}

TEST_CASE("a second objective that is a mean has the interval beside it") {
  Evaluation a = ship("a", 100, 1, 1), b = ship("b", 200, 1, 1);
  a.result["metrics"]["full_scale"].update({{"vertical_mean_N", 50.0}, {"vertical_mean_ci95_N", 20.0}});
  b.result["metrics"]["full_scale"].update({{"vertical_mean_N", 55.0}, {"vertical_mean_ci95_N", 20.0}});
  const Ranking r = rank_designs({a, b}, "mean_load", {"/metrics/full_scale/vertical_mean_N", false});
  CHECK(r.rows[1].second_ci95 == 20.0);
  CHECK(r.rows[1].front == FrontPlace::open);
}

}  // namespace icebow
