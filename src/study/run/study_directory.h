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
  StudySpec spec;                  // as given, and grown from what the directory has: plan/augmentation.h
};

// Makes the directory where it is missing, locks and opens the store, writes study.json and the facts of this
// run. Throws RuntimeError (locked, cannot be written) and InputError (a study.json that no run has put
// there).
//
// `waiting`: see Store::open().
StudyDirectory open_study_directory(const StudySpec& spec, const RunSettings& settings,
                                    Store::Waiting waiting = {});

// How often a design that was under way has crashed the process it shared: its row remembers, and a mark that
// a crash has left since counts once.
struct Crashes {
  int count = 0;
  std::string last;  // the mark's words
};
Crashes crashes_of(const Evaluation& running, const std::string& study_directory);
Json to_json(const Crashes& crashes);  // for the row of a running design

// Makes the parts of a result that repeat the evaluation agree with it, in result.json too. A design without
// files gets none, but a result.json that is there is kept true.
void complete_result(Evaluation& evaluation, const std::string& study_directory, bool has_files);

}  // namespace icebow
