#include "study/spec/spec_hints.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <map>

#include "base/text.h"

namespace icebow {
namespace {

constexpr std::size_t longest_word = 100;  // of a design's name; keys and commands are shorter

std::string in_small_letters(std::string word) {
  for (char& c : word) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return word;
}

// What other tools call it, in small letters and with _ between words.
std::string synonym(std::string word) {
  for (char& c : word)
    if (c == ' ' || c == '-') c = '_';
  static const std::map<std::string, std::string> ours = {{"lhs", "latin_hypercube"},
                                                          {"lhc", "latin_hypercube"},
                                                          {"latin", "latin_hypercube"},
                                                          {"random", "latin_hypercube"},
                                                          {"monte_carlo", "latin_hypercube"},
                                                          {"montecarlo", "latin_hypercube"},
                                                          {"factorial", "grid"},
                                                          {"full_factorial", "grid"},
                                                          {"sweep", "grid"},
                                                          {"oat", "one_at_a_time"},
                                                          {"ofat", "one_at_a_time"},
                                                          {"one_factor_at_a_time", "one_at_a_time"},
                                                          {"ccd", "central_composite"},
                                                          {"response_surface", "central_composite"},
                                                          {"bbd", "box_behnken"},
                                                          {"quasi_random", "sobol"},
                                                          {"lp_tau", "sobol"},
                                                          {"elementary_effects", "morris"},
                                                          {"screening", "morris"},
                                                          {"csv", "table"},
                                                          {"optimization", "optimise"},
                                                          {"subplex", "sbplx"},
                                                          {"nelder_mead", "neldermead"},
                                                          {"simplex", "neldermead"},
                                                          {"direct", "direct_l"},
                                                          {"crs", "crs2_lm"},
                                                          {"random_search", "crs2_lm"},
                                                          {"evolution_strategy", "isres"},
                                                          {"cma_es", "isres"},
                                                          {"genetic", "esch"},
                                                          {"ga", "esch"},
                                                          {"evolutionary", "esch"},
                                                          {"differential_evolution", "esch"},
                                                          {"newuoa", "bobyqa"},
                                                          {"ei", "expected_improvement"},
                                                          {"ego", "expected_improvement"},
                                                          {"bo", "expected_improvement"},
                                                          {"bayes", "expected_improvement"},
                                                          {"bayesian", "expected_improvement"},
                                                          {"bayesian_optimization", "expected_improvement"},
                                                          {"bayesian_optimisation", "expected_improvement"},
                                                          {"gp", "expected_improvement"},
                                                          {"gaussian_process", "expected_improvement"},
                                                          {"kriging", "expected_improvement"},
                                                          {"formula", "lindqvist"},
                                                          {"simulation", "peridynamics"},
                                                          {"pd", "peridynamics"}};
  const auto found = ours.find(word);
  return found == ours.end() ? "" : found->second;
}

}  // namespace

int edit_distance(const std::string& a, const std::string& b) {
  // Optimal string alignment: three rows of the usual table.
  const int n = static_cast<int>(b.size());
  std::vector<int> before(n + 1), previous(n + 1), row(n + 1);
  for (int j = 0; j <= n; ++j) previous[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    row[0] = static_cast<int>(i);
    for (int j = 1; j <= n; ++j) {
      const int change = a[i - 1] == b[j - 1] ? 0 : 1;
      row[j] = std::min({previous[j] + 1, row[j - 1] + 1, previous[j - 1] + change});
      const bool swapped = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
      if (swapped) row[j] = std::min(row[j], before[j - 2] + 1);
    }
    before = previous;
    previous = row;
  }
  return previous[n];
}

std::string nearest(const std::string& given, const std::vector<std::string>& known) {
  const std::string word = in_small_letters(given), same = synonym(word);
  if (std::find(known.begin(), known.end(), same) != known.end()) return same;
  std::string best;
  int best_distance = 0;
  if (word.size() > longest_word) return best;  // no slip of the hand
  for (const std::string& spelling : known) {
    const std::string candidate = in_small_letters(spelling);
    // A word contained in the other (beam for beam_m) is near however long the rest is.
    const bool contained =
        word.size() > 2 && (candidate.rfind(word, 0) == 0 || word.rfind(candidate, 0) == 0);
    const int limit = 1 + static_cast<int>(std::max(word.size(), candidate.size())) / 3;
    const int longer = std::abs(static_cast<int>(word.size()) - static_cast<int>(candidate.size()));
    if (!contained && longer > limit) continue;
    const int distance = contained ? 1 : edit_distance(word, candidate);
    if (distance <= limit && (best.empty() || distance < best_distance)) {
      best = spelling;
      best_distance = distance;
    }
  }
  return best;
}

std::string did_you_mean(const std::string& word, const std::vector<std::string>& known) {
  const std::string near = nearest(word, known);
  return near.empty() ? "" : " (did you mean \"" + near + "\"?)";
}

std::string number_meant(const std::string& text) {
  std::string number = text;
  std::replace(number.begin(), number.end(), ',', '.');
  char* end = nullptr;
  const double value = std::strtod(number.c_str(), &end);
  const bool plain = number.find_first_not_of("+-.0123456789eE") == std::string::npos;
  const bool whole =
      plain && number.size() < 40 && *end == '\0' && end != number.c_str() && std::isfinite(value);
  if (!whole) return "";
  // JSON asks for a digit on both sides of the point and has no plus.
  if (number[0] == '+') number.erase(0, 1);
  const std::size_t sign = number[0] == '-' ? 1 : 0;
  if (number[sign] == '.') number.insert(sign, "0");
  const std::size_t point = number.find('.');
  if (point != std::string::npos && (point + 1 == number.size() || !std::isdigit(number[point + 1])))
    number.insert(point + 1, "0");
  return " (write " + number + ")";
}

std::string number_meant_by(const Json& value) {
  return value.is_string() ? number_meant(value.get<std::string>()) : "";
}

std::string brief(double value) {
  return text("%.6g", value);
}

std::string listed(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : ", ") + word;
  return text;
}

}  // namespace icebow
