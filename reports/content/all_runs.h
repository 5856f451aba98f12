// Of repeated runs the report's numbers are of all of them.
#pragma once

#include <string>

#include "reports/content/study_results.h"

namespace icebow {

enum class OverRuns { mean, sum, highest };

// Runs of the design that are ok; 1 where it was not repeated.
int runs_of(const StudyResults& study, const Evaluation& design);

// A number of the design's result over all its runs that are ok, in the result's unit; NaN where a run lacks
// it.
double over_runs(const StudyResults& study, const Evaluation& design, const std::string& pointer,
                 OverRuns how);

// The most and the fewest runs of a ranked design, confirmations by simulation among them.
struct RunCounts {
  int fewest = 1, most = 1;
};
RunCounts run_counts(const StudyResults& study);

// "the first of 3 runs"; empty where there is one.
std::string first_run_in_words(const StudyResults& study, const Evaluation& design);

}  // namespace icebow
