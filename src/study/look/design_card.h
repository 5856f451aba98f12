// One design of a study directory: what it is, what came of it, and which commands take it up again.
#pragma once

#include <string>

#include "base/json.h"

namespace icebow {

// Keys: "design", "status", "reason", "rank" (0: not ranked), "designs" (how many are ranked), "rank_by",
// "value" (what it is ranked by), "parameters", "key", "notes" (sentences), "commands": {"again", "finer"},
// "directory" (of its files; null where it has none), "document" (of the design alone), "result" as in
// result.json; of a ranked design of a study with two objectives "second" {"by", "value"} and "front". Throws
// InputError where the directory has no such design.
Json design_card(const std::string& directory, const std::string& name);

}  // namespace icebow
