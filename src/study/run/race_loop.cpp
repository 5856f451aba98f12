#include "study/run/race_loop.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "base/json_fields.h"
#include "study/evaluate/result_keys.h"
#include "study/plan/race.h"
#include "study/plan/ranking.h"
#include "study/run/sailing.h"

namespace icebow {
namespace {

constexpr const char* fact_name = "race";
constexpr double default_longest = 20.0;  // times what the first leg counts
constexpr double fewest_samples = 10.0;   // independent ones: a shorter record knows no error of its own
constexpr double shortest_share = 0.1;    // of a leg that the budget cuts short; below, it is spent
constexpr double rounding = 1.0 + 1e-9;

// A design in the race with what its voyage has shown.
struct Racer {
  const PlannedDesign* planned = nullptr;
  MeanEstimate load;
  Drift drift;
  double sailed = 0.0, core_hours = 0.0;
  bool can_go_on = true;
};

class Race {
 public:
  Race(const StudySpec& spec, Store& store, const std::vector<PlannedDesign>& designs, const RaceHooks& hooks)
      : spec_(spec), store_(store), designs_(designs), hooks_(hooks), record_(read_race(store)) {
    record_.best_within = spec.decide.best_within;
    record_.confidence = spec.decide.confidence;
    record_.budget_core_hours = spec.decide.budget_core_hours;
    record_.state = RaceState::sailing;
  }

  RaceRecord run() {
    catch_up();
    for (;;) {
      look();
      if (racers_.empty()) return {};
      judge();
      std::vector<PlannedDesign> next;
      if (!standing_.decided) next = next_legs();
      if (standing_.decided) record_.state = RaceState::decided;
      keep();
      hooks_.told(record_);
      if (next.empty()) return record_;
      hooks_.sail(next);
    }
  }

 private:
  void catch_up();
  void look();
  void take_roster();
  void judge();
  std::vector<PlannedDesign> next_legs();
  std::map<std::string, double> sailed() const;
  double spent() const;
  void keep() { store_.set_fact(fact_name, json_text(to_json(record_))); }

  const StudySpec& spec_;
  Store& store_;
  const std::vector<PlannedDesign>& designs_;
  const RaceHooks& hooks_;
  RaceRecord record_;
  std::vector<Racer> racers_;
  RaceStanding standing_;
};

// Voyages that a leg before was to sail, and has not.
void Race::catch_up() {
  std::vector<PlannedDesign> behind;
  for (const PlannedDesign& planned : designs_) {
    const auto target = record_.targets.find(planned.key);
    if (target == record_.targets.end() || target->second <= planned.design.sail_to) continue;
    behind.push_back({sailed_to(planned.design, target->second), planned.key, planned.other_key});
  }
  if (!behind.empty()) hooks_.sail(behind);
}

// Designs that are ranked take part.
void Race::look() {
  racers_.clear();
  std::map<std::string, const PlannedDesign*> by_name;
  for (const PlannedDesign& planned : designs_) by_name[planned.design.name] = &planned;
  const Ranking ranking = rank_designs(store_.all(), spec_.rank_by);
  for (const RankedDesign& row : ranking.rows) {
    const auto planned = by_name.find(row.evaluation.name);
    if (row.rank == 0 || planned == by_name.end()) continue;
    const Json& result = row.evaluation.result;
    Racer racer;
    racer.planned = planned->second;
    racer.load = value_estimate(row, spec_.rank_by);
    if (racer.load.degrees_of_freedom + 1.0 < fewest_samples)
      racer.load.standard_error = std::numeric_limits<double>::infinity();
    racer.drift.relative = number_at(result, result_key::drift);
    racer.drift.p = number_at(result, result_key::drift_p);
    racer.sailed = number_at(result, result_key::sailed_to);
    const double seconds = number_at(result, result_key::simulation_seconds);
    racer.core_hours = std::isfinite(seconds) ? seconds * number_at(result, result_key::ranks) / 3600.0 : 0.0;
    racer.can_go_on = !has_ended(row.evaluation);
    if (std::isfinite(racer.sailed)) racers_.push_back(racer);
  }
}

std::map<std::string, double> Race::sailed() const {
  std::map<std::string, double> lengths;
  for (const Racer& racer : racers_) lengths[racer.planned->design.name] = racer.sailed;
  return lengths;
}

double Race::spent() const {
  double hours = 0.0;
  for (const Racer& racer : racers_) hours += racer.core_hours;
  return hours;
}

// A design that was not there, or was another ship of the same name, makes it another race.
void Race::take_roster() {
  std::map<std::string, std::string> keys;
  for (const Racer& racer : racers_) keys[racer.planned->design.name] = racer.planned->key;
  if (!std::includes(record_.keys.begin(), record_.keys.end(), keys.begin(), keys.end()))
    record_.legs.clear();
  record_.keys = keys;
}

// The same records as before are no new look at them: the leg is judged again instead.
void Race::judge() {
  take_roster();
  const auto now = sailed();
  if (!record_.legs.empty() && record_.legs.back().sailed == now) record_.legs.pop_back();
  std::vector<MeanEstimate> loads;
  std::vector<bool> in;
  RaceLeg judged;
  for (const Racer& racer : racers_) {
    loads.push_back(load_in_race(racer.load, racer.drift));
    if (racer.drift.told()) judged.drifts[racer.planned->design.name] = racer.drift.relative;
    in.push_back(record_.legs.empty() || is_in(record_.legs.back(), racer.planned->design.name));
  }
  // Those that were in may have left the study since: then all race again.
  if (std::find(in.begin(), in.end(), true) == in.end()) in.assign(racers_.size(), true);
  const int leg = static_cast<int>(record_.legs.size()) + 1;
  standing_ = standing(loads, in, leg, {record_.best_within, record_.confidence});
  judged.sailed = now;
  for (std::size_t i = 0; i < racers_.size(); ++i)
    if (standing_.in[i]) judged.in.push_back(racers_[i].planned->design.name);
  judged.leader = racers_[standing_.leader].planned->design.name;
  judged.most_above_best = standing_.most_above_best;
  judged.core_hours = spent();
  record_.legs.push_back(judged);
}

// Empty where nothing may be sailed on; the record then says why.
std::vector<PlannedDesign> Race::next_legs() {
  std::vector<std::pair<const Racer*, double>> legs;  // how much farther
  double price = 0.0;
  for (std::size_t i = 0; i < racers_.size(); ++i) {
    const Racer& racer = racers_[i];
    const Case& c = *racer.planned->design.given;
    const double target = std::min(next_leg(c.steady_from, racer.sailed), longest_voyage(spec_.decide, c));
    if (!standing_.sail_on[i] || !racer.can_go_on || target <= racer.sailed * rounding) continue;
    legs.emplace_back(&racer, target - racer.sailed);
    price += racer.core_hours * (target - racer.sailed) / racer.sailed;
  }
  record_.state = RaceState::longest;
  if (legs.empty()) return {};
  double share = 1.0;
  if (record_.budget_core_hours > 0.0 && price > 0.0)
    share = std::min(1.0, (record_.budget_core_hours - spent()) / price);
  record_.state = share < shortest_share ? RaceState::budget : RaceState::sailing;
  if (share < shortest_share) return {};
  std::vector<PlannedDesign> next;
  for (const auto& [racer, farther] : legs) {
    const double target = rounded(racer->sailed + share * farther);
    record_.targets[racer->planned->key] = target;
    next.push_back(
        {sailed_to(racer->planned->design, target), racer->planned->key, racer->planned->other_key});
  }
  return next;
}

}  // namespace

double longest_voyage(const Decide& decide, const Case& c) {
  if (decide.longest > 0.0) return decide.longest;
  return c.steady_from + default_longest * (c.advance - c.steady_from);
}

RaceRecord run_race(const StudySpec& spec, Store& store, const std::vector<PlannedDesign>& designs,
                    const RaceHooks& hooks) {
  return Race(spec, store, designs, hooks).run();
}

RaceRecord read_race(const Store& store) {
  try {
    const std::string fact = store.fact(fact_name);
    return fact.empty() ? RaceRecord() : race_record_from_json(parse_json(fact, fact_name));
  } catch (const std::exception&) {  // damaged: the voyages stand, and are looked at anew
    return {};
  }
}

void forget_race(Store& store) {
  if (read_race(store).given()) store.set_fact(fact_name, "");
}

}  // namespace icebow
