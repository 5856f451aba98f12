#include "reports/content/history_file.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <sstream>

namespace icebow {
namespace {

std::vector<std::string> split(const std::string& line) {
  std::vector<std::string> fields;
  std::istringstream stream(line);
  for (std::string field; std::getline(stream, field, ',');) {
    field.erase(std::remove_if(field.begin(), field.end(), [](char c) { return c == '\r' || c == ' '; }),
                field.end());
    fields.push_back(field);
  }
  return fields;
}

std::size_t column(const std::vector<std::string>& names, const std::string& name) {
  return static_cast<std::size_t>(std::find(names.begin(), names.end(), name) - names.begin());
}

double value(const std::vector<std::string>& fields, std::size_t i) {
  if (i >= fields.size() || fields[i].empty()) return std::nan("");
  char* end = nullptr;
  const double v = std::strtod(fields[i].c_str(), &end);
  return *end == '\0' ? v : std::nan("");
}

}  // namespace

LoadSeries read_load_series(const std::string& csv_path, double length_factor, double force_factor) {
  LoadSeries series;
  std::ifstream file(csv_path);
  std::string line;
  while (std::getline(file, line) && !line.empty() && line[0] == '#') {
  }
  const std::vector<std::string> names = split(line);
  const std::size_t advance = column(names, "advance_m"), load = column(names, "Fx_N");
  if (advance == names.size() || load == names.size()) return series;
  while (std::getline(file, line)) {
    const std::vector<std::string> fields = split(line);
    const double x = value(fields, advance), F = value(fields, load);
    if (!std::isfinite(x) || !std::isfinite(F)) continue;
    series.advance.push_back(x * length_factor);
    series.load.push_back(-F * force_factor);
  }
  series.samples = series.advance.size();
  return series;
}

LoadSeries thinned(const LoadSeries& series, std::size_t most) {
  const std::size_t n = series.load.size();
  if (n <= most || most < 2) return series;
  const std::size_t bins = most / 2;
  LoadSeries out;
  out.samples = series.samples;
  for (std::size_t bin = 0; bin < bins; ++bin) {
    const auto begin = series.load.begin() + static_cast<std::ptrdiff_t>(bin * n / bins);
    const auto end = series.load.begin() + static_cast<std::ptrdiff_t>((bin + 1) * n / bins);
    const auto [lowest, highest] = std::minmax_element(begin, end);
    for (const auto at : {std::min(lowest, highest), std::max(lowest, highest)}) {
      out.advance.push_back(series.advance[static_cast<std::size_t>(at - series.load.begin())]);
      out.load.push_back(*at);
    }
  }
  return out;
}

}  // namespace icebow
