// The text in an object of JSON.
#pragma once

#include <map>
#include <string>

#include "base/json_fields.h"
#include "base/printable.h"

namespace icebow {

// The members that are text of the object at `pointer`, fit for a terminal; none where there is no object.
inline std::map<std::string, std::string> words_at(const Json& json, const std::string& pointer) {
  std::map<std::string, std::string> words;
  const Json& object = part_at(json, pointer);
  if (!object.is_object()) return words;
  for (const auto& [name, word] : object.items())
    if (word.is_string()) words[printable(name)] = printable(word.get<std::string>());
  return words;
}

}  // namespace icebow
