// A run that may stop early is not to be fooled by a record that looks good by chance.
#include "solver/watch/stop_rule.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <random>

using namespace icebow;

namespace {

constexpr double mean = 5.0, deviation = 3.0;  // as an ice load's: 0.6 of the mean

// x_k = phi x_{k-1} + e_k about the mean, in its steady state, with the deviation above.
class Ar1 {
 public:
  Ar1(double phi, std::uint32_t seed) : phi_(phi), engine_(seed), state_(deviation * gauss_(engine_)) {}
  double next() {
    const double value = mean + state_;
    state_ = phi_ * state_ + deviation * std::sqrt(1.0 - phi_ * phi_) * gauss_(engine_);
    return value;
  }

 private:
  double phi_;
  std::mt19937 engine_;
  std::normal_distribution<double> gauss_;
  double state_;
};

struct Outcome {
  double coverage = 0.0, stopped = 0.0, length = 0.0;
};

// Series that go on until the rule stops them, or to `most` samples.
Outcome outcome(double phi, double width, int most, int repeats) {
  Outcome o;
  for (int k = 0; k < repeats; ++k) {
    Ar1 series(phi, 17u + k);
    std::vector<double> record;
    LoadStatistics load;
    bool stops = false;
    while (!stops && static_cast<int>(record.size()) < most) {
      record.push_back(series.next());
      if (!is_look(static_cast<int>(record.size()))) continue;
      load = series_statistics(record);
      stops = narrow_enough(load, width);
    }
    if (!stops) load = series_statistics(record);
    o.stopped += stops;
    o.coverage += std::abs(load.mean - mean) <= load.ci95;
    o.length += static_cast<double>(record.size());
  }
  return {o.coverage / repeats, o.stopped / repeats, o.length / repeats};
}

History history_of(const std::vector<double>& loads, double steady_from) {
  History h;
  for (int before = 0; before < 5; ++before) {
    HistoryRow row;
    row.advance = steady_from * (before + 1) / 5.0;
    row.F[0] = -1e6;  // first touch: not to be counted
    h.rows.push_back(row);
  }
  for (double load : loads) {
    HistoryRow row;
    row.advance = h.rows.back().advance + 0.002;
    row.F[0] = -load;
    h.rows.push_back(row);
  }
  return h;
}

}  // namespace

TEST_CASE("the interval of a run that stopped early covers the mean nearly as often as it says") {
  for (const double tau : {1.0, 10.0, 50.0, 200.0}) {
    const double phi = (tau - 1.0) / (tau + 1.0);
    for (const double width : {0.4, 0.25}) {
      const Outcome o = outcome(phi, width, 30000, 200);
      INFO("correlation time " << tau << ", width " << width << ": coverage " << o.coverage << ", stopped "
                               << o.stopped << ", mean length " << o.length);
      CHECK(o.stopped > 0.98);
      CHECK(o.coverage > 0.87);  // found: 0.875 to 0.965; 200 series scatter by 0.02
    }
  }
  CHECK(outcome(9.0 / 11.0, 0.1, 30000, 200).coverage > 0.87);
}

TEST_CASE("looks are few and grow") {
  CHECK_FALSE(is_look(0));
  CHECK_FALSE(is_look(255));
  CHECK(is_look(256));
  CHECK_FALSE(is_look(257));
  CHECK(is_look(384));
  CHECK(is_look(576));
  int looks = 0;
  for (int n = 1; n <= 10000; ++n) looks += is_look(n);
  CHECK(looks == 10);
}

TEST_CASE("the steady part decides, and no width means never") {
  Ar1 series(0.0, 1);
  std::vector<double> loads(256);
  for (double& load : loads) load = series.next();
  CHECK(enough_recorded(history_of(loads, 0.1), 0.1, 0.1));
  CHECK_FALSE(enough_recorded(history_of(loads, 0.1), 0.1, 0.01));
  CHECK_FALSE(enough_recorded(history_of(loads, 0.1), 0.1, 0.0));
  loads.pop_back();
  CHECK_FALSE(enough_recorded(history_of(loads, 0.1), 0.1, 0.1));
  CHECK_FALSE(enough_recorded({}, 0.1, 0.1));
}

TEST_CASE("a record worth few independent samples is not enough, however narrow it looks") {
  LoadStatistics load;
  load.mean = 10.0;
  load.ci95 = 0.1;
  load.effective_samples = 29.0;
  CHECK_FALSE(narrow_enough(load, 0.1));
  load.effective_samples = 30.0;
  CHECK(narrow_enough(load, 0.1));
  load.ci95 = std::numeric_limits<double>::infinity();
  CHECK_FALSE(narrow_enough(load, 0.1));
}
