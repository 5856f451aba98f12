// One study: for each proposed design, take the stored evaluation of its key, or evaluate and store.
//
// Layout of a study directory: study.json (copy of the document), results.sqlite (the store), designs/<name>/
// with the files of evaluate() and, where the design ran in a process of its own, design.json and log.txt.
// Rules of resuming, launching and optimising: docs/study_engine.md.
#pragma once

#include "base/communicator.h"
#include "study/run/run_settings.h"
#include "study/run/study_observer.h"
#include "study/spec/study_spec.h"

namespace icebow {

// Collective; every rank returns the same outcome. Throws RuntimeError (store locked, disk full) and
// InputError (a design that cannot be made from the study file), on every rank.
StudyOutcome run_study(const Communicator& comm, const StudySpec& spec, const RunSettings& settings,
                       StudyObserver& observer);

}  // namespace icebow
