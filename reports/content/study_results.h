// A study directory as the reports see it. Nothing else is read.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "study/plan/ranking.h"

namespace icebow {

struct StudyResults {
  std::string directory;
  std::string name, purpose;
  std::string command, version, host, started;  // of the run; empty where unknown
  std::string state;                            // "running", "interrupted", "finished"; empty where unknown
  Json document;                                // study.json; null where unreadable
  Ranking ranking;
  int ok = 0, infeasible = 0, failed = 0;  // evaluations: each run of a design counts
  int failed_designs = 0;                  // of which no run is ok
  std::vector<std::string> lost_runs;      // that failed where the design is ranked all the same; sentences
  std::vector<std::string> running;        // started, no result yet
  std::vector<std::string> waiting;        // planned, not started
  int proposals = 0;                       // an optimiser may still propose this many
  double wall_seconds = 0.0;               //!< sum over the designs [s]
  std::string seed;                        // empty where the method draws nothing
  std::string file;                        // of the study, as the command named it; empty where unknown
  std::vector<std::string> drifts;         // records of leading designs that drift; sentences
  std::vector<std::string> notes;   // what is known to be wrong with the model the file asks for; sentences
  std::vector<Json> confirmations;  // results of simulations that confirm designs of a sweep
  // All runs that are ok, of designs with several, or with another one than the first.
  std::map<std::string, std::vector<Evaluation>> repeats;
  std::map<std::string, int> order;  // of each design among the evaluations, from 1

  int evaluated() const { return ok + infeasible + failed; }
  bool finished() const { return state.empty() ? running.empty() && waiting.empty() : state == "finished"; }
  int ranked() const;  // rows with a rank; they come first in ranking.rows
};

// Throws InputError where the directory holds no study (no results.sqlite).
StudyResults read_study_results(const std::string& directory);

// [deg]; `angle` is "stem", "waterline", "buttock" or "flare".
double measured_or_requested(const Json& result, const std::string& angle);

}  // namespace icebow
