// `icebow rank` and `icebow report`.
#include <filesystem>
#include <iostream>

#include "cli/commands.h"
#include "cli/ranking_text.h"
#include "reports/html/html_report.h"

namespace icebow {

int run_rank(const Communicator&, const Arguments& arguments) {
  const Ranking ranking = read_ranking(arguments.positional);
  std::cout << (arguments.has("--json") ? to_json(ranking).dump(2) + "\n" : ranking_text(ranking));
  return exit_code::ok;
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
