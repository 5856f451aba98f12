#include "cli/text_table.h"

#include <algorithm>
#include <cmath>

#include "base/text.h"

namespace icebow {
namespace {

bool starts_character(char c) {
  return (c & 0xC0) != 0x80;
}

}  // namespace

int columns(const std::string& text) {
  return static_cast<int>(std::count_if(text.begin(), text.end(), starts_character));
}

std::string cut(const std::string& text, int width) {
  int seen = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (starts_character(text[i]) && seen++ == std::max(0, width)) return text.substr(0, i);
  }
  return text;
}

std::string text_table(const std::vector<std::vector<std::string>>& rows) {
  std::vector<int> widths;
  for (const auto& row : rows) {
    widths.resize(std::max(widths.size(), row.size()));
    for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], columns(row[i]));
  }
  std::string text;
  for (const auto& row : rows) {
    std::string line;
    for (std::size_t i = 0; i < row.size(); ++i) {
      const std::string space(static_cast<std::size_t>(widths[i] - columns(row[i])), ' ');
      line += (i == 0 ? row[i] + space : "  " + space + row[i]);
    }
    text += line.substr(0, line.find_last_not_of(' ') + 1) + "\n";
  }
  return text;
}

std::string clock_time(double seconds) {
  if (!std::isfinite(seconds) || seconds < 0.0 || seconds > 3.6e9) return "--:--";
  const long s = std::lround(seconds);
  if (s < 3600) return text("%ld:%02ld", s / 60, s % 60);
  return text("%ld:%02ld:%02ld", s / 3600, s / 60 % 60, s % 60);
}

std::string decimals(double value, int digits) {
  if (!std::isfinite(value)) return "-";
  if (std::fabs(value) >= 1e12) return text("%.6g", value);
  const std::string printed = text("%.*f", digits, value);
  const bool zero = printed.find_first_of("123456789") == std::string::npos;
  return zero && printed[0] == '-' ? printed.substr(1) : printed;
}

}  // namespace icebow
