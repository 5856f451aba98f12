// For the tests written in Python: what the reader says of study files, and the table of keys.
//   spec_probe --keys            the table as JSON
//   spec_probe FILE...           {"FILE": [{"pointer", "message"}, ...], ...}; an empty list = accepted
#include <cstdio>
#include <string>

#include "base/errors.h"
#include "study/spec/read_study.h"
#include "study/spec/spec_keys.h"
#include "study/spec/spec_method.h"
#include "study/spec/study_spec.h"

using namespace icebow;

namespace {

const char* type_of(Quantity quantity) {
  switch (quantity) {
    case Quantity::integer:
      return "integer";
    case Quantity::boolean:
      return "boolean";
    case Quantity::choice:
      return "choice";
    case Quantity::text:
      return "text";
    default:
      return "number";
  }
}

Json key_json(const Key& key) {
  Json spellings = Json::array();
  for (const Unit& unit : units_of(key.quantity)) {
    Json s = {{"key", key.name + std::string(unit.suffix)}, {"unit", unit.symbol}};
    if (is_numeric(key.quantity)) {
      s["lower"] = lower_in(key, unit);
      s["upper"] = upper_in(key, unit);
      s["range"] = range_in_words(key, unit);
    }
    spellings.push_back(s);
  }
  return {{"section", key.section},   {"name", key.name},       {"type", type_of(key.quantity)},
          {"required", key.required}, {"choices", key.choices}, {"default", key.fallback_words},
          {"meaning", key.meaning},   {"spellings", spellings}, {"scaled", section_has_scale(key.section)}};
}

Json table_json() {
  Json keys = Json::array(), names = Json::array(), scaled = Json::array();
  for (const Key& key : study_keys()) keys.push_back(key_json(key));
  for (const Algorithm& a : algorithms()) {
    names.push_back({{"name", a.name},
                     {"meaning", a.meaning},
                     {"takes_constraints", a.takes_constraints},
                     {"random", a.random},
                     {"least_variables", a.least_variables}});
  }
  return {{"keys", keys}, {"algorithms", names}, {"design_sections", design_sections()}};
}

Json mistakes_json(const std::string& file) {
  Json list = Json::array();
  try {
    read_study(file);
  } catch (const InputError& e) {
    for (const Mistake& m : e.mistakes()) list.push_back({{"pointer", m.pointer}, {"message", m.message}});
    if (list.empty()) list.push_back({{"pointer", ""}, {"message", e.what()}});
  }
  return list;
}

}  // namespace

int main(int argc, char** argv) {
  Json out = Json::object();
  if (argc > 1 && std::string(argv[1]) == "--keys") {
    out = table_json();
  } else {
    for (int i = 1; i < argc; ++i) out[argv[i]] = mistakes_json(argv[i]);
  }
  std::puts(out.dump(1).c_str());
}
