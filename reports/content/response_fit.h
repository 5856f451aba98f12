// How the load answers to the parameters: a polynomial of low degree fitted to the designs.
#pragma once

#include <string>
#include <vector>

#include "reports/content/study_results.h"

namespace icebow {

struct Effect {
  std::string pointer;
  double lower = 0.0, upper = 0.0;  // of the parameter among the designs, in the file's unit
  // Load at the upper end less that at the lower one, the other parameters in the middle, with the half width
  // of its 95 % interval [unit of the ranked value].
  double change = 0.0, ci95 = 0.0;
  // The fitted response along the parameter, the others in the middle.
  std::vector<double> at, value, half_width;
  std::vector<double>
      moved;  // of each design used: its value, moved along the fit to the middle of the others
};

struct ResponseFit {
  int designs = 0;                 // used; 0: no fit
  bool quadratic = false;          // squares too; else the parameters alone
  double left_out_error = 0.0;     // root mean square error of designs left out once, over the mean
  double spread = 0.0;             // standard deviation of the designs' values over the mean
  std::vector<Effect> effects;     // largest change first
  std::vector<std::string> names;  // of the designs used, as `moved`
  bool told() const { return designs > 0; }
};

// By least squares over the ranked designs and the parameters that differ among them. Of both degrees the one
// whose left-out error is smaller. Nothing where there are fewer than three designs more than coefficients,
// where parameters do not vary independently, or where the fit errs as much as the mean does.
ResponseFit fit_response(const StudyResults& study);

}  // namespace icebow
