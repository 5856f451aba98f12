// JSON text to tree with errors a person can act on.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "base/text_file.h"

namespace icebow {

using Json = nlohmann::json;

// Levels of objects and lists within each other that are read: ours have seven. Deeper ones are made to
// exhaust a program's stack.
constexpr std::size_t most_levels = 64;
constexpr std::uint64_t most_json_bytes = std::uint64_t{1} << 28;

// Both throw InputError naming the file (and line and column of a syntax error); a key given twice in one
// object is a mistake too, as are a number that does not fit a double and more than `most_levels`.
// All JSON from outside this process is read by them.
Json read_json_file(const std::string& path);
Json parse_json(const std::string& text, const std::string& name);
// Likewise, but null where the text is no JSON: for what can be done without.
Json json_or_null(const std::string& text);

}  // namespace icebow
