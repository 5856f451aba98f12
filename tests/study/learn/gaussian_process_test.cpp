#include "study/learn/gaussian_process.h"

#include <catch2/catch.hpp>
#include <cmath>

#include "study/learn/expected_gain.h"
#include "tests/support/known_landscapes.h"

using namespace icebow;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

Observations observe(int n, int d, double noise, const std::function<double(const std::vector<double>&)>& f,
                     std::uint64_t seed = 3) {
  Noise random(seed);
  Observations o;
  o.points.resize(n, d), o.values.resize(n);
  o.variances = VectorXd::Constant(n, noise * noise);
  for (int i = 0; i < n; ++i) {
    std::vector<double> x;
    for (int k = 0; k < d; ++k) x.push_back(o.points(i, k) = random.uniform());
    o.values[i] = f(x) + noise * random();
  }
  o.exact = true;
  return o;
}

double wave(const std::vector<double>& x) {
  return std::sin(4.0 * x[0]) + x[1] * x[1];
}

double spread(const VectorXd& y) {
  return std::sqrt((y.array() - y.mean()).square().mean());
}

double matern(double r) {
  return (1.0 + std::sqrt(5.0) * r + 5.0 * r * r / 3.0) * std::exp(-std::sqrt(5.0) * r);
}

}  // namespace

TEST_CASE("mean and deviation are those of the formulas, by plain inverses") {
  const Observations o = observe(7, 2, 0.1, wave);
  const std::vector<double> parameters = {std::log(0.4), std::log(0.9), std::log(1.3)};
  const GaussianProcess process(std::make_shared<const Observations>(o), parameters);
  const double unit = spread(o.values), signal = 1.3 * unit * unit;
  const auto covariance = [&](const Eigen::RowVectorXd& a, const Eigen::RowVectorXd& b) {
    return signal * matern(std::hypot((a[0] - b[0]) / 0.4, (a[1] - b[1]) / 0.9));
  };
  const Eigen::RowVectorXd x = Eigen::RowVector2d(0.3, 0.6);
  MatrixXd k(7, 7);
  VectorXd c(7);
  for (int i = 0; i < 7; ++i) {
    c[i] = covariance(o.points.row(i), x);
    for (int j = 0; j < 7; ++j)
      k(i, j) = covariance(o.points.row(i), o.points.row(j)) + (i == j ? o.variances[i] : 0.0);
  }
  const MatrixXd inverse = k.inverse();
  const VectorXd ones = VectorXd::Ones(7);
  const double weight = ones.dot(inverse * ones), beta = ones.dot(inverse * o.values) / weight;
  const VectorXd residual = o.values - beta * ones;
  const double u = 1.0 - ones.dot(inverse * c);
  const Predictions p = process.at(x, VectorXd());
  CHECK(p.mean[0] == Approx(beta + c.dot(inverse * residual)).epsilon(1e-6));  // a jitter of 1e-9 over s^2
  CHECK(p.sd[0] ==
        Approx(std::sqrt(signal - c.dot(inverse * c) + u * u / weight)).epsilon(1e-6));  // the jitter
  const double ln = std::log((k / (unit * unit)).determinant()) + std::log(weight * unit * unit) +
                    residual.dot(inverse * residual);
  CHECK(process.log_likelihood() == Approx(-0.5 * ln).epsilon(1e-6));  // the jitter
}

TEST_CASE("a value left out is predicted as by a process that never had it") {
  const Observations o = observe(9, 2, 0.05, wave);
  const std::vector<double> parameters = {std::log(0.5), std::log(0.7), 0.2};
  const GaussianProcess process(std::make_shared<const Observations>(o), parameters);
  double sum = 0.0;
  for (int i = 0; i < 9; ++i) {
    Observations rest = o;
    for (int j = i; j < 8; ++j) {
      rest.points.row(j) = o.points.row(j + 1);
      rest.values[j] = o.values[j + 1], rest.variances[j] = o.variances[j + 1];
    }
    rest.points.conservativeResize(8, Eigen::NoChange);
    rest.values.conservativeResize(8), rest.variances.conservativeResize(8);
    std::vector<double> same = parameters;  // s^2 is over the variance of the values, which are others now
    same[2] += 2.0 * std::log(spread(o.values) / spread(rest.values));
    const GaussianProcess without(std::make_shared<const Observations>(rest), same);
    sum += std::pow(without.at(o.points.row(i), VectorXd()).mean[0] - o.values[i], 2);
  }
  CHECK(process.left_out().rms_error ==
        Approx(std::sqrt(sum / 9)).epsilon(1e-5));  // the jitter, through two inverses
}

TEST_CASE("exact values are met, and what lies between them is within its interval as often as it says") {
  const Observations o = observe(40, 2, 0.0, wave);
  const GaussianProcess process = fit_process(o);
  REQUIRE(process.usable());
  const Predictions there = process.at(o.points, VectorXd());
  CHECK((there.mean - o.values).cwiseAbs().maxCoeff() < 1e-4);  // the jitter
  const Observations elsewhere = observe(400, 2, 0.0, wave, 17);
  const Predictions p = process.at(elsewhere.points, VectorXd());
  const auto outside = ((p.mean - elsewhere.values).array().abs() > 1.96 * p.sd.array()).count();
  CHECK(outside < 60);  // 20 of 400 where the function is a draw of the process, which this one is not
}

TEST_CASE("noise that nobody knows is found in the scatter of the values") {
  Observations o = observe(60, 2, 0.15, wave);
  o.variances.setZero();
  o.exact = false;
  const double sd = std::sqrt(fit_process(o).noise_variance());
  CHECK(sd > 0.11);  // of 60 values, some ten of them spent on the function: 0.15 within two errors of 0.02
  CHECK(sd < 0.19);
}

TEST_CASE("a cheaper response is taken in where it helps, and left out where it does not") {
  const auto bumpy = [](const std::vector<double>& x) {
    return std::sin(25.0 * x[0]) * std::cos(21.0 * x[1]);
  };
  Observations o = observe(25, 2, 0.0, [&](const auto& x) { return 3.0 * bumpy(x) + 0.2 * wave(x); });
  o.prior.resize(25);
  for (int i = 0; i < 25; ++i) o.prior[i] = bumpy({o.points(i, 0), o.points(i, 1)});
  const GaussianProcess with = fit_process(o);
  CHECK(with.prior_factor() == Approx(3.0).epsilon(0.05));  // 25 values of 0.2 wave() beside it
  for (int i = 0; i < 25; ++i) o.prior[i] = std::sin(1000.0 * o.points(i, 0));
  CHECK(std::isnan(fit_process(o).prior_factor()));
}

TEST_CASE("a believed value changes no mean there, and takes the doubt away") {
  const GaussianProcess process = fit_process(observe(15, 2, 0.1, wave));
  const Eigen::RowVectorXd x = Eigen::RowVector2d(0.9, 0.05);
  const Predictions before = process.at(x, VectorXd());
  const Predictions after = process.believing(x, 0.0).at(x, VectorXd());
  CHECK(after.mean[0] == Approx(before.mean[0]).epsilon(1e-6));  // the jitter
  CHECK(after.sd[0] < before.sd[0]);
}

TEST_CASE("expected improvement is the integral that it stands for, far out too") {
  for (const double z : {-3.0, -1.0, 0.0, 0.7, 2.5}) {
    const double sd = 0.4, mean = 1.0, target = mean + z * sd;
    double sum = 0.0;
    constexpr int steps = 200000;
    for (int i = 0; i < steps; ++i) {
      const double t = -10.0 + 20.0 * (i + 0.5) / steps, y = mean + sd * t;
      sum += std::max(target - y, 0.0) * std::exp(-0.5 * t * t) / std::sqrt(2.0 * M_PI) * 20.0 / steps;
    }
    CHECK(log_expected_improvement(target, mean, sd) == Approx(std::log(sum)).epsilon(1e-6));  // of the sum
  }
  // Where one formula takes over from the other they agree, but for the next term of the tail.
  const double near = log_expected_improvement(-19.9999999, 0.0, 1.0),
               far = log_expected_improvement(-20.0000001, 0.0, 1.0);
  CHECK(near - far < 1e-5);  // 2e-7 of z, and the next term of the tail
  CHECK(near > far);
  CHECK(log_probability_kept(-19.9999999, 1.0) ==
        Approx(log_probability_kept(-20.0000001, 1.0)).margin(1e-5));  // likewise
  CHECK(log_worth_of_noisy(3.0, 16.0) == Approx(std::log(1.0 - 4.0 / 5.0)));
  CHECK(log_worth_of_noisy(3.0, 0.0) == 0.0);
}
