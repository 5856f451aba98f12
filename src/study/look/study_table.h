// All designs of a study directory with all their numbers, for other programs.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "base/json.h"

namespace icebow {

// A list of {"design", "status", "reason", "rank" (0: not ranked), "parameters", "result"}, in the order of
// the study; with two objectives "front" as well (study/plan/pareto.h; empty: no place). Throws InputError
// where the directory holds no study.
Json study_table(const std::string& directory);

// The same by columns, each as long as there are designs.
struct StudyColumns {
  std::map<std::string, std::vector<std::string>>
      texts;  // "design", "status", "reason"; "front" with two objectives
  std::vector<int> ranks;
  // By pointer: of variables that are words; of parameters; of each number of a result that is in no list
  // (but for those of its scenarios). What a design lacks is empty or NaN.
  std::map<std::string, std::vector<std::string>> choices;
  std::map<std::string, std::vector<double>> parameters, results;
};
StudyColumns study_columns(const Json& table);

// As CSV (RFC 4180): choices by their pointers behind "choice:", parameters by their pointers, results by
// their pointers behind "result:". What a design lacks is empty.
std::string study_csv(const Json& table);

// As an HDF5 file: lists "design", "status", "reason", "rank", and "front" with two objectives; below
// "choices", "parameters" and "results" a list at each pointer, like "results/lindqvist/total_N". Replaces
// what is there. Throws RuntimeError where the file cannot be written, InputError where a pointer is a number
// in one design and has parts in another.
void write_study_hdf5(const Json& table, const std::string& path);

}  // namespace icebow
