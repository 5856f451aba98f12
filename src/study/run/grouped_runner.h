// Several groups of ranks in one MPI job, each with a design of its own: rank 0 drives and owns the store,
// the ranks after it are the groups.
#pragma once

#include <memory>

#include "study/run/runner.h"

namespace icebow {

// How many groups a job makes: 0 where all ranks evaluate each design together, as they do unless the study
// or --jobs asks for two designs at once or more. Each has execution.ranks_per_design ranks. Throws
// InputError where the job is too small for one group besides rank 0. The same on every rank.
int groups_of(const Communicator& comm, const Execution& execution, const RunSettings& settings);

// Collective: the group of this rank, rank 0 and what is left over being groups of their own.
Communicator split_into_groups(const Communicator& comm, int groups, int ranks_of_group);

// On rank 0.
std::unique_ptr<Runner> make_grouped_runner(const Communicator& comm, int groups,
                                            const RunnerContext& context);
void end_groups(const Communicator& comm, const StudyOutcome& outcome);
void fail_groups(const Communicator& comm, const std::exception& error);

// On every other rank: evaluates what its group is given, until rank 0 ends the study. Ranks that are left
// over wait.
StudyOutcome serve_group(const Communicator& comm, const Communicator& group, int groups, int ranks_of_group,
                         const EvaluateFunction& evaluate);

}  // namespace icebow
