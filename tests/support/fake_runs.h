// Studies of the formula of fake_study.h, and what a user sees of them.
#pragma once

#include <string>

#include "base/communicator.h"
#include "base/json.h"
#include "study/plan/ranking.h"
#include "study/store/store.h"
#include "tests/support/fake_study.h"

namespace icebow {

inline constexpr const char* grid_3_by_2 = R"({"method": {"type": "grid",
  "variables": {"/bow/stem_deg": {"values": [20, 30, 40]}, "/bow/waterline_deg": {"values": [28, 34]}}}})";
inline constexpr const char* optimisation =
    R"({"method": {"type": "optimise", "algorithm": "sbplx", "max_evaluations": 30,
  "tolerance": 0,
  "variables": {"/bow/stem_deg": {"min": 15, "max": 34}, "/bow/waterline_deg": {"min": 20, "max": 45}}}})";

inline StudyOutcome run(const StudySpec& spec, const RunSettings& settings, StudyObserver& observer) {
  return run_study(Communicator::serial(), spec, settings, observer);
}

inline StudyOutcome run(const StudySpec& spec, const std::string& directory) {
  RecordingObserver observer;
  return run(spec, fake_settings(directory), observer);
}

// What a user sees of a study, without times.
inline Json ranking_of(const std::string& directory) {
  const Store store = Store::open_read_only(directory + "/results.sqlite");
  return to_json(rank_designs(store.all(), store.fact("rank_by")));
}

}  // namespace icebow
