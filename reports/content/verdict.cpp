#include "reports/content/verdict.h"

#include <algorithm>
#include <cctype>
#include <cmath>

#include "reports/content/load_unit.h"
#include "reports/text/text_format.h"

namespace icebow {
namespace {

std::string counted(std::size_t n, const std::string& noun) {
  return std::to_string(n) + ' ' + noun + (n == 1 ? "" : "s");
}

// "0.81 ± 0.06 MN", with the decimals the interval can bear.
std::string value_in_words(const RankedDesign& row, const Ranking& ranking) {
  const LoadUnit unit = load_unit(ranking);
  const bool per_beam = ranking.rank_by == "mean_load_per_beam";
  const double newtons = per_beam ? 1e3 : unit.newtons;
  const double ci = value_ci95(row, ranking.rank_by) / newtons;
  const int decimals = decimals_for_interval(ci, per_beam || unit.name == "kN" ? 1 : 2, 3);
  return with_interval(row.value / newtons, ci, decimals) + "\u00a0" + (per_beam ? "kN/m" : unit.name);
}

std::string tie_clause(const Ranking& ranking, int ranked) {
  std::vector<std::string> tied;
  for (int i = 1; i < ranked; ++i)
    if (ranking.rows[i].tied_with_best) tied.push_back(ranking.rows[i].evaluation.name);
  if (!tied.empty()) return "; " + listed(tied, 5) + " cannot be told apart from it.";
  if (ranked == 1) return ".";
  if (!std::isfinite(value_ci95(ranking.rows[0], ranking.rank_by))) return ".";
  return "; its interval overlaps that of no other design.";
}

std::string sentence(std::string words) {
  words[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(words[0])));
  return words + '.';
}

std::string headline(const StudyResults& study, int ranked) {
  if (ranked > 0) {
    const RankedDesign& best = study.ranking.rows.front();
    return best.evaluation.name + " has the lowest " + ranked_quantity(study.ranking.rank_by) + ", " +
           value_in_words(best, study.ranking) + tie_clause(study.ranking, ranked);
  }
  if (study.evaluated() == 0) return "No design has been evaluated yet.";
  if (study.ok == 0) return "No design could be ranked: each was infeasible or failed.";
  return "No design could be ranked: no result holds the " + ranked_quantity(study.ranking.rank_by) + '.';
}

void add_baseline_remark(const StudyResults& study, int ranked, std::vector<std::string>& remarks) {
  const auto begin = study.ranking.rows.begin(), end = begin + ranked;
  const auto row =
      std::find_if(begin, end, [](const RankedDesign& r) { return r.evaluation.name == "baseline"; });
  if (row == end || row == begin || row->tied_with_best) return;
  const double gain = 1.0 - begin->value / row->value;
  remarks.push_back("That is " + fixed(100.0 * gain, 0) + "\u00a0% below the baseline (" +
                    value_in_words(*row, study.ranking) + ").");
}

void add_lindqvist_remark(const Ranking& ranking, std::vector<std::string>& remarks) {
  if (!std::isfinite(ranking.spearman) || ranking.spearman_n < 4) return;
  const double rho = ranking.spearman;
  const char* order = rho >= 0.8   ? "much the same order"
                      : rho >= 0.4 ? "a partly similar order"
                      : rho > -0.4 ? "an order that has little to do with it"
                                   : "more nearly the opposite order";
  remarks.push_back("Lindqvist's formula puts the designs in " + std::string(order) +
                    " (Spearman's rank correlation " + fixed(rho, 2) + " over " +
                    std::to_string(ranking.spearman_n) + " designs).");
}

std::string unfinished(const StudyResults& study) {
  std::vector<std::string> parts;
  if (!study.running.empty())
    parts.push_back(counted(study.running.size(), "design") + " started without a result");
  if (!study.waiting.empty()) parts.push_back(counted(study.waiting.size(), "design") + " not started");
  if (study.proposals > 0)
    parts.push_back("up to " + std::to_string(study.proposals) + " more from the optimiser");
  const std::string missing = parts.empty() ? "" : ": " + listed(parts, 3);
  return (study.state == "interrupted" ? "The study was interrupted" : "The study is not finished") +
         missing + ". The ranking may change.";
}

void add_missing_remark(const StudyResults& study, std::vector<std::string>& remarks) {
  if (study.infeasible + study.failed > 0) {
    std::vector<std::string> parts;
    if (study.infeasible > 0) parts.push_back(counted(study.infeasible, "design") + " infeasible");
    if (study.failed > 0) parts.push_back(counted(study.failed, "design") + " failed");
    remarks.push_back("Not ranked: " + listed(parts, 2) + ", each with its reason below.");
  }
  if (!study.finished()) remarks.push_back(unfinished(study));
}

}  // namespace

Verdict verdict(const StudyResults& study) {
  const int ranked = study.ranked();
  Verdict result;
  for (const std::string& words : study.ranking.disagreements) result.headline += sentence(words) + " ";
  result.headline += headline(study, ranked);
  add_baseline_remark(study, ranked, result.remarks);
  if (study.ranking.rank_by != "lindqvist_breaking") add_lindqvist_remark(study.ranking, result.remarks);
  for (const std::string& warning : study.ranking.warnings) result.remarks.push_back(sentence(warning));
  add_missing_remark(study, result.remarks);
  return result;
}

}  // namespace icebow
