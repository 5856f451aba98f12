#include "study/run/learning_loop.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>

#include "base/json_fields.h"
#include "base/sha256.h"
#include "base/text.h"
#include "study/learn/learning_search.h"
#include "study/plan/constraints.h"
#include "study/plan/ranking.h"
#include "study/plan/repeats.h"
#include "study/plan/variable_ranges.h"
#include "study/run/cheap_response.h"
#include "study/spec/spec_method.h"

namespace icebow {
namespace {

using Point = std::vector<double>;

constexpr const char* fact_name = "learning";

Json to_json(const LearningRound& round) {
  return {{"points", round.points}, {"gain", finite_or_null(round.gain)}, {"parameters", round.parameters}};
}

LearningRound round_from(const std::string& state, const Json& json) {
  return {state, json.at("points").get<std::vector<Point>>(), number_at(json, "/gain"),
          json.at("parameters").get<std::vector<std::vector<double>>>()};
}

// What makes a search another one: all but when it ends.
std::string identity(const StudySpec& spec) {
  const Method& m = spec.method;
  std::string words = text("1 %llu %d %d %d", static_cast<unsigned long long>(m.seed), m.learning.initial,
                           m.learning.batch, static_cast<int>(m.learning.prior));
  for (const Variable& v : m.variables) words += text(" %s %a %a", v.pointer.c_str(), v.lower, v.upper);
  for (const ResultConstraint& c : spec.constraints)
    words += text(" %s %a %a", c.at.c_str(), c.lower, c.upper);
  return sha256(words + " " + spec.rank_by + " " + design_at(spec, "start", start_point(spec)).key);
}

class LearningLoop {
 public:
  LearningLoop(const StudySpec& spec, const RunSettings& settings, Store& store, const LearningHooks& hooks)
      : spec_(spec), settings_(settings), store_(store), hooks_(hooks) {}
  std::vector<std::string> run();

 private:
  void take_up();
  void keep() { store_.set_fact(fact_name, json_text(record_)); }
  std::vector<std::string> paid_for() const;
  void add_known(LearningProblem& problem);
  void add_prior(LearningProblem& problem);
  std::optional<Answer> answer_of(const std::vector<std::string>& keys) const;
  std::optional<Point> point_of(const Evaluation& e) const;
  std::string key_of(const Point& x) const;
  std::string summary(const LearningResult& result) const;
  std::string on_model(const LearningResult& result) const;

  const StudySpec& spec_;
  const RunSettings& settings_;
  Store& store_;
  const LearningHooks& hooks_;
  Json record_;
  std::map<Point, std::string> keys_;  // of the first run, by point
  std::vector<std::string> notes_;
};

// A record that cannot be read is a search that begins anew, from the evaluations that are there.
void LearningLoop::take_up() {
  record_ = json_or_null(store_.fact_or_nothing(fact_name));
  const std::string now = identity(spec_);
  if (record_.is_object() && text_at(record_, "/search") == now) return;
  record_ = {{"search", now}, {"paid", paid_for()}, {"rounds", Json::object()}};
  keep();
}

std::optional<Point> LearningLoop::point_of(const Evaluation& e) const {
  if (!is_within(spec_.method.variables, e.parameters) || run_name(e.name).number > 1) return {};
  Point x;
  for (const Variable& v : spec_.method.variables) x.push_back(e.parameters.at(v.pointer));
  if (design_at(spec_, e.name, x).key != e.key) return {};
  return x;
}

// Keys of evaluations that are of this ship in these conditions, but for the variables; the start is asked
// for anyway.
std::vector<std::string> LearningLoop::paid_for() const {
  std::vector<std::string> keys;
  const std::string start = design_at(spec_, "start", start_point(spec_)).key;
  for (const Evaluation& e : store_.everything()) {
    const bool over = e.status == EvaluationStatus::ok || e.status == EvaluationStatus::infeasible;
    if (over && e.key != start && point_of(e)) keys.push_back(e.key);
  }
  return keys;
}

// The runs of a design together; nothing where the store has none of them.
std::optional<Answer> LearningLoop::answer_of(const std::vector<std::string>& keys) const {
  std::vector<Evaluation> runs;
  for (const std::string& key : keys)
    if (auto stored = store_.find(key)) runs.push_back(std::move(*stored));
  if (runs.empty()) return {};
  Answer answer;
  answer.feasible = std::any_of(runs.begin(), runs.end(),
                                [](const Evaluation& e) { return e.status == EvaluationStatus::ok; });
  for (Evaluation& e : runs)
    apply_constraints({}, e);  // the load of a design that breaks one is worth knowing
  const RankedDesign row = rank_designs(runs, spec_.rank_by).rows.front();
  const MeanEstimate load = value_estimate(row, spec_.rank_by);
  answer.value = row.value;
  answer.variance =
      std::isfinite(load.standard_error) ? load.standard_error * load.standard_error : std::nan("");
  answer.exact = load.standard_error == 0.0;
  for (const ResultConstraint& c : spec_.constraints) {
    const double value = number_at(row.evaluation.result, c.at);
    if (std::isfinite(c.lower)) answer.reserves.push_back(value - c.lower);
    if (std::isfinite(c.upper)) answer.reserves.push_back(c.upper - value);
  }
  return answer;
}

void LearningLoop::add_known(LearningProblem& problem) {
  for (const Json& paid : record_.at("paid")) {
    const auto stored = store_.find(paid.get<std::string>());
    const auto x = stored ? point_of(*stored) : std::nullopt;
    if (!x) continue;
    std::vector<std::string> keys;
    for (const PlannedDesign& run : runs_of(spec_, design_at(spec_, stored->name, *x)))
      keys.push_back(run.key);
    const auto answer = answer_of(keys);
    if (!answer) continue;
    problem.known.push_back(*x), problem.known_answers.push_back(*answer);
    keys_[*x] = stored->key;
  }
}

void LearningLoop::add_prior(LearningProblem& problem) {
  if (spec_.method.learning.prior == Prior::none) return;
  const auto feasible = [&](const Point& x) {
    const std::vector<double> margins = hooks_.margins(x);
    return std::all_of(margins.begin(), margins.end(), [](double g) { return g >= 0.0; });
  };
  if (!record_.contains("prior")) {
    record_["prior"] = icebow::to_json(cheap_table(spec_, settings_, feasible, hooks_.pause));
    keep();
  }
  problem.prior = cheap_response(spec_, cheap_table_from(record_.at("prior")));
  if (!problem.prior)
    notes_.push_back(
        "the cheaper response has too few values within the ranges to begin the model with: it "
        "begins with none");
}

// Points go through the unit cube and back: to a rounding.
std::string LearningLoop::key_of(const Point& x) const {
  const std::vector<Variable>& variables = spec_.method.variables;
  for (const auto& [point, key] : keys_) {
    bool same = true;
    for (std::size_t k = 0; k < x.size(); ++k)
      same = same && std::fabs(point[k] - x[k]) < 1e-9 * (variables[k].upper - variables[k].lower);
    if (same) return key;
  }
  return "";
}

std::string load_words(double value, const std::string& rank_by) {
  return text("%.4g %s", value / 1e3, rank_by == "mean_load_per_beam" ? "kN/m" : "kN");
}

std::string LearningLoop::on_model(const LearningResult& result) const {
  const auto stored = store_.find(key_of(result.best));
  std::string words = "by what " + std::string(learning_algorithm) + " has learnt the lowest is ";
  words += (stored ? stored->name : "a design without a name") + ", " +
           load_words(result.value, spec_.rank_by) + " \u00b1 " + load_words(1.96 * result.sd, spec_.rank_by);
  words += "; a value left out is met within " + load_words(result.left_out_error, spec_.rank_by) + " (rms)";
  if (result.noise_sd > 0.0) words += ", of which noise is " + load_words(result.noise_sd, spec_.rank_by);
  if (std::isfinite(result.prior_factor))
    words += text("; %.3g of the %s is part of it", result.prior_factor,
                  spec_.method.learning.prior == Prior::cycle ? "cycle's load" : "formula's load");
  return words;
}

std::string LearningLoop::summary(const LearningResult& result) const {
  std::string words = text("%s ended after %d points, %d of them the initial design", learning_algorithm,
                           result.evaluations, result.initial);
  if (result.known > 0) words += text(", and %d that were paid for before", result.known);
  words += ": " + result.reason;
  if (std::isfinite(result.gain)) words += " (" + load_words(result.gain, spec_.rank_by) + ")";
  return words;
}

std::vector<std::string> LearningLoop::run() {
  take_up();
  LearningProblem problem;
  for (const Variable& v : spec_.method.variables)
    problem.lower.push_back(v.lower), problem.upper.push_back(v.upper);
  problem.start = start_point(spec_);
  problem.margins = hooks_.margins;
  problem.ask = [&](const std::vector<Point>& points) {
    std::vector<Answer> answers;
    const auto keys = hooks_.evaluate(points);
    for (std::size_t i = 0; i < points.size(); ++i) {
      keys_[points[i]] = keys[i].front();
      answers.push_back(answer_of(keys[i]).value());
    }
    return answers;
  };
  problem.remembered = [&](const std::string& state) -> std::optional<LearningRound> {
    hooks_.pause();
    const Json& rounds = record_.at("rounds");
    return rounds.contains(state) ? std::optional(round_from(state, rounds.at(state))) : std::nullopt;
  };
  problem.remember = [&](const LearningRound& round) {
    record_["rounds"][round.state] = to_json(round);
    keep();
  };
  add_known(problem);
  add_prior(problem);
  const Learning& asked = spec_.method.learning;
  const LearningResult result = search_by_learning(problem, {spec_.method.seed, spec_.method.max_evaluations,
                                                             asked.initial, asked.batch, asked.least_gain});
  notes_.push_back(summary(result));
  if (!result.best.empty()) notes_.push_back(on_model(result));
  return notes_;
}

}  // namespace

std::vector<std::string> run_learning(const StudySpec& spec, const RunSettings& settings, Store& store,
                                      const LearningHooks& hooks) {
  return LearningLoop(spec, settings, store, hooks).run();
}

}  // namespace icebow
