// When a run has recorded enough: the mean load's 95 % interval is as narrow as the study asks.
#pragma once

#include "solver/model/history.h"
#include "solver/model/statistics.h"

namespace icebow {

// A rule that looked at every sample would stop at the first one that looks good by chance. So it looks only
// at record lengths of 256, 384, 576, ... steady samples (each half as long again), and asks for 30
// independent samples. On AR(1) series with correlation times of 1 to 200 samples the 95 % interval of the
// record it stops at covers the mean in 87 to 97 % of the cases (docs/verification.md,
// tests/solver/watch/stop_rule_test.cpp).
constexpr int first_look = 256;
constexpr double look_growth = 1.5, fewest_independent = 30.0;

bool is_look(int steady_samples);
// Half width of the interval at most `relative_half_width` of the mean, in a record worth enough samples.
bool narrow_enough(const LoadStatistics& load, double relative_half_width);
// Judges the resistance beyond `steady_from` [m]: false between looks, and always where the width is 0.
// Depends on the record alone, so a run that is taken up again stops at the same sample.
bool enough_recorded(const History& history, double steady_from, double relative_half_width);

}  // namespace icebow
