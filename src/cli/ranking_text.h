// The ranking of a study directory, for people.
#pragma once

#include <string>

#include "study/plan/ranking.h"

namespace icebow {

// Ranks DIR/results.sqlite, which a run may be writing to. Throws InputError where DIR holds no study.
Ranking read_ranking(const std::string& directory);
std::string ranking_text(const Ranking& ranking);

}  // namespace icebow
