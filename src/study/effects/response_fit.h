// How the load answers to the parameters: a polynomial of low degree fitted to the designs of a ranking.
#pragma once

#include <string>
#include <vector>

#include "study/effects/polynomial_fit.h"
#include "study/plan/ranking.h"

namespace icebow {

struct Effect {
  std::string pointer;
  double lower = 0.0, upper = 0.0;  // of the parameter among the designs, in the file's unit
  // Load at the upper end less that at the lower one, the other parameters in the middle, with the half width
  // of its 95 % interval [unit of the ranked value].
  double change = 0.0, ci95 = 0.0;
  bool told() const { return change > ci95 || -change > ci95; }  // from none
  SobolIndices sobol;                                            // where the fit has them
  // The fitted response along the parameter, the others in the middle.
  std::vector<double> at, value, half_width;
  std::vector<double>
      moved;  // of each design used: its value, moved along the fit to the middle of the others
};

struct ResponseFit {
  int designs = 0;  // used; 0: no fit
  std::string why;  // no fit, in words
  FitTerms terms = FitTerms::linear;
  double left_out_error = 0.0;  // root mean square error of designs left out once, over the mean
  double spread = 0.0;          // standard deviation of the designs' values over the mean
  double noise = 0.0;           // root mean square standard error of the values over the mean; NaN: not known
  double explained = 0.0;       // of the variance of values left out, at most 1
  bool has_sobol = false;       // the fit explains enough for shares of the variance
  std::vector<Effect> effects;  // largest change first
  std::vector<std::string> names;  // of the designs used, as `moved`
  bool told() const { return designs > 0; }
};

// By least squares over the ranked designs and the parameters that differ among them, each over the range
// that the designs have of it. Of the kinds of terms the one whose left-out error is smallest. No fit where
// there are fewer than three designs more than coefficients, where parameters do not vary independently, or
// where the fit errs as much as the mean does. Sobol' indices where it explains half of the variance of
// values left out.
// `held` is a parameter that follows from the others (study/spec/spec_hold.h): it is no axis; empty: none.
ResponseFit fit_response(const Ranking& ranking, const std::string& held = "");

// "of second degree with products of two parameters"
std::string terms_in_words(FitTerms terms);

}  // namespace icebow
