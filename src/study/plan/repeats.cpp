#include "study/plan/repeats.h"

#include <cmath>
#include <cstdlib>
#include <limits>

#include "solver/model/statistics.h"
#include "study/spec/document_keys.h"

namespace icebow {

RunName run_name(const std::string& name) {
  const std::size_t mark = name.find('#');  // no name of a study file holds one
  if (mark == std::string::npos) return {name, 1};
  return {name.substr(0, mark), std::atoi(name.c_str() + mark + 1)};
}

std::string repeat_name(const std::string& design, int number) {
  return number == 1 ? design : design + "#" + std::to_string(number);
}

Json repeat_document(Json document, int number) {
  if (number == 1) return document;
  const Json::json_pointer seed(document_key::solver_seed);
  const bool given = document.contains(seed) && document.at(seed).is_number();
  document[seed] = (given ? document.at(seed).get<double>() : 0.0) + (number - 1);
  return document;
}

RepeatedMean repeated_mean(const std::vector<double>& means, const std::vector<double>& ci95) {
  constexpr double nan_value = std::numeric_limits<double>::quiet_NaN();
  RepeatedMean result{0, nan_value, nan_value, nan_value};
  std::vector<double> finite;
  double sum = 0.0, square = 0.0;
  for (std::size_t n = 0; n < means.size(); ++n) {
    if (!std::isfinite(means[n])) continue;
    finite.push_back(means[n]);
    sum += means[n];
    square += ci95[n] * ci95[n];
  }
  result.runs = static_cast<int>(finite.size());
  if (finite.empty()) return result;
  result.mean = sum / result.runs;
  result.series = std::sqrt(square) / result.runs;
  if (result.runs > 1) result.repeats = interval_of_repeats(finite);
  return result;
}

}  // namespace icebow
