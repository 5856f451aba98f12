// The search of a study by expected improvement (study/learn/learning_search.h): what its loads, constraints,
// margins and cheaper responses are.
//
// What the directory has of the same ship and conditions, from earlier studies too, is what the search begins
// with. Its choices stand in the store beside the results: a search that was cut short, or is given more
// points, goes on with them as they were.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "study/plan/design_space.h"
#include "study/run/run_settings.h"
#include "study/spec/study_spec.h"
#include "study/store/store.h"

namespace icebow {

// What the search asks of the study's loop. Points are in the file's units.
struct LearningHooks {
  // Evaluates the points side by side, or takes them from the store. The keys of each point's runs.
  std::function<std::vector<std::vector<std::string>>(const std::vector<std::vector<double>>&)> evaluate;
  std::function<std::vector<double>(const std::vector<double>&)> margins;  // of feasibility, 0 or more
  std::function<void()> pause;  // asked now and then: throws where the study is to end
};

// In words what it has come to.
std::vector<std::string> run_learning(const StudySpec& spec, const RunSettings& settings, Store& store,
                                      const LearningHooks& hooks);

}  // namespace icebow
