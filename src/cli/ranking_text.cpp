#include "cli/ranking_text.h"

#include <cmath>
#include <filesystem>

#include "base/errors.h"
#include "cli/process_text.h"
#include "cli/text_table.h"
#include "study/spec/spec_hints.h"
#include "study/store/store.h"

namespace icebow {
namespace {

std::string kilonewtons(double newtons) {
  return decimals(newtons / 1e3, 1);
}

std::string interval(const RankedDesign& row) {
  if (!std::isfinite(row.mean_load)) return "-";
  const std::string half = std::isfinite(row.mean_load_ci95) ? kilonewtons(row.mean_load_ci95) : "?";
  const std::string runs = row.runs > 1 ? " (" + std::to_string(row.runs) + " runs)" : "";
  return kilonewtons(row.mean_load) + " \u00b1 " + half + runs;
}

std::string tie(const RankedDesign& row) {
  if (row.tied_with_best && row.rank > 1) return "with the best";
  return row.tied_with_next ? "with the next" : "";
}

}  // namespace

Ranking read_ranking(const std::string& directory) {
  const std::string path = (std::filesystem::path(directory) / "results.sqlite").string();
  if (!std::filesystem::exists(path)) {
    throw InputError(directory +
                     ": holds no study (no results.sqlite); name the --out directory of `icebow run`");
  }
  const Store store = Store::open_read_only(path);
  const std::string by = store.fact("rank_by");
  return rank_designs(store.all(), by.empty() ? StudySpec().rank_by : by);
}

std::string ranking_text(const Ranking& ranking) {
  std::vector<std::vector<std::string>> rows = {
      {"design", "rank", "mean load, kN", "Lindqvist breaking, kN", "ratio", "tied"}};
  std::string others;
  for (const RankedDesign& row : ranking.rows) {
    const Evaluation& e = row.evaluation;
    if (row.rank == 0) {
      others += e.name + ": " + to_string(e.status) + (e.reason.empty() ? "" : ": " + e.reason) + "\n";
      continue;
    }
    rows.push_back({e.name, std::to_string(row.rank), interval(row), kilonewtons(row.lindqvist_breaking),
                    decimals(row.ratio, 2), tie(row)});
  }
  std::string text = "ranked by " + ranking.rank_by + ", full scale, \u00b1 95 % interval of the mean\n\n" +
                     text_table(rows);
  const std::string process = process_table(ranking);
  if (!process.empty())
    text += "\nhow the ice broke: cracks by kind; lengths over the thickness h\n\n" + process;
  for (const std::string& warning : ranking.warnings) text += "\nwarning: " + warning + "\n";
  if (!others.empty()) text += "\nnot ranked\n" + others;
  if (std::isfinite(ranking.spearman)) {
    text += "\nrank correlation of mean load and formula: " + brief(ranking.spearman) + " (" +
            std::to_string(ranking.spearman_n) + " designs)\n";
  }
  return text;
}

}  // namespace icebow
