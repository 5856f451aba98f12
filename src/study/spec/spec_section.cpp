#include "study/spec/spec_section.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/printable.h"
#include "base/units.h"
#include "study/spec/spec_hints.h"

namespace icebow {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

bool is_whole(double value) {
  return std::floor(value) == value;
}

std::string escaped(const std::string& key) {
  std::string out;
  for (const char c : key) out += c == '~' ? "~0" : c == '/' ? "~1" : std::string(1, c);
  return out;
}

std::vector<std::string> spellings(const std::string& section) {
  std::vector<std::string> words;
  for (const Key* key : keys_of_section(section)) {
    for (const Unit& unit : units_of(key->quantity)) words.push_back(key->name + std::string(unit.suffix));
  }
  return words;
}

// Another way of saying the same, so a file gives one of the two.
const char* const exclusive[][3] = {{"hull", "draft", "waterline_height"},
                                    {"ice", "fracture_toughness", "critical_stretch"},
                                    {"solver", "spacing", "layers"},
                                    {"solver", "time_step", "time_step_fraction"}};

}  // namespace

std::string shown(const Json& value) {
  const std::string text = value.dump(-1, ' ', false, Json::error_handler_t::replace);
  return text.size() > 40 ? shortened(text, 37) : text;
}

std::string type_name(const Json& value) {
  if (value.is_null()) return "null";
  const std::string name = value.type_name();
  return (name == "array" || name == "object" ? "an " : "a ") + name;
}

void check_dropped_keys(const std::string& section, const Json& patch, const std::string& at,
                        Mistakes& mistakes) {
  if (!patch.is_object()) return;
  for (const auto& item : patch.items()) {
    const bool scale = item.key() == "scale" && section_has_scale(section);
    if (!item.value().is_null() || scale || find_spelling(section, item.key()).key) continue;
    std::vector<std::string> known;
    for (const Key* key : keys_of_section(section)) known.push_back(spelled(*key));
    mistakes.push_back({at + "/" + section + "/" + item.key(), "is not a key of \"" + section + "\"" +
                                                                   did_you_mean(item.key(), known) +
                                                                   ": null drops a key that the file gives"});
  }
}

Section::Section(const Json& document, const std::string& name, double lambda, Mistakes& mistakes,
                 const std::vector<std::string>& extra)
    : name_(name), mistakes_(&mistakes) {
  static const Json empty = Json::object();
  const bool given = name.empty() || document.contains(name);
  const Json& object = name.empty() ? document : given ? document.at(name) : empty;
  if (!object.is_object()) {
    mistake("/" + name, "is " + type_name(object) + ", must be an object {\"key\": value, ...}");
    return;
  }
  readable_ = true;
  if (section_has_scale(name)) read_scale(object, lambda);
  for (const auto& [spelling, value] : object.items()) read_entry(spelling, value, extra);
  require_all();
}

void Section::read_scale(const Json& object, double lambda) {
  const auto scale = object.find("scale");
  if (scale == object.end() || *scale == "full") return;
  if (*scale == "model") {
    lambda_ = lambda;
    return;
  }
  mistake("/" + name_ + "/scale",
          "is " + shown(*scale) +
              ", must be \"full\" or \"model\": the scale the values of this section are given at");
}

void Section::read_entry(const std::string& spelling, const Json& value,
                         const std::vector<std::string>& extra) {
  if (spelling == "scale" && section_has_scale(name_)) return;
  if (std::find(extra.begin(), extra.end(), spelling) != extra.end()) return;
  const Spelling found = find_spelling(name_, spelling);
  if (!found.key) return unknown(spelling, extra);
  const std::string at = (name_.empty() ? "" : "/" + name_) + "/" + spelling;
  const auto twice = entries_.find(found.key->name);
  if (twice != entries_.end()) {
    return mistake(at, "gives the same quantity as " + twice->second.spelling + "; keep one of the two");
  }
  Entry entry{spelling, nan, ""};
  const Quantity quantity = found.key->quantity;
  if (is_numeric(quantity)) {
    entry.number = checked_number(found, value, at);
  } else if (quantity != Quantity::boolean) {
    entry.text = checked_text(*found.key, value, at);
  } else if (value.is_boolean()) {
    entry.number = value.get<bool>() ? 1.0 : 0.0;
  } else {
    mistake(at, "is " + shown(value) + ", must be true or false");
  }
  entries_[found.key->name] = entry;
}

void Section::unknown(const std::string& spelling, const std::vector<std::string>& extra) {
  std::vector<std::string> known = spellings(name_);
  known.insert(known.end(), extra.begin(), extra.end());
  if (section_has_scale(name_)) known.push_back("scale");
  std::string message =
      "is not a key of " + (name_.empty() ? std::string("a study file") : "\"" + name_ + "\"");
  const std::string near = nearest(spelling, known);
  if (!near.empty()) {
    message += did_you_mean(spelling, known);
    if (const Key* key = find_spelling(name_, near).key) meant_.push_back(key->name);
  } else {
    std::vector<std::string> names = extra;
    for (const Key* key : keys_of_section(name_)) names.push_back(spelled(*key));
    message += "; it has " + listed(names);
  }
  mistake((name_.empty() ? "/" : "/" + name_ + "/") + escaped(spelling), message);
}

double Section::checked_number(const Spelling& found, const Json& value, const std::string& at) {
  const Key& key = *found.key;
  const std::string range = range_in_words(key, *found.unit);
  if (!value.is_number()) {
    mistake(at, "is " + shown(value) + ", must be a number" + number_meant_by(value) + ", allowed " + range);
    return nan;
  }
  const double number = value.get<double>();
  if (!(number >= lower_in(key, *found.unit) && number <= upper_in(key, *found.unit))) {
    const bool one = key.lower == key.upper;
    mistake(at, "is " + shown(value) + (one ? ", must be " : ", allowed ") + range);
    return nan;
  }
  if (key.quantity == Quantity::integer && !is_whole(number)) {
    mistake(at, "is " + shown(value) + ", must be a whole number, allowed " + range);
    return nan;
  }
  return to_full_scale(number * found.unit->to_si, lambda_, scale_exponent(key.quantity));
}

std::string Section::checked_text(const Key& key, const Json& value, const std::string& at) {
  const bool choice = key.quantity == Quantity::choice;
  if (value.is_string()) {
    const std::string text = value.get<std::string>();
    if (!choice || std::find(key.choices.begin(), key.choices.end(), text) != key.choices.end()) return text;
    mistake(at, "is " + shown(value) + ", must be one of " + listed(key.choices) +
                    did_you_mean(text, key.choices));
  } else {
    mistake(at,
            "is " + shown(value) + ", must be " + (choice ? "one of " + listed(key.choices) : "a string"));
  }
  return "";
}

// A misspelt key is one mistake, not two.
bool Section::misspelt(const std::string& key) const {
  return std::find(meant_.begin(), meant_.end(), key) != meant_.end();
}

void Section::require(const std::string& key, const std::string& because) {
  if (!readable_ || has(key) || misspelt(key)) return;
  mistake(pointer(key), "is missing " + because);
}
void Section::refuse(const std::string& key, const std::string& because) {
  if (has(key)) mistake(pointer(key), because);
}

void Section::require_all() {
  for (const Key* key : keys_of_section(name_)) {
    if (!key->required || has(key->name) || misspelt(key->name)) continue;
    const bool ranged = is_numeric(key->quantity);
    mistake(pointer(key->name),
            std::string("is missing (") + key->meaning + "); add it, allowed " +
                (ranged ? range_in_words(*key, units_of(key->quantity).front()) : listed(key->choices)));
  }
  for (const auto& pair : exclusive) {
    if (name_ != pair[0] || !has(pair[1]) || !has(pair[2])) continue;
    mistake(pointer(pair[2]), "says the same as " + entries_.at(pair[1]).spelling +
                                  "; keep one of the two (a design drops the file's with null)");
  }
}

double Section::number(const std::string& key) const {
  const auto entry = entries_.find(key);
  if (entry != entries_.end()) return entry->second.number;
  const Key* known = find_key(name_, key);
  return known->fallback * units_of(known->quantity).front().to_si;
}

int Section::integer(const std::string& key) const {
  const double value = number(key);
  return std::isnan(value) ? 0 : static_cast<int>(value);
}

bool Section::boolean(const std::string& key) const {
  return number(key) == 1.0;
}

std::string Section::text(const std::string& key, const std::string& fallback) const {
  const auto entry = entries_.find(key);
  return entry == entries_.end() ? fallback : entry->second.text;
}

std::string Section::pointer(const std::string& key) const {
  const auto entry = entries_.find(key);
  const Key* known = find_key(name_, key);
  const std::string spelling = entry != entries_.end() ? entry->second.spelling
                               : known                 ? spelled(*known)
                                                       : key;
  return (name_.empty() ? "" : "/" + name_) + "/" + spelling;
}

void Section::mistake(const std::string& at, const std::string& message) {
  good_ = false;
  mistakes_->push_back({at, message});
}

}  // namespace icebow
