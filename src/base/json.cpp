#include "base/json.h"

#include <algorithm>
#include <cctype>
#include <set>

#include "base/errors.h"
#include "base/printable.h"
#include "base/text_encoding.h"

namespace icebow {
namespace {

struct Place {
  std::size_t line = 1, column = 1;
};

Place place_of(const std::string& text, std::size_t position) {
  Place place;
  for (std::size_t i = 0; i < position && i < text.size(); ++i) {
    const bool newline = text[i] == '\n';
    place.line += newline;
    place.column = newline ? 1 : place.column + 1;
  }
  return place;
}

std::string to_string(const Place& place) {
  return "line " + std::to_string(place.line) + ", column " + std::to_string(place.column);
}

// nlohmann calls back without a position, so the characters are counted as they are taken.
class CountingIterator {
 public:
  using iterator_category = std::input_iterator_tag;
  using value_type = char;
  using difference_type = std::ptrdiff_t;
  using pointer = const char*;
  using reference = const char&;

  CountingIterator(const char* at, std::size_t* taken) : at_(at), taken_(taken) {}
  const char& operator*() const { return *at_; }
  CountingIterator& operator++() {
    ++at_;
    if (taken_) ++*taken_;
    return *this;
  }
  bool operator==(const CountingIterator& other) const { return at_ == other.at_; }
  bool operator!=(const CountingIterator& other) const { return at_ != other.at_; }

 private:
  const char* at_;
  std::size_t* taken_;
};

// "[json.exception.parse_error.101] parse error at line 1, column 2: syntax error ..." -> "syntax error ..."
std::string without_prefix(const std::string& what) {
  const std::size_t bracket = what.find("] ");
  std::string text = bracket == std::string::npos ? what : what.substr(bracket + 2);
  if (text.rfind("parse error at line", 0) == 0) {
    const std::size_t colon = text.find(": ");
    if (colon != std::string::npos) text = text.substr(colon + 2);
  }
  return text;
}

constexpr std::size_t most_mistakes = 100;  // each is looked for from the beginning of the text

// Reads once for what the tree cannot show any more: repeated keys, numbers beyond a double, where the syntax
// breaks.
class Checker : public nlohmann::json_sax<Json> {
 public:
  Checker(const std::string& text, const std::size_t& taken) : text_(text), taken_(taken) {}
  std::vector<Mistake> mistakes;

  bool null() override { return value(); }
  bool boolean(bool) override { return value(); }
  bool number_integer(number_integer_t) override { return value(); }
  bool number_unsigned(number_unsigned_t) override { return value(); }
  bool number_float(number_float_t, const string_t&) override { return value(); }
  bool string(string_t&) override { return value(); }
  bool binary(binary_t&) override { return value(); }
  bool start_object(std::size_t) override { return open(); }
  bool start_array(std::size_t) override { return open(); }
  bool end_object() override { return close(); }
  bool end_array() override { return close(); }

  bool key(string_t& name) override {
    if (!levels_.back().keys.insert(name).second) {
      // `taken_` stands behind the closing quote.
      mistakes.push_back(
          {to_string(place_of(text_, taken_ > 0 ? taken_ - 1 : 0)),
           "key \"" + shortened(name, 80) + "\" is given twice in one object; keep one of them"});
    }
    return mistakes.size() < most_mistakes;
  }

  bool parse_error(std::size_t position, const std::string& token,
                   const nlohmann::detail::exception& error) override {
    const std::size_t at = position > 0 ? position - 1 : 0;
    const bool overflow = dynamic_cast<const Json::out_of_range*>(&error) != nullptr;
    mistakes.push_back(
        {to_string(place_of(text_, at)),
         overflow ? "number " + shortened(token, 80) + " does not fit a double (largest about 1.8e308)"
                  : shortened(without_prefix(error.what()), 300) + decimal_comma(at)});
    return false;
  }

 private:
  // Where the text breaks behind a comma between digits, a number was probably written with it.
  std::string decimal_comma(std::size_t at) const {
    const auto digit = [&](std::size_t k) {
      return k < text_.size() && std::isdigit(static_cast<unsigned char>(text_[k]));
    };
    std::size_t comma = std::min(at, text_.size());
    while (comma > 0 && text_[comma - 1] != ',' && text_[comma - 1] != '\n') --comma;
    if (comma-- < 2 || text_[comma] != ',' || !digit(comma - 1) || !digit(comma + 1)) return "";
    std::size_t begin = comma, end = comma + 1;
    while (begin > 0 && digit(begin - 1)) --begin;
    while (digit(end)) ++end;
    return "; a decimal point is wanted: " + shortened(text_.substr(begin, comma - begin), 20) + "." +
           shortened(text_.substr(comma + 1, end - comma - 1), 20);
  }

  struct Level {
    std::set<std::string> keys;
  };
  static bool value() { return true; }
  bool open() {
    levels_.emplace_back();
    if (levels_.size() <= most_levels) return true;
    mistakes.push_back({to_string(place_of(text_, taken_ > 0 ? taken_ - 1 : 0)),
                        "objects and lists stand more than " + std::to_string(most_levels) +
                            " deep in each other here; no file of icebow needs so many"});
    return false;
  }
  bool close() {
    levels_.pop_back();
    return true;
  }

  const std::string& text_;
  const std::size_t& taken_;
  std::vector<Level> levels_;
};

}  // namespace

Json parse_json(const std::string& text, const std::string& name) {
  const std::string no_text = why_no_text(text);
  if (!no_text.empty()) throw InputError(name, {{"the file", no_text}});
  std::size_t taken = 0;
  Checker checker(text, taken);
  const char* begin = text.data();
  Json::sax_parse(CountingIterator(begin, &taken), CountingIterator(begin + text.size(), nullptr), &checker);
  if (!checker.mistakes.empty()) throw InputError(name, std::move(checker.mistakes));
  return Json::parse(text);
}

Json json_or_null(const std::string& text) {
  try {
    return parse_json(text, "");
  } catch (const InputError&) {
    return nullptr;
  }
}

Json read_json_file(const std::string& path) {
  return parse_json(read_text_file(path, most_json_bytes), path);
}

}  // namespace icebow
