// The ranking of a study directory, for people.
#pragma once

#include <string>

#include "study/plan/ranking.h"

namespace icebow {

// Ranks DIR/results.sqlite, which a run may be writing to. Throws InputError where DIR holds no study.
Ranking read_ranking(const std::string& directory);
std::string ranking_text(const Ranking& ranking);
// What `ranking_text` must not be read without: that the simulated records carry no order, and what would do.
// Empty where they do.
std::string order_text(const std::string& directory, const Ranking& ranking);

}  // namespace icebow
