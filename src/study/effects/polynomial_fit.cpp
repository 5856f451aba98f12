#include "study/effects/polynomial_fit.h"

#include <algorithm>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>
#include <random>

namespace icebow {
namespace {

using Index = Eigen::Index;
using Matrix = Eigen::MatrixXd;
using Vector = Eigen::VectorXd;

double legendre(int degree, double x) {
  if (degree == 1) return std::sqrt(3.0) * x;
  if (degree == 2) return std::sqrt(5.0) * 0.5 * (3.0 * x * x - 1.0);
  return degree == 3 ? std::sqrt(7.0) * 0.5 * x * (5.0 * x * x - 3.0) : 1.0;
}

std::vector<Term> terms_of(FitTerms kind, Index axes) {
  std::vector<Term> terms = {Term()};
  const int highest = kind == FitTerms::linear ? 1 : kind == FitTerms::cubes ? 3 : 2;
  for (int degree = 1; degree <= highest; ++degree)
    for (Index k = 0; k < axes; ++k) terms.push_back({k, -1, degree});
  if (kind == FitTerms::linear || kind == FitTerms::squares) return terms;
  for (Index a = 0; a < axes; ++a)
    for (Index b = a + 1; b < axes; ++b) terms.push_back({a, b, 1});
  return terms;
}

double value(const Term& term, const Eigen::RowVectorXd& x) {
  const double first = term.first < 0 ? 1.0 : legendre(term.degree, x(term.first));
  return term.second < 0 ? first : first * legendre(1, x(term.second));
}

// Sums of squared coefficients: of all axes together, and of each by itself and with its products.
struct Variances {
  double all = 0.0;
  std::vector<double> first, total;
};

// `off`: what is taken off each square.
Variances variances(const std::vector<Term>& terms, const Vector& beta, const Vector& off, Index axes) {
  Variances v;
  v.first.resize(static_cast<std::size_t>(axes), 0.0), v.total = v.first;
  for (std::size_t t = 0; t < terms.size(); ++t) {
    const Term& term = terms[t];
    if (term.first < 0) continue;
    const double square = std::pow(beta(static_cast<Index>(t)), 2) - off(static_cast<Index>(t));
    v.all += square;
    v.total[static_cast<std::size_t>(term.first)] += square;
    (term.second < 0 ? v.first
                     : v.total)[static_cast<std::size_t>(term.second < 0 ? term.first : term.second)] +=
        square;
  }
  return v;
}

double share(double part, double all) {
  return all > 0.0 ? std::clamp(part / all, 0.0, 1.0) : part > 0.0 ? 1.0 : 0.0;
}

double quantile(std::vector<double>& values, double q) {
  const auto at = static_cast<std::ptrdiff_t>(q * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), values.begin() + at, values.end());
  return values[static_cast<std::size_t>(at)];
}

Share with_interval(double value, std::vector<double> drawn) {
  return {value, std::min(value, quantile(drawn, 0.025)), std::max(value, quantile(drawn, 0.975))};
}

// R with R R' = m, of a matrix that may be singular: a polynomial may fit without any error.
Matrix root_of(const Matrix& m) {
  const Eigen::SelfAdjointEigenSolver<Matrix> solver(m);
  return solver.eigenvectors() * solver.eigenvalues().cwiseMax(0.0).cwiseSqrt().asDiagonal();
}

// Coefficients that might be the true ones, drawn with the errors of the fit.
class Draws {
 public:
  Draws(const PolynomialFit& fit, std::uint64_t seed)
      : fit_(fit), root_(root_of(fit.covariance)), random_(seed), chi_square_(fit.freedom) {}
  Vector next() {
    Vector z(fit_.beta.size());
    for (Index i = 0; i < z.size(); ++i) z(i) = normal_(random_);
    return fit_.beta + std::sqrt(fit_.freedom / chi_square_(random_)) * (root_ * z);
  }

 private:
  const PolynomialFit& fit_;
  Matrix root_;
  std::mt19937_64 random_;
  std::normal_distribution<double> normal_;
  std::chi_squared_distribution<double> chi_square_;
};

}  // namespace

Vector PolynomialFit::row(const Eigen::RowVectorXd& x) const {
  Vector values(static_cast<Index>(terms.size()));
  for (std::size_t t = 0; t < terms.size(); ++t) values(static_cast<Index>(t)) = value(terms[t], x);
  return values;
}

double PolynomialFit::at(const Eigen::RowVectorXd& x) const {
  return row(x).dot(beta);
}

double PolynomialFit::half_width(const Vector& combination) const {
  const double t = boost::math::quantile(boost::math::students_t(freedom), 0.975);
  return t * std::sqrt(std::max(0.0, combination.dot(covariance * combination)));
}

bool fit_polynomial(const Matrix& x, const Vector& y, FitTerms kind, PolynomialFit& fit) {
  fit = PolynomialFit();
  fit.kind = kind, fit.terms = terms_of(kind, x.cols());
  const Index n = y.size(), m = static_cast<Index>(fit.terms.size());
  if (n < m + 3) return false;
  Matrix a(n, m);
  for (Index i = 0; i < n; ++i) a.row(i) = fit.row(x.row(i)).transpose();
  Eigen::ColPivHouseholderQR<Matrix> qr(a);
  qr.setThreshold(1e-6);  // parameters that move together leave no more than this of each other
  if (qr.rank() < m) return false;
  fit.beta = qr.solve(y);
  const Vector residual = y - a * fit.beta;
  fit.freedom = static_cast<double>(n - m);
  const Matrix inverse = (a.transpose() * a).inverse();
  fit.covariance = inverse * residual.squaredNorm() / fit.freedom;
  // Leaving out value i changes its own residual by 1 / (1 - leverage).
  double sum = 0.0;
  for (Index i = 0; i < n; ++i) {
    const double leverage = a.row(i).dot(inverse * a.row(i).transpose());
    sum += std::pow(residual(i) / std::max(1e-9, 1.0 - leverage), 2);
  }
  fit.left_out = std::sqrt(sum / static_cast<double>(n));
  return true;
}

std::vector<SobolIndices> sobol_indices(const PolynomialFit& fit, Index axes, int draws, std::uint64_t seed) {
  const Vector errors = fit.covariance.diagonal();
  const Variances fitted = variances(fit.terms, fit.beta, errors, axes);
  const auto n = static_cast<std::size_t>(axes);
  std::vector<std::vector<double>> first(n), total(n);
  Draws drawn(fit, seed);
  for (int k = 0; k < draws; ++k) {
    // The drawn ones err about the fitted ones as those about the true ones: the variance counts twice.
    const Variances v = variances(fit.terms, drawn.next(), 2.0 * errors, axes);
    for (std::size_t i = 0; i < n; ++i) {
      first[i].push_back(share(v.first[i], v.all));
      total[i].push_back(share(v.total[i], v.all));
    }
  }
  std::vector<SobolIndices> indices;
  for (std::size_t i = 0; i < n; ++i)
    indices.push_back({with_interval(share(fitted.first[i], fitted.all), std::move(first[i])),
                       with_interval(share(fitted.total[i], fitted.all), std::move(total[i]))});
  return indices;
}

}  // namespace icebow
