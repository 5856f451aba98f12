#include "study/plan/race.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <cstdio>
#include <limits>
#include <random>

#include "solver/model/drift.h"
#include "solver/model/statistics.h"

using namespace icebow;

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

// Loads as a ship's are: correlated over some ten samples, and skewed (the square of a normal). They begin
// with `too_much` of the mean more, which wears off over 200 samples.
class Voyage {
 public:
  Voyage(std::mt19937_64& random, double mean, double too_much = 0.0)
      : random_(random), mean_(mean), too_much_(too_much), x_(normal_(random)) {}
  void sail(int samples) {
    const double phi = 0.82;
    for (int n = 0; n < samples; ++n) {
      x_ = phi * x_ + std::sqrt(1.0 - phi * phi) * normal_(random_);
      const double worn = std::exp(-static_cast<double>(record_.size()) / 200.0);
      record_.push_back(mean_ * (1.0 + too_much_ * worn) * (0.6 + 0.4 * x_ * x_));
    }
  }
  Drift drift() const { return drift_of(record_); }
  std::size_t samples() const { return record_.size(); }
  MeanEstimate load() const {
    const LoadStatistics s = series_statistics(record_);
    return mean_estimate(s.mean, s.ci95, s.effective_samples);
  }

 private:
  std::mt19937_64& random_;
  std::normal_distribution<double> normal_;
  double mean_, too_much_, x_;
  std::vector<double> record_;
};

struct Outcome {
  bool decided = false;
  double above_best = 0.0;  // of the bow that the race names, in truth
  bool lost_best = false;   // the bow that truly is the best went out
  double samples = 0.0;
};

enum class Drifts { none, looked_for, overlooked };

// Ten bows, each `step` above the one before it, sailed on by the rule of the study engine. Where records
// drift, the best bow begins `off` of its load too high, the fifth as much too low.
Outcome race_of(std::mt19937_64& random, double step, const RaceRule& rule, int most_legs,
                Drifts drifts = Drifts::none, double off = 0.6) {
  std::vector<Voyage> voyages;
  const auto too_much = [&](int bow) {
    return drifts == Drifts::none ? 0.0 : bow == 0 ? off : bow == 4 ? -off : 0.0;
  };
  for (int bow = 0; bow < 10; ++bow) voyages.emplace_back(random, 1.0 + step * bow, too_much(bow));
  for (Voyage& voyage : voyages) voyage.sail(400);
  std::vector<bool> in(10, true);
  Outcome outcome;
  for (int leg = 1; leg <= most_legs && !outcome.decided; ++leg) {
    std::vector<MeanEstimate> loads;
    for (const Voyage& voyage : voyages) {
      const Drift drift = drifts == Drifts::looked_for ? voyage.drift() : Drift();
      loads.push_back(load_in_race(voyage.load(), drift));
    }
    const RaceStanding s = standing(loads, in, leg, rule);
    in = s.in;
    outcome.lost_best = step > 0.0 && !in[0];
    outcome.decided = s.decided;
    outcome.above_best = step * static_cast<double>(s.leader);
    for (std::size_t i = 0; i < voyages.size() && !s.decided; ++i) {
      const double samples = static_cast<double>(voyages[i].samples());
      if (s.sail_on[i]) voyages[i].sail(static_cast<int>(next_leg(0.0, samples) - samples));
    }
  }
  for (const Voyage& voyage : voyages) outcome.samples += static_cast<double>(voyage.samples());
  return outcome;
}

}  // namespace

TEST_CASE("a bow that is surely worse is out, and a lone bow has won") {
  const std::vector<MeanEstimate> loads = {{1.0, 0.01, 20.0}, {1.5, 0.01, 20.0}, {1.6, 0.02, 20.0}};
  const RaceStanding s = standing(loads, {true, true, true}, 1, {});
  CHECK(s.leader == 0);
  CHECK(s.in == std::vector<bool>{true, false, false});
  CHECK(s.decided);
  CHECK(s.most_above_best == 0.0);
  CHECK(standing({{1.0, infinite, 1.0}}, {true}, 1, {}).decided);
}

TEST_CASE("bows that are equal within what is asked need not be told apart") {
  const std::vector<MeanEstimate> loads = {{1.0, 0.005, 1e6}, {1.001, 0.005, 1e6}};
  const RaceStanding s = standing(loads, {true, true}, 1, {0.05, 0.95});
  CHECK(s.decided);
  CHECK(s.in == std::vector<bool>{true, true});
  // One-sided, 0.05 / (1 x 2) over one pair: 1.960 standard errors of sqrt(2) x 0.005, less the difference.
  CHECK(s.most_above_best ==
        Approx(1.959964 * std::sqrt(2.0) * 0.005 - 0.001).epsilon(1e-6));  // found 6e-7: digits of 1.96
  CHECK_FALSE(standing(loads, {true, true}, 1, {0.005, 0.95}).decided);
}

TEST_CASE("a later look asks for more, so that all looks together err as seldom as said") {
  const std::vector<MeanEstimate> loads = {{1.0, 0.01, 1e6}, {1.032, 0.01, 1e6}};  // 2.26 standard errors
  CHECK_FALSE(standing(loads, {true, true}, 1, {0.001, 0.95}).in[1]);              // 1.96 are asked
  CHECK(standing(loads, {true, true}, 2, {0.001, 0.95}).in[1]);                    // 2.39
}

TEST_CASE("what is sailed on is what keeps the race open") {
  // The second is open and far less known than the leader; the third is out of it; the fourth is unknown.
  const std::vector<MeanEstimate> loads = {
      {1.0, 0.002, 50.0}, {1.02, 0.05, 50.0}, {2.0, 0.01, 50.0}, {3.0, infinite, 1.0}};
  const RaceStanding s = standing(loads, {true, true, true, true}, 1, {});
  CHECK(s.sail_on == std::vector<bool>{false, true, false, true});
  CHECK(s.most_above_best == infinite);
  CHECK(next_leg(35.0, 75.0) == 95.0);
}

TEST_CASE("in a thousand races the answer is wrong no oftener than said") {
  std::mt19937_64 random(3);
  int wrong = 0, decided = 0;
  for (int race = 0; race < 1000; ++race) {
    const Outcome o = race_of(random, 0.02, {0.10, 0.95}, 8);
    decided += o.decided;
    wrong += o.decided && o.above_best > 0.10;
  }
  CHECK(wrong <= 50);  // of 1,000 at 95 %
  CHECK(decided >= 500);
}

// ./test_study "[races]": the table of docs/study_engine.md.
TEST_CASE("races by how far bows are apart, what is asked, and how sure", "[.][races]") {
  for (const double step : {0.0, 0.005, 0.01, 0.02, 0.05})
    for (const double within : {0.02, 0.05, 0.10})
      for (const double confidence : {0.80, 0.95}) {
        std::mt19937_64 random(11);
        int wrong = 0, decided = 0, lost = 0;
        double samples = 0.0;
        for (int race = 0; race < 1000; ++race) {
          const Outcome o = race_of(random, step, {within, confidence}, 10);
          decided += o.decided;
          wrong += o.decided && o.above_best > within;
          lost += o.lost_best;
          samples += o.samples;
        }
        std::printf("| %.1f %% | %.0f %% | %.0f %% | %d | %d | %d | %.1f |\n", 100 * step, 100 * within,
                    100 * confidence, decided, wrong, lost, samples / 1000 / 4000);
      }
}

// ./test_study "[drifts]": the table of docs/study_engine.md, "Drift". The same 200 races with and without.
TEST_CASE("races by how far records drift, looked for and overlooked", "[.][races][drifts]") {
  for (const double off : {0.0, 0.15, 0.3, 0.6}) {
    std::printf("| %.0f %% |", 100 * off);
    for (const Drifts drifts : {Drifts::overlooked, Drifts::looked_for}) {
      std::mt19937_64 random(7);
      int lost = 0, decided = 0;
      double samples = 0.0;
      for (int race = 0; race < 200; ++race) {
        const Outcome o = race_of(random, 0.02, {0.10, 0.95}, 10, drifts, off);
        lost += o.lost_best;
        decided += o.decided;
        samples += o.samples;
      }
      std::printf(" %d | %d | %.1f |", lost, decided, samples / 200 / 4000);
    }
    std::printf("\n");
  }
}

TEST_CASE("where records drift, looking for it saves the best bow in many races") {
  std::mt19937_64 random(7);
  int looked_for = 0, overlooked = 0, false_alarms = 0;
  for (int race = 0; race < 100; ++race) {
    looked_for += race_of(random, 0.02, {0.10, 0.95}, 8, Drifts::looked_for).lost_best;
    overlooked += race_of(random, 0.02, {0.10, 0.95}, 8, Drifts::overlooked).lost_best;
    Voyage steady(random, 1.0);
    steady.sail(400);
    false_alarms += steady.drift().told();
  }
  CHECK(looked_for < 0.8 * overlooked);  // 0.64 of 200 races, to a tenth by their number
  CHECK(false_alarms <= 12);             // 5 expected of 100, and three standard deviations
}

TEST_CASE("a race costs less than sailing all bows as far as the one that sails farthest") {
  std::mt19937_64 random(5);
  double samples = 0.0, all = 0.0;
  for (int race = 0; race < 20; ++race) {
    const Outcome o = race_of(random, 0.10, {0.05, 0.95}, 12);
    REQUIRE(o.decided);
    CHECK(o.above_best == 0.0);
    samples += o.samples;
    all += 4000.0;
  }
  CHECK(samples > all);  // the leaders are sailed on
  CHECK(samples < 6.0 * all);
}
