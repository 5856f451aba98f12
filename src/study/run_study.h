// One study: for each proposed design, take the stored evaluation of its key, or evaluate and store.
//
// Layout of a study directory: study.json (copy of the document), results.sqlite (the store), designs/<name>/
// with the files of evaluate() and, where the design ran in a process of its own, design.json and log.txt.
// Rules of resuming, launching and optimising: docs/study_engine.md.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "base/communicator.h"
#include "hullgen/bow.h"
#include "study/design_space.h"
#include "study/evaluate.h"
#include "study/evaluation.h"
#include "study/study_spec.h"

namespace icebow {

// Replaced by a fake in tests. Collective like evaluate().
using EvaluateFunction =
    std::function<Evaluation(const Communicator&, const Design&, const EvaluateOptions&)>;
using MarginsFunction = std::function<std::vector<Margin>(const Case&)>;  // of feasibility, see hullgen/bow.h

enum class Launcher {
  automatic,  // embedded where MPI is active, isolated otherwise
  isolated,   // a child process per design: a crash or a hang costs that design only
  embedded    // in this process, all its ranks together
};

struct RunSettings {
  std::string directory;  // of the study; made where missing
  std::string program;    // the icebow program, for children: empty = this very program (/proc/self/exe)
  std::string command;    // as the user typed it; recorded
  Launcher launcher = Launcher::automatic;
  int jobs = 0;  // designs at once (isolated); 0 = as the study says, or cores / ranks per design
  bool retry_failed = false;  // evaluate failed designs again; otherwise a failure is a result like any other
  std::function<bool()> stop;  // asked on the root a few times a second; true = end now, store consistent
  EvaluateFunction evaluate;   // empty = icebow::evaluate (embedded only; a child process has its own)
  MarginsFunction margins;     // empty = those of check_feasibility
};

struct StudyOutcome {
  int ok = 0, infeasible = 0, failed = 0;  // designs of the present study, recalled ones included
  int recalled = 0;                        // of those, how many were taken from the store
  bool interrupted = false;                // settings.stop said so: the same command goes on from here
  std::string best;                // name of the best design by the study's rank_by; empty where none is ok
  std::vector<std::string> notes;  // for the user: duplicates, results kept of an earlier study file ...
};

// What happens, as it happens. Called on the root rank only, from the thread of run_study.
class StudyObserver {
 public:
  virtual ~StudyObserver() = default;
  virtual void on_planned(const StudyPlan& /*plan*/) {}
  virtual void on_started(const Design& /*design*/) {}
  virtual void on_progress(const std::string& /*design*/, const Progress& /*progress*/) {}
  virtual void on_finished(const Evaluation& /*evaluation*/, bool /*recalled*/) {}
  virtual void on_study_finished(const StudyOutcome& /*outcome*/) {}
};

// Collective; every rank returns the same outcome. Throws RuntimeError (store locked, disk full) and
// InputError (a design that cannot be made from the study file), on every rank.
StudyOutcome run_study(const Communicator& comm, const StudySpec& spec, const RunSettings& settings,
                       StudyObserver& observer);

// The hidden command `icebow evaluate-design --design-json FILE --out DIR --result FILE`: what an isolated
// run starts for each design, under mpirun or not. `arguments` are those after the command's name. Progress
// goes to stdout as lines of JSON. Collective; returns the exit code. An empty `evaluator` is
// icebow::evaluate.
int evaluate_design_child(const Communicator& comm, const std::vector<std::string>& arguments,
                          const EvaluateFunction& evaluator = nullptr);

}  // namespace icebow
