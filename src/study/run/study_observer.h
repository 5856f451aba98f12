// Who is told what happens in a study, as it happens.
#pragma once

#include <string>

#include "study/evaluate/evaluation.h"
#include "study/plan/design_space.h"
#include "study/plan/race_record.h"
#include "study/run/run_settings.h"

namespace icebow {

// Called on the root rank only, from the thread of run_study.
class StudyObserver {
 public:
  virtual ~StudyObserver() = default;
  virtual void on_planned(const StudyPlan& /*plan*/) {}
  virtual void on_started(const Design& /*design*/) {}
  virtual void on_progress(const std::string& /*design*/, const Progress& /*progress*/) {}
  virtual void on_finished(const Evaluation& /*evaluation*/, bool /*recalled*/) {}
  // Another program holds the store: what is said every now and then.
  virtual void on_waiting(const std::string& /*words*/) {}
  virtual void on_leg(const RaceRecord& /*record*/) {}  // of a study that decides, after each leg
  virtual void on_study_finished(const StudyOutcome& /*outcome*/) {}
};

}  // namespace icebow
