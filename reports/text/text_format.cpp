#include "reports/text/text_format.h"

#include <array>
#include <cctype>
#include <charconv>
#include <cmath>

#include "base/text.h"

namespace icebow {
namespace {

const char* const en_dash = "\u2013";
const char* const minus_sign = "\u2212";
const char* const narrow_space = "\u202f";

}  // namespace

std::string html_escaped(const std::string& text) {
  std::string out;
  for (const char c : text) {
    switch (c) {
      case '&':
        out += "&amp;";
        break;
      case '<':
        out += "&lt;";
        break;
      case '>':
        out += "&gt;";
        break;
      case '"':
        out += "&quot;";
        break;
      case '\'':
        out += "&#39;";
        break;
      default:
        out += c;
    }
  }
  return out;
}

std::string markdown_escaped(const std::string& text) {
  std::string out;
  for (const char c : text) {
    if (c == '\n' || c == '\r') {
      out += ' ';
    } else {
      if (c == '|' || c == '\\' || c == '*' || c == '_' || c == '`' || c == '<') out += '\\';
      out += c;
    }
  }
  return out;
}

std::string csv_number(double value) {
  if (!std::isfinite(value)) return "";
  char text[40];
  const auto end = std::to_chars(text, text + sizeof text, value);
  return std::string(text, end.ptr);
}

std::string fixed(double value, int decimals) {
  if (!std::isfinite(value)) return en_dash;
  const std::string digits = text("%.*f", decimals, std::abs(value));
  const bool is_zero = digits.find_first_not_of("0.") == std::string::npos;
  return value < 0.0 && !is_zero ? minus_sign + digits : digits;
}

std::string engineering(double value, const std::string& unit) {
  if (!std::isfinite(value)) return en_dash;
  static const std::array<std::pair<double, const char*>, 4> prefixes = {
      {{1e9, "G"}, {1e6, "M"}, {1e3, "k"}, {1.0, ""}}};
  const double size = std::abs(value);
  for (const auto& [factor, prefix] : prefixes) {
    if (unit.empty() || (size < factor && factor > 1.0)) continue;
    const double scaled = value / factor;
    const double s = std::abs(scaled);
    return fixed(scaled, s >= 99.95 ? 0 : s >= 9.995 ? 1 : 2) + "\u00a0" + prefix + unit;
  }
  return text("%.*g", 3, value);
}

std::string with_thousands(long long value) {
  std::string digits = std::to_string(std::abs(value));
  for (int i = static_cast<int>(digits.size()) - 3; i > 0; i -= 3) digits.insert(i, narrow_space);
  return value < 0 ? minus_sign + digits : digits;
}

std::string duration(double seconds) {
  if (!std::isfinite(seconds)) return en_dash;
  if (seconds < 60.0) return fixed(seconds, seconds < 10.0 ? 1 : 0) + "\u00a0s";
  const long long minutes = std::llround(seconds / 60.0);
  if (minutes < 60) return std::to_string(minutes) + "\u00a0min";
  return std::to_string(minutes / 60) + "\u00a0h " + std::to_string(minutes % 60) + "\u00a0min";
}

std::string json_for_script(const Json& json) {
  const std::string text = json.dump(-1, ' ', false, Json::error_handler_t::replace);
  std::string out;
  out.reserve(text.size());
  for (const char c : text) {  // '<' occurs inside JSON strings only
    if (c == '<') {
      out += "\\u003c";
    } else {
      out += c;
    }
  }
  return out;
}

std::string base64(const std::string& bytes) {
  static const char* const alphabet = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string out;
  out.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const std::size_t n = std::min<std::size_t>(3, bytes.size() - i);
    unsigned group = 0;
    for (std::size_t k = 0; k < 3; ++k)
      group = group << 8 | (k < n ? static_cast<unsigned char>(bytes[i + k]) : 0u);
    for (std::size_t k = 0; k < 4; ++k) out += k <= n ? alphabet[group >> (18 - 6 * k) & 63] : '=';
  }
  return out;
}

std::string capitalised(std::string words) {
  if (!words.empty()) words[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(words[0])));
  return words;
}

std::string listed(const std::vector<std::string>& names, std::size_t most) {
  const std::size_t shown = names.size() <= most ? names.size() : most - 1;
  std::string out;
  for (std::size_t i = 0; i < shown; ++i) {
    if (i > 0) out += i + 1 == names.size() ? " and " : ", ";
    out += names[i];
  }
  if (shown < names.size()) out += " and " + std::to_string(names.size() - shown) + " more";
  return out;
}

}  // namespace icebow
