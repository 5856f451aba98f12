// How many noisy evaluations each search needs: the optimisers a study file offers and OpenTURNS' efficient
// global optimisation, on known functions and on the formula's load over the four angles of a bow.
//
//   searches [--seeds 20] [--budget 100] [--only SEARCH] [--landscape NAME] [--noise 0.02]
//
// A value has normal noise of known size. Each search begins somewhere else for each seed. Markdown on
// stdout; a line for each run on stderr.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <limits>
#include <openturns/ConstantBasisFactory.hxx>
#include <openturns/EfficientGlobalOptimization.hxx>
#include <openturns/KrigingAlgorithm.hxx>
#include <openturns/Log.hxx>
#include <openturns/MaternModel.hxx>
#include <openturns/RandomGenerator.hxx>
#include <openturns/SymbolicFunction.hxx>
#include <random>
#include <string>

#include "base/units.h"
#include "formula/lindqvist.h"
#include "hullgen/bow/bow_volume.h"
#include "study/evaluate/evaluator_inputs.h"
#include "study/learn/first_points.h"
#include "study/learn/learning_search.h"
#include "study/plan/optimiser.h"
#include "study/spec/case_hull.h"
#include "study/spec/read_study.h"
#include "study/spec/spec_method.h"
#include "tests/support/known_landscapes.h"

using namespace icebow;

namespace {

using Point = std::vector<double>;

constexpr const char* openturns = "OpenTURNS EGO";

// What is searched, with its smallest value and what lies between that and the mean over the box.
struct Landscape {
  std::string name;
  Point lower, upper;
  std::function<double(const Point&)> value;
  std::function<Point(const Point&)> margins;
  double best = 0.0;
  double two_percent = 0.0;  // above the best
  // A constraint on a result: known only with the value, 0 or more where it is kept, of order one.
  std::function<double(const Point&)> reserve = nullptr;
};

// The formula's total of a bow of the paper's family over its four angles [kN].
struct Bow {
  StudySpec spec = read_study(Json::parse(R"({"icebow_study": 1, "evaluators": ["lindqvist"],
    "bow": {"family": "straight_parallel_buttocks", "length_m": 147.2, "beam_m": 23.0, "draft_m": 8.0, "depth_m": 13.5,
            "bow_length_m": 32.5, "stem_deg": 24.35, "waterline_deg": 22, "buttock_deg": 28, "flare_deg": 33},
    "ice": {"thickness_m": 1.0}, "operation": {"speed_kn": 4.0}})"),
                              "bow.json");
  Case at(const Point& x) const {
    Case c = spec.baseline;
    c.bow.angles.stem = radians(x[0]), c.bow.angles.waterline = radians(x[1]);
    c.bow.angles.buttock = radians(x[2]), c.bow.angles.flare = radians(x[3]);
    return c;
  }
  double load(const Point& x) const { return lindqvist(lindqvist_inputs(at(x))).breaking / 1e3; }
  // Of the displacement: 2 % more than that of the paper's bow, over it.
  double reserve(const Point& x) const {
    return bow_displacement(at(x).bow) / bow_displacement(spec.baseline.bow) - 1.02;
  }
  Point margins(const Point& x) const {
    Point values;
    for (const Margin& margin : check_feasibility(at(x)).margins)
      if (margin.required) values.push_back(margin.value);
    return values;
  }
};

bool is_kept(const Landscape& l, const Point& x) {
  if (!l.margins) return true;
  for (const double g : l.margins(x))
    if (!(g >= 0.0)) return false;
  return true;
}

bool is_good(const Landscape& l, const Point& x) {
  return is_kept(l, x) && (!l.reserve || l.reserve(x) >= 0.0);
}

Point random_point(const Landscape& l, std::mt19937_64& random) {
  for (;;) {
    Point x;
    for (std::size_t k = 0; k < l.lower.size(); ++k)
      x.push_back(l.lower[k] + (l.upper[k] - l.lower[k]) * static_cast<double>(random() >> 11) * 0x1p-53);
    if (is_kept(l, x)) return x;
  }
}

void add_limit(OptimiserProblem& problem, const Landscape& l) {
  if (!l.reserve) return;
  problem.limits = 1;
  problem.limit_margins = [&l](const Point& x) { return Point{l.reserve(x)}; };
}

// The best of many local searches; a known optimum is met by them.
void find_best(Landscape& l) {
  std::mt19937_64 random(1);
  l.best = 1e300;
  for (int k = 0; k < 40; ++k) {
    OptimiserProblem problem{l.lower, l.upper, random_point(l, random), l.value, l.margins};
    add_limit(problem, l);
    const OptimiserResult found = optimise(problem, {"cobyla", 1, 2000, 1e-7});
    if (!found.best.empty()) l.best = std::min(l.best, found.value);
  }
  double sum = 0.0;
  constexpr int many = 20000;
  for (int k = 0; k < many; ++k) sum += l.value(random_point(l, random));
  l.two_percent = l.margins ? 0.02 * l.best : 0.02 * (sum / many - l.best);
}

std::vector<Landscape> landscapes() {
  static const Bow bow;
  std::vector<Landscape> all = {{"Branin", {-5, 0}, {10, 15}, branin, nullptr},
                                {"Hartmann 3", {0, 0, 0}, {1, 1, 1}, hartmann3, nullptr},
                                {"Hartmann 6", Point(6, 0.0), Point(6, 1.0), hartmann6, nullptr},
                                {"bow",
                                 {18, 16, 22, 25},
                                 {32, 30, 36, 45},
                                 [](const Point& x) { return bow.load(x); },
                                 [](const Point& x) { return bow.margins(x); }}};
  Landscape held = all.back();
  held.name = "bow that displaces", held.reserve = [](const Point& x) { return bow.reserve(x); };
  all.push_back(held);
  for (Landscape& l : all) find_best(l);
  return all;
}

// One run's evaluations as they come.
class Record {
 public:
  Record(const Landscape& l, double noise, std::uint64_t seed)
      : l_(l), noise_(noise), random_(seed * 7919 + 1) {}
  double operator()(const Point& x) {
    const double exact = l_.value(x);
    const bool kept = is_good(l_, x);
    ++calls;
    if (kept && exact <= l_.best + l_.two_percent && found == 0) found = calls;
    const double value = exact + noise_ * random_();
    if (kept && value < luckiest) luckiest = value, recommended = x;
    return value;
  }
  int calls = 0, found = 0;  // the first within 2 %; 0 = none
  double luckiest = std::numeric_limits<double>::infinity();
  Point recommended;  // of the smallest noisy value

 private:
  const Landscape& l_;
  double noise_;
  Noise random_;
};

struct Outcome {
  int found = 0;
  double above = std::numeric_limits<double>::infinity();  // of the point recommended at the end, over 2 %
};

struct Task {
  const Landscape& l;
  double noise;
  std::uint64_t seed;
  Point start;
};

Outcome by_nlopt(const Task& t, const std::string& algorithm, int budget) {
  Record record(t.l, t.noise, t.seed);
  OptimiserProblem problem{t.l.lower, t.l.upper, t.start, nullptr, t.l.margins};
  problem.value = [&](const Point& x) { return record(x); };
  add_limit(problem, t.l);
  optimise(problem, {algorithm, t.seed, budget, 0.0});
  if (record.recommended.empty()) return {};
  return {record.found, (t.l.value(record.recommended) - t.l.best) / t.l.two_percent};
}

Outcome by_learning(const Task& t, int budget) {
  Record record(t.l, t.noise, t.seed);
  LearningProblem problem;
  problem.lower = t.l.lower, problem.upper = t.l.upper, problem.start = t.start;
  problem.margins = t.l.margins;
  problem.ask = [&](const std::vector<Point>& points) {
    std::vector<Answer> answers;
    for (const Point& x : points) {
      Answer answer;
      answer.value = record(x), answer.variance = t.noise * t.noise, answer.exact = true;
      if (t.l.reserve) answer.reserves = {t.l.reserve(x)};
      answers.push_back(answer);
    }
    return answers;
  };
  LearningOptions options;
  options.seed = t.seed, options.max_evaluations = budget, options.least_gain = 0.0;
  const LearningResult result = search_by_learning(problem, options);
  if (result.best.empty()) return {};
  return {record.found, (t.l.value(result.best) - t.l.best) / t.l.two_percent};
}

class Recorded : public OT::EvaluationImplementation {
 public:
  Recorded(const Landscape* l, Record* record) : l_(l), record_(record) {}
  Recorded* clone() const override { return new Recorded(*this); }
  OT::UnsignedInteger getInputDimension() const override { return l_->lower.size(); }
  OT::UnsignedInteger getOutputDimension() const override { return 1; }
  OT::Point operator()(const OT::Point& x) const override {
    const Point point(x.begin(), x.end());
    if (is_good(*l_, point)) return OT::Point(1, worst_ = std::max(worst_, (*record_)(point)));
    ++record_->calls;
    return OT::Point(1, worst_);
  }

 private:
  const Landscape* l_;
  Record* record_;
  mutable double worst_ = -1e300;
};

// With the first points of ours, a Matern covariance of the same smoothness, the noise it is told, and its
// own defaults for the rest. It has no constraints: an infeasible point gets the worst value so far.
Outcome by_openturns(const Task& t, int budget) {
  OT::Log::Show(OT::Log::NONE);
  OT::RandomGenerator::SetSeed(t.seed);
  Record record(t.l, t.noise, t.seed);
  const std::size_t d = t.l.lower.size();
  OT::Sample x(0, d), y(0, 1);
  const auto add = [&](const Point& point) {
    OT::Point p(d);
    for (std::size_t k = 0; k < d; ++k) p[k] = point[k];
    x.add(p), y.add(OT::Point(1, record(point)));
  };
  add(t.start);
  Point unit(d);
  for (std::size_t k = 0; k < d; ++k) unit[k] = (t.start[k] - t.l.lower[k]) / (t.l.upper[k] - t.l.lower[k]);
  const auto in_units = [&](const Point& u) {
    Point p(d);
    for (std::size_t k = 0; k < d; ++k) p[k] = t.l.lower[k] + u[k] * (t.l.upper[k] - t.l.lower[k]);
    return p;
  };
  for (const Point& u : first_points(static_cast<int>(d), static_cast<int>(2 * d + 1), t.seed, {unit},
                                     [&](const Point& p) { return is_kept(t.l, in_units(p)); }))
    add(in_units(u));
  OT::Point low(d), high(d), scale(d);
  for (std::size_t k = 0; k < d; ++k) {
    low[k] = t.l.lower[k], high[k] = t.l.upper[k];
    scale[k] = 0.5 * (high[k] - low[k]);
  }
  try {
    OT::KrigingAlgorithm kriging(x, y, OT::MaternModel(scale, OT::Point(1, 1.0), 2.5),
                                 OT::ConstantBasisFactory(d).build());
    if (t.noise > 0.0) kriging.setNoise(OT::Point(x.getSize(), t.noise * t.noise));
    kriging.run();
    OT::OptimizationProblem problem(OT::Function(Recorded(&t.l, &record)));
    problem.setBounds(OT::Interval(low, high));
    OT::Description names;
    for (std::size_t k = 0; k < d; ++k) names.add("x" + std::to_string(k));
    const OT::SymbolicFunction noise(names,
                                     OT::Description(1, std::to_string(t.noise * t.noise) + " + 0 * x0"));
    OT::EfficientGlobalOptimization ego =
        t.noise > 0.0 ? OT::EfficientGlobalOptimization(problem, kriging.getResult(), noise)
                      : OT::EfficientGlobalOptimization(problem, kriging.getResult());
    if (t.noise > 0.0) ego.setMetamodelNoise(noise);
    ego.setMaximumEvaluationNumber(static_cast<unsigned>(budget) - x.getSize());
    ego.setCorrelationLengthFactor(0.0), ego.setImprovementFactor(0.0);
    ego.run();
  } catch (const std::exception& error) {
    std::fprintf(stderr, "OpenTURNS: %s\n", error.what());
  }
  return {record.found, (t.l.value(record.recommended) - t.l.best) / t.l.two_percent};
}

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const std::size_t n = values.size();
  return 0.5 * (values[(n - 1) / 2] + values[n / 2]);
}

std::string shown(double evaluations) {
  return std::isfinite(evaluations) ? std::to_string(static_cast<int>(std::lround(evaluations))) : "-";
}

// Of a search that is begun anew each time the budget is spent, until it succeeds [Auger2005].
double expected(const std::vector<double>& found, int budget) {
  double spent = 0.0, successes = 0.0;
  for (const double evaluations : found) {
    spent += std::isfinite(evaluations) ? evaluations : budget;
    successes += std::isfinite(evaluations);
  }
  return spent / successes;
}

struct Options {
  int seeds = 20, budget = 100;
  double noise = 0.02;  // over 2 % of the way
  std::string only, landscape;
};

Outcome outcome_of(const Task& task, const std::string& search, int budget) {
  if (search == learning_algorithm) return by_learning(task, budget);
  return search == openturns ? by_openturns(task, budget) : by_nlopt(task, search, budget);
}

void print_row(const Landscape& l, const std::string& search, const Options& options) {
  std::vector<double> found, above;
  for (int seed = 1; seed <= options.seeds; ++seed) {
    const auto number = static_cast<std::uint64_t>(seed);
    std::mt19937_64 random(number);
    const Task task{l, options.noise / 0.02 * l.two_percent, number, random_point(l, random)};
    const Outcome o = outcome_of(task, search, options.budget);
    found.push_back(o.found > 0 ? o.found : std::numeric_limits<double>::infinity());
    above.push_back(o.above);
    std::fprintf(stderr, "%s, %s, seed %d: %d, %.2f\n", l.name.c_str(), search.c_str(), seed, o.found,
                 o.above);
  }
  const auto successes = std::count_if(found.begin(), found.end(), [](double n) { return std::isfinite(n); });
  std::printf("| %s | %d | %s | %s | %.2f |\n", search.c_str(), static_cast<int>(successes),
              shown(expected(found, options.budget)).c_str(), shown(median(found)).c_str(), median(above));
  std::fflush(stdout);
}

void print_table(const Landscape& l, const Options& options) {
  std::printf("\n%s: least %.4g, 2 %% are %.3g, noise %.3g\n\n", l.name.c_str(), l.best, l.two_percent,
              options.noise / 0.02 * l.two_percent);
  std::printf(
      "| search | found, of %d | expected evaluations | median | above the least after %d, over 2 %% |\n",
      options.seeds, options.budget);
  std::printf("|---|---|---|---|---|\n");
  std::vector<std::string> searches = {learning_algorithm, openturns};
  for (const std::string& name : optimiser_names()) searches.push_back(name);
  for (const std::string& search : searches)
    if (options.only.empty() || options.only == search) print_row(l, search, options);
}

}  // namespace

int main(int argc, char** argv) {
  Options options;
  for (int i = 1; i + 1 < argc; i += 2) {
    const std::string option = argv[i];
    if (option == "--seeds")
      options.seeds = std::atoi(argv[i + 1]);
    else if (option == "--budget")
      options.budget = std::atoi(argv[i + 1]);
    else if (option == "--noise")
      options.noise = std::atof(argv[i + 1]);
    else if (option == "--only")
      options.only = argv[i + 1];
    else if (option == "--landscape")
      options.landscape = argv[i + 1];
    else
      return std::fprintf(stderr, "searches: %s is not known\n", argv[i]), 2;
  }
  for (const Landscape& l : landscapes())
    if (options.landscape.empty() || options.landscape == l.name) print_table(l, options);
  return 0;
}
