// One object of a study file, read against the table of keys: every mistake is noted, nothing throws.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "base/errors.h"
#include "base/json.h"
#include "study/spec/spec_keys.h"

namespace icebow {

using Mistakes = std::vector<Mistake>;

// How a value looks in a message: shortened JSON.
std::string shown(const Json& value);
std::string type_name(const Json& value);  // "a string", "an object"

// Notes keys that no section of this name has where `patch` drops them, by null: the merged section has
// nothing left to find fault with. `at` is the pointer of what the section stands in.
void check_dropped_keys(const std::string& section, const Json& patch, const std::string& at,
                        Mistakes& mistakes);

class Section {
 public:
  // Reads document[name] (name "" = the top level itself). `lambda` converts where the section says "scale":
  // "model". `extra` are keys that are no mistake though the table does not have them.
  Section(const Json& document, const std::string& name, double lambda, Mistakes& mistakes,
          const std::vector<std::string>& extra = {});

  bool has(const std::string& key) const { return entries_.count(key) > 0; }
  // SI, full scale. The default where the key is not given; NaN where there is none, or where the value was
  // wrong.
  double number(const std::string& key) const;
  int integer(const std::string& key) const;  // 0 where wrong: its mistake is noted already
  bool boolean(const std::string& key) const;
  std::string text(const std::string& key, const std::string& fallback) const;
  // Pointer to the key as the file spells it, or as the table does where it is not given.
  std::string pointer(const std::string& key) const;
  // Notes a mistake where a key is missing that another one asks for, or given though another one forbids it:
  // `because` says which, and what to do.
  void require(const std::string& key, const std::string& because);
  void refuse(const std::string& key, const std::string& because);
  // False where any value of the section was wrong or missing.
  bool good() const { return good_; }

 private:
  struct Entry {
    std::string spelling;
    double number;  // SI, full scale; NaN where wrong
    std::string text;
  };
  void read_scale(const Json& object, double lambda);
  void read_entry(const std::string& spelling, const Json& value, const std::vector<std::string>& extra);
  void unknown(const std::string& spelling, const std::vector<std::string>& extra);
  double checked_number(const Spelling& found, const Json& value, const std::string& at);
  std::string checked_text(const Key& key, const Json& value, const std::string& at);
  void require_all();
  bool misspelt(const std::string& key) const;
  void mistake(const std::string& at, const std::string& message);

  std::string name_;
  Mistakes* mistakes_;
  double lambda_ = 1.0;  // of this section: 1 where its values are full scale
  bool good_ = true;
  bool readable_ = false;                 // the section is an object, or absent
  std::map<std::string, Entry> entries_;  // by the table's name
  std::vector<std::string> meant_;        // names an unknown key probably stands for
};

}  // namespace icebow
