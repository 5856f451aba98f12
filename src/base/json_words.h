// Words of JSON: its library's exceptions, and the text in an object.
#pragma once

#include <exception>
#include <map>
#include <string>

#include "base/json_fields.h"

namespace icebow {

// Without the mark in brackets before the words of the library: "[json.exception.out_of_range.403] key 'a'
// not found" is "key 'a' not found".
inline std::string in_words(const std::exception& error) {
  const std::string what = error.what();
  const std::size_t end = what.rfind("[json.exception.", 0) == 0 ? what.find("] ") : std::string::npos;
  return end == std::string::npos ? what : what.substr(end + 2);
}

// The members that are text of the object at `pointer`; none where there is no object.
inline std::map<std::string, std::string> words_at(const Json& json, const std::string& pointer) {
  std::map<std::string, std::string> words;
  const Json& object = part_at(json, pointer);
  if (!object.is_object()) return words;
  for (const auto& [name, word] : object.items())
    if (word.is_string()) words[name] = word.get<std::string>();
  return words;
}

}  // namespace icebow
