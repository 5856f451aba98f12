#include "study/run/cheap_response.h"

#include <algorithm>
#include <cmath>
#include <future>
#include <memory>
#include <thread>

#include "base/json_fields.h"
#include "study/evaluate/result_keys.h"
#include "study/learn/first_points.h"
#include "study/learn/gaussian_process.h"
#include "study/plan/design_space.h"

namespace icebow {
namespace {

using Point = std::vector<double>;

constexpr int points_of_each = 16;     // variable, and as many again
constexpr int candidates_of_each = 8;  // for each point, where some are not feasible

Point in_units(const StudySpec& spec, const Point& u) {
  Point x;
  for (std::size_t k = 0; k < u.size(); ++k) {
    const Variable& v = spec.method.variables[k];
    x.push_back(rounded(v.lower + u[k] * (v.upper - v.lower)));
  }
  return x;
}

double value_at(const StudySpec& spec, const RunSettings& settings, const Point& x) {
  const bool by_cycle = spec.method.learning.prior == Prior::cycle;
  Json document = design_at(spec, "cheap", x).design.document;
  document["evaluators"] = Json::array({by_cycle ? "cycle" : "lindqvist"});
  document.erase("constraints");
  const Design design = read_design("cheap", std::move(document));
  if (!design.given) return std::nan("");
  const Evaluation e = settings.evaluate(Communicator::serial(), design, {});
  if (e.status != EvaluationStatus::ok) return std::nan("");
  return number_at(e.result, by_cycle ? result_key::cycle_load : result_key::lindqvist_total);
}

}  // namespace

Json to_json(const CheapTable& table) {
  return {{"points", table.points}, {"values", table.values}};
}

CheapTable cheap_table_from(const Json& json) {
  return {json.at("points").get<std::vector<Point>>(), json.at("values").get<std::vector<double>>()};
}

CheapTable cheap_table(const StudySpec& spec, const RunSettings& settings,
                       const std::function<bool(const Point&)>& feasible,
                       const std::function<void()>& pause) {
  const int d = static_cast<int>(spec.method.variables.size());
  const std::size_t wanted = static_cast<std::size_t>(points_of_each) * static_cast<std::size_t>(d + 1);
  std::vector<Point> points;
  for (const Point& u : turned_sequence(d, static_cast<int>(wanted) * candidates_of_each, spec.method.seed)) {
    const Point x = in_units(spec, u);
    if (points.size() < wanted && feasible(x)) points.push_back(x);
  }
  const std::size_t threads = std::max(1U, std::thread::hardware_concurrency());
  CheapTable table;
  for (std::size_t first = 0; first < points.size(); first += threads) {
    pause();
    std::vector<std::future<double>> values;
    for (std::size_t i = first; i < std::min(points.size(), first + threads); ++i)
      values.push_back(
          std::async(std::launch::async, [&, i] { return value_at(spec, settings, points[i]); }));
    for (std::size_t k = 0; k < values.size(); ++k) {
      const double value = values[k].get();
      if (std::isfinite(value)) table.points.push_back(points[first + k]), table.values.push_back(value);
    }
  }
  return table;
}

std::function<double(const Point&)> cheap_response(const StudySpec& spec, const CheapTable& table) {
  const auto n = static_cast<Eigen::Index>(table.values.size());
  const std::vector<Variable> variables = spec.method.variables;
  const auto d = static_cast<Eigen::Index>(variables.size());
  if (n < 2 * (d + 1)) return {};
  const auto in_cube = [variables, d](const Point& x) {
    Eigen::RowVectorXd u(d);
    for (Eigen::Index k = 0; k < d; ++k) {
      const Variable& v = variables[static_cast<std::size_t>(k)];
      u[k] = (x[static_cast<std::size_t>(k)] - v.lower) / (v.upper - v.lower);
    }
    return u;
  };
  Observations o;
  o.points.resize(n, d);
  for (Eigen::Index i = 0; i < n; ++i) o.points.row(i) = in_cube(table.points[static_cast<std::size_t>(i)]);
  o.values = Eigen::Map<const Eigen::VectorXd>(table.values.data(), n);
  o.variances = Eigen::VectorXd::Zero(n);
  o.exact = spec.method.learning.prior == Prior::lindqvist;
  const auto process = std::make_shared<const GaussianProcess>(fit_process(o));
  if (!process->usable()) return {};
  return [process, in_cube](const Point& x) { return process->at(in_cube(x), Eigen::VectorXd()).mean[0]; };
}

}  // namespace icebow
