// A study file, read and checked. Everything here is SI, radians and full scale.
#pragma once

#include <cstdint>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "base/json.h"
#include "cycle/cycle_input.h"
#include "hullgen/bow/bow.h"
#include "solver/model/scenario.h"
#include "solver/model/snapshot_format.h"
#include "study/spec/own_hull.h"

namespace icebow {

enum class IceModel { paper, calibrated };  // docs/study_file.md, "Ice by its tests"

// Of the evaluator "cycle", full scale: docs/cycle.md.
struct CycleSettings {
  cycle::BreakingRule rule;        // its table is found by patch tests
  double crushing_pressure = 0.0;  //!< [Pa]
  double voyage = 200.0;           //!< counted length of each [m]
  int voyages = 3;                 // with different seeds
  std::uint64_t seed = 1;
  double scatter = 0.3;     // of the pieces' radii
  double step = 0.04;       // over the thickness
  double raster = 1.0 / 7;  // over the thickness
  bool symmetric = false;
  bool submersion = true;
  bool submersion_by_hull = true;  // else by Lindqvist's formula
};

struct Case;

// One of the conditions that a design is judged over.
struct CaseScenario {
  std::string name;
  double weight = 1.0;
  std::shared_ptr<const Case> given;  // the same ship; without scenarios of its own
};

// One fully described ship in one ice: what an evaluation needs, and nothing else.
struct Case {
  double lambda = 1.0;  // full scale / simulated scale
  BowParameters bow;    // of a hull of the user's own: its dimensions and angles
  OwnHull own;
  IceMaterial ice;
  IceModel ice_model = IceModel::paper;  // calibrated: ice.E is to be measured, ice.s0 and ice.K_I are 0
  double flexural_strength = 0.0;        //!< for the formulas, and to be measured [Pa]
  double compressive_strength = 0.0;     //!< to be measured [Pa]; 0 = not given
  Water water;
  Sheet sheet;
  Numerics numerics;
  double V = 0.0;                     //!< [m/s]
  double advance = 0.0;               //!< [m]
  double steady_from = 0.0;           //!< [m]
  double stop_when_ci95_below = 0.0;  // relative half width that ends a run early; 0 = none does
  std::uint64_t seed = 0;             // of the ice's start; 0 = at rest
  int snapshots = 0, pictures = 0;
  SnapshotFormat snapshot_format = SnapshotFormat::vtp;
  CycleSettings cycle;
  std::vector<CaseScenario> scenarios;  // empty: judged in the ice and at the speed above
  bool by_worst = false;                // by the worst of them, instead of the weighted mean
};

// A program of the user's own that evaluates: study/evaluate/program_evaluator.h.
struct ProgramEvaluator {
  std::string name;                  // its results are /programs/NAME/...
  std::vector<std::string> command;  // the program and its words; files by their whole path
  double time_limit = 600.0;         //!< [s]
};

// Who evaluates a design.
struct Evaluators {
  bool lindqvist = true, peridynamics = true, cycle = false;
  std::vector<ProgramEvaluator> programs = {};
  bool hydrostatics = false;  // a constraint or an objective asks for them, so there must be a mesh

  bool formula_alone() const {
    return lindqvist && !peridynamics && !cycle && programs.empty() && !hydrostatics;
  }
};

enum class MethodType {
  list,
  grid,
  one_at_a_time,
  latin_hypercube,
  sobol,
  halton,
  morris,
  central_composite,
  box_behnken,
  table,
  optimise
};

// One parameter a method may change: a JSON pointer into the study file and its range, in the file's unit.
struct Variable {
  std::string pointer;  // "/bow/stem_deg"
  double lower = 0.0, upper = 0.0;
  int levels = 0;              // grid, one_at_a_time
  std::vector<double> values;  // instead of a range
  // Of a choice, like the family: its words. `values` are their places then, 0, 1 ...
  std::vector<std::string> words;
};

// A cheaper response that is part of what the search by expected improvement expects.
enum class Prior { none, lindqvist, cycle };

// Of the algorithm "expected_improvement" (study/learn/learning_search.h).
struct Learning {
  int initial = 0;            // points to begin with; 0 = 2 (variables + 1)
  int batch = 1;              // points proposed at once after that
  double least_gain = 0.001;  // relative, on the best load
  Prior prior = Prior::none;
};

struct Method {
  MethodType type = MethodType::list;
  std::vector<Variable> variables;
  int samples = 0;                  // latin_hypercube, sobol, halton; trajectories of morris
  bool replace_infeasible = false;  // there, but for morris
  std::vector<int> extends;  // latin_hypercube: smaller numbers of samples that it grew from, ascending
  std::vector<std::vector<double>> rows;  // table: a value for each variable
  std::uint64_t seed = 1;
  std::string algorithm;    // optimise: "sbplx", "cobyla", ...
  int max_evaluations = 0;  // optimise
  double tolerance = 0.0;   // optimise: relative, on the parameters
  Learning learning;        // optimise by expected_improvement
};

// A named design: a JSON merge patch (RFC 7386) on the study file.
struct NamedDesign {
  std::string name;
  Json set;
};

// Designs swept by the cycle that the simulation confirms; both 0: none.
struct Confirm {
  int best = 0, spread = 0;
  bool given() const { return best + spread > 0; }
};

// A race (study/plan/race.h): voyages are sailed on until the best is known.
struct Decide {
  double best_within = 0.05;  // of the load of the design that leads
  double confidence = 0.95;
  double budget_core_hours = 0.0;  // 0 = none
  double longest = 0.0;  //!< no voyage beyond it, full scale [m]; 0 = 20 times what is counted first
  bool given = false;
};

struct Execution {
  int ranks_per_design = 1;
  int designs_at_once = 0;    // 0 = cores / ranks_per_design
  double time_limit_s = 0.0;  // per design; 0 = none
  // The study ends once more than this part of its designs have failed; 0 = it does not.
  double stop_at_failure_rate = 0.0;
  std::vector<std::string>
      launcher;  // words before the program; "{ranks}" in one is the number; empty: mpirun
};

// What a number of each result must keep to.
struct ResultConstraint {
  std::string at;  // its pointer in the result
  double lower = -std::numeric_limits<double>::infinity(), upper = std::numeric_limits<double>::infinity();
};

// What a study weighs against what it ranks by: its designs have a Pareto front.
struct SecondObjective {
  std::string by;        // as StudySpec::rank_by, or the pointer of any number of a result; empty: none
  bool largest = false;  // the largest is best; else the smallest
  bool given() const { return !by.empty(); }
};

struct StudySpec {
  std::string file, name, purpose;
  Json document;  // as read: named designs and variables are applied to it
  Case baseline;
  bool use_lindqvist = true, use_cycle = false, use_peridynamics = true;
  std::vector<ProgramEvaluator> programs;
  std::vector<ResultConstraint> constraints;
  Method method;
  std::vector<NamedDesign> designs;
  bool include_baseline = true;
  int repeats = 1;  // simulations of each design, with different seeds
  // "mean_load", "mean_load_per_beam", "cycle_load", "lindqvist_breaking", or a pointer to a load of a
  // result,
  // "/programs/yard/resistance_N"
  std::string rank_by = "mean_load";
  SecondObjective second;
  Confirm confirm;  // use_peridynamics is false then: the sweep is the cycle's
  Decide decide;
  Execution execution;
};

}  // namespace icebow
