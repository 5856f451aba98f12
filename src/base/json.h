// JSON text to tree with errors a person can act on.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace icebow {

using Json = nlohmann::json;

// Both throw InputError naming the file (and line and column of a syntax error); a key given twice in one
// object is a mistake too, as is a number that does not fit a double.
Json read_json_file(const std::string& path);
Json parse_json(const std::string& text, const std::string& name);

// Writes under a temporary name, then renames: a reader never sees half a file. Throws RuntimeError.
void write_text_file(const std::string& path, const std::string& text);
std::string read_text_file(const std::string& path);  // throws InputError where it cannot be read

}  // namespace icebow
