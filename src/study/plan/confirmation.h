// Two fidelities in one study: designs swept by the breaking cycle, a few confirmed by the simulation, and
// the ratio of the two that corrects the rest. docs/cycle.md, "Two fidelities".
#pragma once

#include <limits>
#include <map>
#include <string>
#include <vector>

#include "study/evaluate/evaluation.h"

namespace icebow {

// The simulation of a design that was swept by the cycle is called "NAME@solver".
std::string confirmation_name(const std::string& design);
bool is_confirmation(const std::string& name);
std::string confirmed_design(const std::string& name);  // "d007" of "d007@solver"

// One design as both see it; loads are full scale [N], intervals half widths of 95 %.
struct Fidelities {
  std::string design;
  std::map<std::string, double> parameters;
  double cycle = 0.0, cycle_ci95 = 0.0;
  double solver = std::numeric_limits<double>::quiet_NaN(), solver_ci95 = solver;  // where it was simulated
  // By the cycle over the way that the simulation counted, which `solver` is compared with; NaN: `cycle` is.
  double beside = std::numeric_limits<double>::quiet_NaN(), beside_ci95 = beside;
};

// Which designs are simulated: the `best` of lowest load, and of the others `spread` far from all chosen in
// the variables, the one called "baseline" first. Names, in that order.
std::vector<std::string> designs_to_confirm(const std::vector<Fidelities>& ranked, int best, int spread);

// solver / cycle = exp(constant + slope (x - middle)), one variable at most, by least squares over the
// designs that both have.
struct RatioFit {
  int designs = 0;       // that both have
  std::string variable;  // empty: a constant
  double constant = 0.0, slope = 0.0, middle = 0.0;
  double constant_error = 0.0, slope_error = 0.0;  // standard errors
  double between = 0.0;  // standard deviation of ln(ratio) between designs, beyond their intervals
  double students_t = std::numeric_limits<double>::infinity();
  // Root mean square error of ln(ratio), each design left out once: of a constant, and of what was taken.
  double error_of_constant = std::numeric_limits<double>::quiet_NaN(), error = error_of_constant;

  double ratio(const std::map<std::string, double>& parameters) const;
  // Half width of the 95 % interval of ln(ratio) of a design; of its difference to others, without the error
  // of the constant, which is the same for all.
  double half_width(const std::map<std::string, double>& parameters) const;
  double half_width_of_difference(const std::map<std::string, double>& parameters) const;
};
RatioFit fit_ratio(const std::vector<Fidelities>& designs);

// In words: the ratio, and which designs the two put apart by more than their intervals once it is applied.
std::vector<std::string> disagreements(const RatioFit& fit, const std::vector<Fidelities>& designs);

}  // namespace icebow
