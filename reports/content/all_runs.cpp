#include "reports/content/all_runs.h"

#include <algorithm>
#include <cmath>

#include "base/json_fields.h"

namespace icebow {

int runs_of(const StudyResults& study, const Evaluation& design) {
  const auto repeats = study.repeats.find(design.name);
  return repeats == study.repeats.end() ? 1 : static_cast<int>(repeats->second.size());
}

double over_runs(const StudyResults& study, const Evaluation& design, const std::string& pointer,
                 OverRuns how) {
  const auto repeats = study.repeats.find(design.name);
  if (repeats == study.repeats.end()) return number_at(design.result, pointer);
  double sum = 0.0, highest = -INFINITY;
  for (const Evaluation& run : repeats->second) {
    const double value = number_at(run.result, pointer);
    sum += value;
    highest = std::max(highest, value);
  }
  if (std::isnan(sum)) return sum;
  return how == OverRuns::highest ? highest
         : how == OverRuns::sum   ? sum
                                  : sum / static_cast<double>(repeats->second.size());
}

RunCounts run_counts(const StudyResults& study) {
  RunCounts counts;
  for (const RankedDesign& row : study.ranking.rows) {
    if (row.rank == 0) continue;
    counts.fewest = row.rank == 1 ? row.runs : std::min(counts.fewest, row.runs);
    counts.most = std::max(counts.most, row.runs);
  }
  return counts;
}

std::string first_run_in_words(const StudyResults& study, const Evaluation& design) {
  const int runs = runs_of(study, design);
  return runs > 1 ? "the first of " + std::to_string(runs) + " runs" : "";
}

}  // namespace icebow
