#include "study/run/run_study.h"

#include <filesystem>

#include "base/text.h"
#include "study/run/grouped_runner.h"
#include "study/run/runner.h"
#include "study/run/study_directory.h"
#include "study/run/study_loop.h"
#include "study/spec/case_hull.h"

namespace icebow {
namespace {

// A week's study does not end because somebody looks into its store: it waits, and says so.
Store::Waiting patience(const RunSettings& settings, StudyObserver& observer) {
  constexpr double first = 2.0, then = 60.0;  //!< [s]
  return [&settings, &observer, next = first](double seconds) mutable {
    if (seconds < first) next = first;
    if (seconds >= next) {
      observer.on_waiting(
          text("another program holds results.sqlite locked: waiting for it, %.0f s so far", seconds));
      next += then;
    }
    return !(settings.stop && settings.stop());
  };
}

// Empty settings mean the real thing.
RunSettings completed(RunSettings settings) {
  if (!settings.evaluate) settings.evaluate = evaluate;
  if (!settings.margins) settings.margins = [](const Case& c) { return check_feasibility(c).margins; };
  if (settings.program.empty()) settings.program = std::filesystem::read_symlink("/proc/self/exe").string();
  if (settings.launcher == Launcher::automatic) {
    settings.launcher = MpiSession::started_by_mpirun() ? Launcher::embedded : Launcher::isolated;
  }
  return settings;
}

// How the ranks of a job work: one design after the other, all together (0), or so many at once, in groups.
StudyOutcome run_on_root(const Communicator& comm, int groups, const StudySpec& spec,
                         const RunSettings& settings, StudyObserver& observer) {
  StudyDirectory directory = open_study_directory(spec, settings, patience(settings, observer));
  const RunnerContext context{
      directory.spec, settings,
      [&](const std::string& design, const Progress& progress) { observer.on_progress(design, progress); }};
  const auto runner = settings.launcher == Launcher::isolated ? make_isolated_runner(context)
                      : groups > 0                            ? make_grouped_runner(comm, groups, context)
                                                              : make_embedded_runner(comm, context);
  return StudyLoop(directory.spec, settings, directory.store, *runner, observer).run(directory.notes);
}

}  // namespace

StudyOutcome run_study(const Communicator& comm, const StudySpec& spec, const RunSettings& given,
                       StudyObserver& observer) {
  const RunSettings settings = completed(given);
  const int groups = groups_of(comm, spec.execution, settings), ranks = spec.execution.ranks_per_design;
  const Communicator group = groups > 0 ? split_into_groups(comm, groups, ranks) : comm;
  if (!comm.is_root())
    return groups > 0 ? serve_group(comm, group, groups, ranks, settings.evaluate)
                      : serve_embedded(comm, settings.evaluate);
  try {
    StudyOutcome outcome = run_on_root(comm, groups, spec, settings, observer);
    groups > 0 ? end_groups(comm, outcome) : end_embedded(comm, outcome);
    return outcome;
  } catch (const std::exception& error) {
    groups > 0 ? fail_groups(comm, error) : fail_embedded(comm, error);
    throw;
  }
}

}  // namespace icebow
