// Runs of one design that differ in the seed alone: what they are called, and what they say together.
#pragma once

#include <string>
#include <vector>

#include "base/json.h"

namespace icebow {

// The first run of a design has the design's name, the others "NAME#2", "NAME#3" ...
struct RunName {
  std::string design;
  int number = 1;
};
RunName run_name(const std::string& name);
std::string repeat_name(const std::string& design, int number);

// The first run's document with the seed of another: so many further on.
Json repeat_document(Json document, int number);

struct RepeatedMean {
  int runs = 0;          // that have a mean
  double mean = 0.0;     // of the means
  double series = 0.0;   // half width of its 95 % interval, from the runs' own; NaN where one has none
  double repeats = 0.0;  // the same from the scatter of the runs' means, Student's t; NaN for one run
};
// `ci95` are half widths of the means' intervals.
RepeatedMean repeated_mean(const std::vector<double>& means, const std::vector<double>& ci95);

}  // namespace icebow
