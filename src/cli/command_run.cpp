#include <algorithm>
#include <filesystem>
#include <iostream>

#include "base/error_words.h"
#include "base/errors.h"
#include "base/stop_signal.h"
#include "cli/commands.h"
#include "cli/progress.h"
#include "cli/ranking_text.h"
#include "cli/study_choice.h"
#include "reports/html/html_report.h"
#include "reports/tables/table_report.h"
#include "study/run/run_study.h"

namespace icebow {
namespace {

int jobs(const Arguments& arguments) {
  if (!arguments.has("--jobs")) return 0;
  const std::string text = arguments.value("--jobs");
  const bool digits =
      !text.empty() && text.size() < 5 && text.find_first_not_of("0123456789") == std::string::npos;
  if (!digits || std::stoi(text) < 1)
    throw InputError("--jobs " + text + ": must be a whole number, allowed 1 to 9999");
  return std::stoi(text);
}

RunSettings settings_for(const Arguments& arguments) {
  RunSettings settings;
  settings.directory = arguments.value("--out");
  settings.command = arguments.command_line;
  settings.jobs = jobs(arguments);
  settings.retry_failed = arguments.has("--retry-failed");
  settings.stop = StopSignal::raised;
  settings.checkpoint_now = StopSignal::checkpoint_asked;
  return settings;
}

// The results are safe by now: what cannot be drawn is an error, but not one that hides the ranking.
int write_reports(const std::string& directory) {
  try {
    write_table_reports(directory);
    write_html_report(directory, (std::filesystem::path(directory) / "report.html").string());
    return exit_code::ok;
  } catch (const std::exception& error) {
    std::cerr << "icebow run: no report: " << in_words(error) << "\n";
    return exit_code::failure;
  }
}

// Designs that were evaluated but lack the number that the study ranks by.
int without_rank(const Ranking& ranking) {
  return static_cast<int>(
      std::count_if(ranking.rows.begin(), ranking.rows.end(), [](const RankedDesign& row) {
        return row.rank == 0 && row.evaluation.status == EvaluationStatus::ok;
      }));
}

int code_of(const StudyOutcome& outcome, int unranked, int reports) {
  if (reports != exit_code::ok) return reports;
  if (outcome.nothing_feasible) return exit_code::nothing_feasible;
  return outcome.failed + unranked > 0 ? exit_code::some_designs_failed : exit_code::ok;
}

std::string words_on_failures(const StudyOutcome& outcome) {
  std::string words;
  if (outcome.nothing_feasible)
    words +=
        "nothing is feasible of what was tried within the ranges of the study's variables: the ranking has "
        "no "
        "design of the method. `icebow check` looks for bounds that are feasible\n";
  if (outcome.failed > 0)
    words += std::to_string(outcome.failed) +
             " failed for the reasons above; the same command with --retry-failed evaluates them again\n";
  return words;
}

int conclude(const StudyOutcome& outcome, const Arguments& arguments) {
  const std::string directory = arguments.value("--out");
  for (const std::string& note : outcome.notes) std::cerr << "note: " << note << "\n";
  const int reports = write_reports(directory);
  if (outcome.interrupted) {
    std::cerr << "interrupted; the same command goes on from here:\n  " << arguments.command_line << "\n";
    return exit_code::interrupted;
  }
  const Ranking ranking = read_ranking(directory);
  std::cout << (arguments.has("--json") ? json_text(to_json(ranking), 2) + "\n"
                                        : ranking_text(ranking) + order_text(directory, ranking));
  std::cerr << outcome.ok << " ok, " << outcome.infeasible << " infeasible, " << outcome.failed << " failed";
  if (outcome.recalled > 0) std::cerr << ", " << outcome.recalled << " of them stored before";
  std::cerr << "; " << (std::filesystem::path(directory) / "report.html").string() << "\n"
            << words_on_failures(outcome);
  const int unranked = without_rank(ranking);
  if (unranked > 0)
    std::cerr << unranked << " of the designs that are ok have no " << ranking.rank_by << " to rank by\n";
  return code_of(outcome, unranked, reports);
}

}  // namespace

int run_run(const Communicator& comm, const Arguments& arguments) {
  StudySpec spec = load_study(comm, arguments);
  if (arguments.has("--design")) spec = study_of_one(comm, spec, arguments);
  const RunSettings settings = settings_for(arguments);
  const StopSignal signals;
  StudyOutcome outcome;
  {
    ProgressDisplay display;
    outcome = run_study(comm, spec, settings, display);
  }
  return comm.is_root() ? conclude(outcome, arguments) : exit_code::ok;
}

}  // namespace icebow
