// Whether the ranked values of two designs differ, and whether a study can rank at all.
#pragma once

#include <string>

#include "reports/content/study_results.h"
#include "solver/model/mean_difference.h"

namespace icebow {

// `row` against `other`: the difference is positive where `row` has the higher load.
MeanDifference compared_with(const RankedDesign& row, const RankedDesign& other, const std::string& rank_by);

// Independent samples of the simulated mean, of all runs together; infinite where the value is no mean.
double independent_samples(const StudyResults& study, const RankedDesign& row);

constexpr double fewest_samples = 10.0;

// Why the records are too short for an order, and what would do; `reason` is empty where they are long
// enough.
struct TooShort {
  std::string reason;           // "the interval of d001 is wider than its mean"
  double advance = 0.0;         //!< sailed now, full scale [m]
  double advance_needed = 0.0;  //!< [m]; NaN where no record says
  double seconds_needed = 0.0;  //!< of computing, all designs [s]
};
TooShort too_short(const StudyResults& study);

// "p = 0.02", "p < 0.001".
std::string p_in_words(double p);

}  // namespace icebow
