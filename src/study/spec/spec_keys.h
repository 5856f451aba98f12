// Every key of a study file's sections in one table: it serves the reader, the hints for unknown keys,
// the published schema and the table of docs/study_file.md (studies/schema/generate.py writes both).
#pragma once

#include <string>
#include <vector>

namespace icebow {

enum class Quantity {
  length,
  speed,
  time,
  angle,
  stress,
  toughness,
  density,
  volume,
  number,   // dimensionless
  integer,  // JSON's 3 and 3.0
  boolean,
  choice,
  text
};

// A way to write a quantity: the suffix of the key and the factor to SI. The first unit of a quantity is the
// one the table's ranges and defaults are given in.
struct Unit {
  const char* suffix;  // "_m_s"; "" for a dimensionless quantity
  const char* symbol;  // "m/s", for people
  double to_si;
};
const std::vector<Unit>& units_of(Quantity quantity);
// Froude-Cauchy: full scale = model scale * lambda^exponent.
double scale_exponent(Quantity quantity);

struct Key {
  const char* section;  // "bow"; "" = top level
  const char* name;     // without the unit: "stem"
  Quantity quantity;
  double lower, upper;  // allowed, ends included, as written in the first unit, at whatever scale
  bool required;
  double fallback;  // default in the first unit; NaN: none, or computed (see fallback_words); booleans: 0, 1
  const char* fallback_words;  // for documentation
  const char* meaning;
  std::vector<std::string> choices;
};

const std::vector<Key>& study_keys();
std::vector<const Key*> keys_of_section(const std::string& section);
const Key* find_key(const std::string& section, const std::string& name);
bool is_numeric(Quantity quantity);

// The canonical spelling: "stem_deg".
std::string spelled(const Key& key);
// Key and unit of a spelling ("stem_rad"): both null where the section has no such key.
struct Spelling {
  const Key* key = nullptr;
  const Unit* unit = nullptr;
};
Spelling find_spelling(const std::string& section, const std::string& spelling);
// The same for a JSON pointer into a study file: "/operation/speed_kn".
Spelling find_pointer(const std::string& pointer);
// The allowed range in a unit: "5 to 85 deg".
std::string range_in_words(const Key& key, const Unit& unit);
double lower_in(const Key& key, const Unit& unit);
double upper_in(const Key& key, const Unit& unit);

// Sections that may hold "scale": "full" | "model", and those a design may change.
bool section_has_scale(const std::string& section);
const std::vector<std::string>& design_sections();
// The keys of the top level that are not in the table because they hold objects or lists.
const std::vector<std::string>& structural_keys();

}  // namespace icebow
