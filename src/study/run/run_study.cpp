#include "study/run/run_study.h"

#include <filesystem>

#include "base/text.h"
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

StudyOutcome run_on_root(const Communicator& comm, const StudySpec& spec, const RunSettings& settings,
                         StudyObserver& observer) {
  StudyDirectory directory = open_study_directory(spec, settings, patience(settings, observer));
  const RunnerContext context{
      directory.spec, settings,
      [&](const std::string& design, const Progress& progress) { observer.on_progress(design, progress); }};
  const auto runner = settings.launcher == Launcher::isolated ? make_isolated_runner(context)
                                                              : make_embedded_runner(comm, context);
  return StudyLoop(directory.spec, settings, directory.store, *runner, observer).run(directory.notes);
}

}  // namespace

StudyOutcome run_study(const Communicator& comm, const StudySpec& spec, const RunSettings& given,
                       StudyObserver& observer) {
  const RunSettings settings = completed(given);
  if (!comm.is_root()) return serve_embedded(comm, settings.evaluate);
  try {
    StudyOutcome outcome = run_on_root(comm, spec, settings, observer);
    end_embedded(comm, outcome);
    return outcome;
  } catch (const std::exception& error) {
    fail_embedded(comm, error);
    throw;
  }
}

}  // namespace icebow
