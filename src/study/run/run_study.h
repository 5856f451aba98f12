// One study: for each proposed design, take the stored evaluation of its key, or evaluate and store.
//
// Layout of a study directory: study.json (copy of the document), results.sqlite (the store), designs/<name>/
// with the files of evaluate() and, where the design ran in a process of its own, design.json and log.txt.
// Rules of resuming, launching and optimising: docs/study_engine.md.
#pragma once

#include <string>
#include <vector>

#include "base/communicator.h"
#include "study/evaluate/evaluation.h"
#include "study/plan/design_space.h"
#include "study/plan/race_record.h"
#include "study/run/run_settings.h"
#include "study/spec/study_spec.h"

namespace icebow {

// What happens, as it happens. Called on the root rank only, from the thread of run_study.
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

// Collective; every rank returns the same outcome. Throws RuntimeError (store locked, disk full) and
// InputError (a design that cannot be made from the study file), on every rank.
StudyOutcome run_study(const Communicator& comm, const StudySpec& spec, const RunSettings& settings,
                       StudyObserver& observer);

}  // namespace icebow
