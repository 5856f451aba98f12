// The evaluator "cycle": voyages of a design through level ice by src/cycle. Full scale.
#pragma once

#include <string>

#include "base/json.h"
#include "cycle/submersion.h"
#include "cycle/voyage.h"
#include "solver/run/simulation.h"
#include "study/spec/study_spec.h"

namespace icebow {

struct CycleOutcome {
  std::string reason;    // why there is no load; empty where there is one
  double mean = 0.0;     //!< of the voyages' mean loads, with submersion [N]
  double series = 0.0;   //!< half width of its 95 % interval, from the records [N]
  double voyages = 0.0;  //!< the same from the scatter of the voyages, Student's t; infinite for one [N]
  double ci95 = 0.0;     //!< the first; the larger of both from four voyages on, or where they scatter beyond
                         //!< their records [N]
  // Parts of the mean, that add up to it [N].
  double crushing = 0.0, bending = 0.0, friction = 0.0, submersion = 0.0, water = 0.0;
  double breaking_length = 0.0;  //!< mean of the pieces' radii [m]
  double contact_width = 0.0;    //!< mean of the pieces' contacts along the edge [m]
  double channel_width = 0.0;    //!< [m]
  int pieces = 0;
  double seconds = 0.0;              // of computing
  cycle::Submersion under_hull;      // zero where it is left out or by the formula
  cycle::VoyageResult first_voyage;  // with shapes, for a picture
  RunResult
      run;  // metrics, history and process as a simulation's, at full scale; the record is the first voyage's
};

cycle::Ice cycle_ice(const Case& c);
cycle::Voyage cycle_voyage(const Case& c);

// `rule` is the case's, with its table where it is calibrated. Never throws for a case or hull that makes no
// voyage.
CycleOutcome run_cycle(const Case& c, const QuadMesh& hull, const cycle::BreakingRule& rule);

// The cycle's load over the way that a simulation of the same case counts, from the first touch of the ice
// on: of it the bow may enter the ice, and ice may lie under a part of the hull alone.
struct SameWay {
  double from = 0.0, to = 0.0;    //!< of the ship's advance [m]
  double mean = 0.0, ci95 = 0.0;  //!< of voyages with seeds of their own, Student's t [N]
};

// The case's run_cycle() has a load, of it `under_hull` [N] below a hull that is wholly in the ice.
SameWay run_same_way(const Case& c, const QuadMesh& hull, const cycle::BreakingRule& rule, double under_hull);
Json same_way_json(const SameWay& way);

// "metrics" as those of a simulation, at full scale.
Json cycle_metrics_json(const CycleOutcome& outcome);

// The key "cycle" of result.json: docs/study_file.md, "Results".
Json cycle_json(const CycleOutcome& outcome, const Case& c, const cycle::BreakingRule& rule);

}  // namespace icebow
