// How a study is run: where, by whom, and with what evaluator; and what came of it.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "base/communicator.h"
#include "hullgen/bow/bow.h"
#include "study/evaluate/evaluate.h"
#include "study/evaluate/evaluation.h"
#include "study/spec/study_spec.h"

namespace icebow {

// Replaced by a fake in tests. Collective like evaluate().
using EvaluateFunction =
    std::function<Evaluation(const Communicator&, const Design&, const EvaluateOptions&)>;
using MarginsFunction =
    std::function<std::vector<Margin>(const Case&)>;  // of feasibility, see hullgen/bow/bow.h

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
  // Evaluate failed designs again; otherwise a failure is a result like any other, unless its cause has
  // changed: study/run/failure.h.
  bool retry_failed = false;
  std::function<bool()> stop;  // asked on the root a few times a second; true = end now, store consistent
  std::function<bool()>
      checkpoint_now;         // likewise; true = the simulation under way keeps its state (embedded)
  EvaluateFunction evaluate;  // empty = icebow::evaluate (embedded only; a child process has its own)
  MarginsFunction margins;    // empty = those of check_feasibility
};

struct StudyOutcome {
  int ok = 0, infeasible = 0, failed = 0;  // designs of the present study, recalled ones included
  int recalled = 0;                        // of those, how many were taken from the store
  bool interrupted = false;                // settings.stop said so: the same command goes on from here
  bool nothing_feasible = false;           // of all that was tried within the ranges of the study's variables
  std::string best;                // name of the best design by the study's rank_by; empty where none is ok
  std::vector<std::string> notes;  // for the user: duplicates, results kept of an earlier study file ...
};

}  // namespace icebow
