// The study, and the design of it, that a command was asked to work on.
#pragma once

#include "cli/line/arguments.h"
#include "study/plan/design_space.h"
#include "study/spec/study_spec.h"

namespace icebow {

// The study file, or the one that a study directory was run with, with every --set applied. Throws InputError
// with all mistakes.
StudySpec load_study(const Arguments& arguments);
// The same, collective: the root reads the file, every rank gets the study or the error.
StudySpec load_study(const Communicator& comm, const Arguments& arguments);

struct ChosenDesign {
  Design design;
  Case description;  // of the design's document
};
// The design --design names (a name, or a number from 1 in the study's plan; of a study directory also a
// design that an optimiser has proposed), the file's own where it is not given. --set has the last word over
// the design's own values. Throws InputError.
ChosenDesign choose_design(const StudySpec& spec, const Arguments& arguments);
// The same, collective: the root looks, every rank gets the design or the error.
ChosenDesign choose_design(const Communicator& comm, const StudySpec& spec, const Arguments& arguments);

// The chosen design as a study of its own, whose baseline it is, in another directory; collective. Throws
// InputError.
StudySpec study_of_one(const Communicator& comm, const StudySpec& spec, const Arguments& arguments);

}  // namespace icebow
