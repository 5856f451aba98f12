// `icebow rank` and `icebow report`.
#include <filesystem>
#include <iostream>

#include "cli/commands.h"
#include "cli/ranking_text.h"
#include "reports/html/html_report.h"

namespace icebow {

namespace {

// A ranking without a design that was in it is not the study's.
int said_of_damage(const Ranking& ranking) {
  int code = exit_code::ok;
  for (const RankedDesign& row : ranking.rows) {
    if (row.evaluation.status != EvaluationStatus::damaged) continue;
    std::cerr << "icebow rank: " << row.evaluation.name << " is missing: " << row.evaluation.reason << "\n";
    code = exit_code::some_designs_failed;
  }
  return code;
}

}  // namespace

int run_rank(const Communicator&, const Arguments& arguments) {
  const Ranking ranking = read_ranking(arguments.positional);
  std::cout << (arguments.has("--json") ? json_text(to_json(ranking), 2) + "\n"
                                        : ranking_text(ranking) + order_text(arguments.positional, ranking));
  return said_of_damage(ranking);
}

int run_report(const Communicator&, const Arguments& arguments) {
  const std::filesystem::path directory(arguments.positional);
  const std::string html =
      arguments.has("--out") ? arguments.value("--out") : (directory / "report.html").string();
  write_html_report(directory.string(), html);
  std::cout << html << "\n";
  return exit_code::ok;
}

}  // namespace icebow
