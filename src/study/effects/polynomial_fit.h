// A polynomial of low degree fitted to values in a box, and what it says of each axis. Knows nothing of
// ships.
#pragma once

#include <Eigen/Dense>
#include <cstdint>
#include <vector>

namespace icebow {

// Which terms a fit has besides the constant: the axes themselves, their squares, products of two axes,
// cubes.
enum class FitTerms { linear, squares, products, cubes };

// The powers of one term are Legendre polynomials, orthonormal over -1 ... 1 with even weight, so that the
// squares of the coefficients are shares of the variance (Sudret 2008: a polynomial chaos).
struct Term {
  Eigen::Index first = -1, second = -1;  // axes; -1: none
  int degree = 0;                        // in the first one; a product is of degree 1 in both
  bool has(Eigen::Index axis) const { return first == axis || second == axis; }
};

struct PolynomialFit {
  FitTerms kind = FitTerms::linear;
  std::vector<Term> terms;
  Eigen::VectorXd beta;
  Eigen::MatrixXd covariance;  // of beta
  double freedom = 0.0;        // designs less terms
  double left_out = 0.0;       // root mean square error of values left out once

  double at(const Eigen::RowVectorXd& x) const;
  Eigen::VectorXd row(const Eigen::RowVectorXd& x) const;       // the terms there
  double half_width(const Eigen::VectorXd& combination) const;  // of its 95 % interval, Student's t
};

// By least squares over the rows of `x`, each -1 ... 1. False where there are fewer than three values more
// than terms, or where axes do not vary independently.
bool fit_polynomial(const Eigen::MatrixXd& x, const Eigen::VectorXd& y, FitTerms kind, PolynomialFit& fit);

struct Share {
  double value = 0.0, low = 0.0, high = 0.0;  // of the variance, with its 95 % interval
};
struct SobolIndices {
  Share first, total;  // by the axis alone; with its products
};

// Sobol' indices of each axis, of the fitted polynomial over the whole box. Squares of coefficients that err
// are too large by their variance, which is taken off. The intervals come from `draws` of the coefficients
// with their covariance; the same seed gives the same.
std::vector<SobolIndices> sobol_indices(const PolynomialFit& fit, Eigen::Index axes, int draws = 4000,
                                        std::uint64_t seed = 1);

}  // namespace icebow
