// A study directory with made-up results, laid out as `icebow run` leaves one: for tests and for work on the
// report.
#pragma once

#include <string>

namespace icebow {

struct SampleStudy {
  int picture_width = 40;  // px
  int history_rows = 400;
  bool peridynamics = true;  // false: the formula alone
  bool lindqvist = true;
  bool pareto = false;   // a second objective: displacement, the largest best
  bool finished = true;  // false: one design is running, the last ones have not started
  std::string odd_name = "odd <b>&\"'<script>";  // of one design: no study file may say so, a store might
};

// Ten ranked designs, two infeasible ones and a failed one. Throws RuntimeError.
void write_sample_study(const std::string& directory, const SampleStudy& options = {});

}  // namespace icebow
