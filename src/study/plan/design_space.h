// From a study file to its designs.
#pragma once

#include <string>
#include <vector>

#include "study/evaluate/evaluation.h"
#include "study/spec/study_spec.h"

namespace icebow {

struct PlannedDesign {
  Design design;
  std::string key;  // see evaluation_key(); of a voyage that may be sailed on the same however far it went
  // The key of the same first leg of the other kind (sailed on, or not), whose result serves as well.
  std::string other_key;
};

// What is known before anything runs. An optimiser proposes the rest as it goes.
struct StudyPlan {
  std::vector<PlannedDesign> designs;  // baseline, named designs, then those of the method, each followed by
                                       // its repeats; no key twice
  std::vector<std::string> notes;      // "d004 is the same as baseline: evaluated once"
  // optimise: how many designs the optimiser may add at most, its start left out where that is the baseline;
  // 0 otherwise
  int proposals = 0;
};

// A point of the method that the reader rejects is planned with its mistake: it becomes a failed design.
StudyPlan plan_study(const StudySpec& spec);

// The study file itself as a design, which the reader has read already.
Design baseline_of(const StudySpec& spec);

// The study's document with its variables at `x` (the file's units), in the order of spec.method.variables.
PlannedDesign design_at(const StudySpec& spec, const std::string& name, const std::vector<double>& x);

// Whether the margins let the design at `x` be built; no mesh is made.
bool is_feasible_point(const StudySpec& spec, const std::vector<double>& x);

// The runs of a design: itself, and its repeats by the study (study/plan/repeats.h).
std::vector<PlannedDesign> runs_of(const StudySpec& spec, const PlannedDesign& design);

// The simulations that confirm a design of the cycle: "NAME@solver", and its repeats by the study.
std::vector<PlannedDesign> confirmations(const StudySpec& spec, const Design& design);

// Notes in the result which words the design has of the study's variables that are choices: {pointer: word}.
void note_choices(const StudySpec& spec, const Design& design, Evaluation& evaluation);

// Where an optimiser starts: the file's own values, the middle of the range where the file leaves a variable
// out.
std::vector<double> start_point(const StudySpec& spec);

// "d001" ...: the name of the n-th design of a method, counted from 1.
std::string numbered_name(int n);

// To ten significant digits: what a person reads in a table is what was run, and a value that went through
// the optimiser's scaling comes back as the number in the study file.
double rounded(double value);

}  // namespace icebow
