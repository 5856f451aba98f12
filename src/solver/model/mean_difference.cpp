#include "solver/model/mean_difference.h"

#include <boost/math/distributions/students_t.hpp>
#include <cmath>
#include <limits>

namespace icebow {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

double quantile_975(double degrees_of_freedom) {
  return boost::math::quantile(boost::math::students_t(degrees_of_freedom), 0.975);
}

double quantile_above(double degrees_of_freedom, double level) {
  return boost::math::quantile(boost::math::complement(boost::math::students_t(degrees_of_freedom), level));
}

// Of a sum of two squared errors; an exact one has no part in it.
double joint_degrees_of_freedom(const MeanEstimate& a, const MeanEstimate& b) {
  const double va = a.standard_error * a.standard_error, vb = b.standard_error * b.standard_error;
  const double parts = va * va / a.degrees_of_freedom + vb * vb / b.degrees_of_freedom;
  return parts > 0.0 ? (va + vb) * (va + vb) / parts : infinite;
}

}  // namespace

MeanEstimate mean_estimate(double mean, double ci95, double samples) {
  if (ci95 == 0.0) return {mean, 0.0, infinite};
  if (!std::isfinite(ci95) || !(samples >= 2.0)) return {mean, infinite, 1.0};
  const double freedom = samples - 1.0;
  return {mean, ci95 / quantile_975(freedom), freedom};
}

MeanDifference mean_difference(const MeanEstimate& a, const MeanEstimate& b) {
  MeanDifference result;
  result.difference = b.mean - a.mean;
  const double error = std::hypot(a.standard_error, b.standard_error);
  if (!std::isfinite(error)) {
    result.ci95 = infinite;
    return result;
  }
  if (error == 0.0) {
    result.p = result.difference == 0.0 ? 1.0 : 0.0;
    return result;
  }
  const boost::math::students_t t(joint_degrees_of_freedom(a, b));
  result.ci95 = boost::math::quantile(t, 0.975) * error;
  result.p = 2.0 * boost::math::cdf(boost::math::complement(t, std::fabs(result.difference) / error));
  return result;
}

double most_difference(const MeanEstimate& a, const MeanEstimate& b, double level) {
  const double error = std::hypot(a.standard_error, b.standard_error), difference = b.mean - a.mean;
  if (!std::isfinite(error)) return infinite;
  if (error == 0.0) return difference;
  return difference + quantile_above(joint_degrees_of_freedom(a, b), level) * error;
}

}  // namespace icebow
