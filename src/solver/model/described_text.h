// The visitor that makes text of a description (describe_scenario.h): one line a value, the options last.
#pragma once

#include <map>
#include <string>
#include <type_traits>

namespace icebow {

// `Spelling` has spelled(value) for a double, an int and a bool, and the members `equals` and
// `with_following`: whether what follows from other fields is written.
template <class Spelling>
class DescribedText {
 public:
  template <class T>
  void field(const char* name, const T& value, double /*exponent*/ = 0.0) {
    text_ += line(name, value);
  }
  template <class T>
  void option(int number, const char* name, const T& value, const T& usual, double /*exponent*/ = 0.0) {
    if (value != usual) options_[number] = line(name, value);
  }
  template <class T>
  void follows(const char* name, const T& value, double exponent = 0.0) {
    if (Spelling::with_following) field(name, value, exponent);
  }
  template <class T>
  void ignored(const char* /*name*/, const T& /*value*/) {}

  std::string str() const {
    std::string text = text_;
    for (const auto& [number, option] : options_) text += option;
    return text;
  }

 private:
  template <class T>
  static std::string line(const char* name, const T& value) {
    if constexpr (std::is_enum_v<T>) {
      return line(name, static_cast<int>(value));
    } else {
      return std::string(name) + Spelling::equals + Spelling::spelled(value) + "\n";
    }
  }

  std::string text_;
  std::map<int, std::string> options_;
};

}  // namespace icebow
