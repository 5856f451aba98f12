// A Gaussian process through noisy values: what it expects at a point, and how sure it is.
//
// n values y_i were observed at points x_i of the unit cube [Rasmussen2006, Santner2018]:
//   y_i = b(x_i)' beta + Z(x_i) + e_i,   e_i ~ N(0, v_i + g)                                  (1)
//   cov(Z(x), Z(x')) = s^2 k(r),   r^2 = sum_k ((x_k - x'_k) / l_k)^2                          (2)
//   k(r) = (1 + sqrt(5) r + 5 r^2 / 3) exp(-sqrt(5) r)              Matern, 5/2                (3)
// v_i is the noise that is known, g the rest, which is fitted. b is (1), or (1, p(x)) where a cheaper
// response p is known everywhere: beta then scales it [Kennedy2000]. With K = s^2 (k_ij) + diag(v_i + g), c =
// cov(Z(x), y):
//   beta = (B' K^-1 B)^-1 B' K^-1 y                                                            (4)
//   m(x) = b' beta + c' K^-1 (y - B beta)                                                      (5)
//   S(x)^2 = s^2 - c' K^-1 c + u' (B' K^-1 B)^-1 u,   u = b - B' K^-1 c                         (6)
//   -2 ln L = ln |K| + ln |B' K^-1 B| + (y - B beta)' K^-1 (y - B beta)    restricted likelihood (7)
// Each value predicted from all others, with Q = K^-1 - K^-1 B (B' K^-1 B)^-1 B' K^-1 [Dubrule1983]:
//   y_i - m_(i)(x_i) = (Q y)_i / Q_ii,   its variance 1 / Q_ii                                  (8)
#pragma once

#include <Eigen/Dense>
#include <memory>
#include <vector>

namespace icebow {

struct Observations {
  Eigen::MatrixXd points;     // n x d, in the unit cube
  Eigen::VectorXd values;     // n, finite
  Eigen::VectorXd variances;  // n, v of (1); 0 where nothing is known of the noise
  Eigen::VectorXd prior;      // n values p(x_i), or empty: b is (1)
  bool exact = false;         // g of (1) is nothing: what is not known of the noise is not there

  Eigen::Index count() const { return values.size(); }
};

// m and S of (5) and (6): of the response, without the noise of one observation.
struct Predictions {
  Eigen::VectorXd mean, sd;
};

class GaussianProcess {
 public:
  // Of given parameters: ln l_1 ... ln l_d, ln s^2 and, unless exact, ln g; s^2 and g over the variance of
  // the values. Two observations or more.
  GaussianProcess(std::shared_ptr<const Observations> observations, const std::vector<double>& parameters);

  bool usable() const { return usable_; }  // K could be factorised
  double log_likelihood() const;           // (7), of values scaled to a variance of one
  // `prior` has p at the points, or is empty like that of the observations.
  Predictions at(const Eigen::MatrixXd& points, const Eigen::VectorXd& prior) const;
  double noise_variance() const;  // of one more observation: g and the median of v_i, in the values' unit
  // beta of p, in units of the values over those of p; NaN without p.
  double prior_factor() const;

  struct LeftOut {
    double log_density = 0.0;  // sum of the predictive log densities of (8), of values scaled
    double rms_error = 0.0;    // root mean square of (8), in the values' unit
  };
  LeftOut left_out() const;

  const std::vector<double>& parameters() const { return parameters_; }
  const Observations& observations() const { return *observations_; }

  // The same parameters with one more observation, the expected value at `point`: Ginsbourger's "kriging
  // believer" [Ginsbourger2010], by which points of a batch keep apart.
  GaussianProcess believing(const Eigen::RowVectorXd& point, double prior) const;

 private:
  Eigen::MatrixXd covariances(const Eigen::MatrixXd& points) const;  // of Z there and at the observations
  Eigen::MatrixXd basis(Eigen::Index rows, const Eigen::VectorXd& prior) const;
  void factorise();

  std::shared_ptr<const Observations> observations_;
  std::vector<double> parameters_;
  double centre_ = 0.0, unit_ = 1.0;                   // of the values
  double prior_centre_ = 0.0, prior_unit_ = 1.0;       // of p
  double signal_ = 1.0, nugget_ = 0.0;                 // s^2 and g over unit_^2
  Eigen::VectorXd lengths_;                            // 1 / l_k
  Eigen::MatrixXd scaled_;                             // points / l
  Eigen::LLT<Eigen::MatrixXd> factor_;                 // of K
  Eigen::MatrixXd basis_, solved_basis_;               // B, L^-1 B
  Eigen::LLT<Eigen::MatrixXd> basis_factor_;           // of B' K^-1 B
  Eigen::VectorXd beta_, residual_, solved_residual_;  // y - B beta, L^-1 of it
  bool usable_ = false;
};

// The parameters of the largest likelihood (7) times a weak prior: ln l ~ N(ln(0.5 sqrt(d)), 1) keeps lengths
// from running to nothing or beyond all bounds where few points tell, ln s^2 ~ N(0, 2^2) and ln g ~ N(ln
// 1e-3, 2^2) likewise. Searched by NLopt's BOBYQA from three lengths, or from a middle one and the parameters
// of an earlier fit. Deterministic. Without `prior` where the values left out (8) are predicted as well
// without.
GaussianProcess fit_process(const Observations& observations, const std::vector<double>& earlier = {});

}  // namespace icebow
