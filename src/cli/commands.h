// One function for each command; see commands.cpp for what they take. They return the exit code and throw
// InputError (exit code 2) or RuntimeError (1).
#pragma once

#include "cli/line/arguments.h"

namespace icebow {

namespace exit_code {
constexpr int ok = 0, failure = 1, bad_input = 2, some_designs_failed = 3, nothing_feasible = 3,
              interrupted = 130;
}

// On the root alone.
int run_new(const Communicator& comm, const Arguments& arguments);
int run_check(const Communicator& comm, const Arguments& arguments);
int run_hull(const Communicator& comm, const Arguments& arguments);
int run_measure(const Communicator& comm, const Arguments& arguments);
int run_calibrate(const Communicator& comm, const Arguments& arguments);
int run_resistance(const Communicator& comm, const Arguments& arguments);
int run_cycle_command(const Communicator& comm, const Arguments& arguments);
int run_rank(const Communicator& comm, const Arguments& arguments);
int run_picture(const Communicator& comm, const Arguments& arguments);
int run_report(const Communicator& comm, const Arguments& arguments);
int run_status(const Communicator& comm, const Arguments& arguments);
int run_watch(const Communicator& comm, const Arguments& arguments);
int run_show(const Communicator& comm, const Arguments& arguments);
int run_export(const Communicator& comm, const Arguments& arguments);
int run_effects(const Communicator& comm, const Arguments& arguments);
int run_diff(const Communicator& comm, const Arguments& arguments);
// Collective.
int run_simulate(const Communicator& comm, const Arguments& arguments);
int run_run(const Communicator& comm, const Arguments& arguments);

}  // namespace icebow
