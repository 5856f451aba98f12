// The directory of a study, opened for running it.
#pragma once

#include <string>
#include <vector>

#include "study/run/run_settings.h"
#include "study/store/store.h"

namespace icebow {

struct StudyDirectory {
  Store store;
  std::vector<std::string> notes;  // for the user: the study file has changed since ...
};

// Makes the directory where it is missing, locks and opens the store, writes study.json and the facts of this
// run. Throws RuntimeError (locked, cannot be written) and InputError (a study.json that no run has put
// there).
StudyDirectory open_study_directory(const StudySpec& spec, const RunSettings& settings);

// How often a design was begun in a process that a crash of it would have ended. Kept in the row of a running
// design.
int attempts(const Evaluation& running);

// Makes the parts of a result that repeat the evaluation agree with it, in result.json too.
void complete_result(Evaluation& evaluation, const std::string& study_directory);

}  // namespace icebow
