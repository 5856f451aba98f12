// The parts of result.json that more than one command prints: see docs/study_file.md, "Results". Keys end in
// their unit; a number that is not finite becomes null.
#pragma once

#include "base/json.h"
#include "formula/lindqvist.h"
#include "hullgen/bow/bow.h"
#include "hullgen/hydro/hydrostatics.h"
#include "solver/run/simulation.h"
#include "study/spec/own_hull.h"

namespace icebow {

// {"requested_deg", "measured_deg", "derived_deg", "margins", "margin_sentences", "margins_only_reported",
// "feasible", "reason", "mesh"}; the caller adds "design". Angles in degrees, lengths in metres at the scale
// of `bow`. Where there is no mesh, "measured_deg", "derived_deg" and "mesh" are null. Keys end in their
// unit.
Json hydrostatics_json(const Hydrostatics& h);

Json hull_json(const Hull& hull);
// {"file", "sha256", "repairs" in words, "bow_length_m", "depth_m"} of the user's own hull.
Json imported_json(const OwnHull& own);

// {"crushing_N", "bending_N", "submersion_N", "breaking_N", "total_N", "valid", "reason", "caution",
// "inputs": {...}}; forces are null where the formula's guards reject the inputs.
Json lindqvist_json(const LindqvistResult& result, const LindqvistInputs& inputs);
// {"L_m", "B_m", "T_m", "stem_deg", "waterline_deg", "h_m", "V_m_s", "sigma_f_Pa", "E_Pa", "nu", "mu",
// "rho_w", "rho_i", "g"}
Json lindqvist_inputs_json(const LindqvistInputs& inputs);

// Loads [N], moments and widths at the scale that was simulated, and "full_scale": the same multiplied by
// Froude's law with lambda = full scale / simulated scale.
Json metrics_json(const RunResult& run, double lambda);

// How the run was computed, with the ice it was computed with (model scale).
Json simulation_json(const RunResult& run, const IceMaterial& ice, double lambda);

// Why the run ended: "advance reached" or "interval narrow enough"; null where it failed.
Json ended_json(const RunResult& run);
// [{"phase", "ms_per_step", "share", "max_ms_per_step"}], mean and maximum over the ranks; share of the
// mean's sum.
Json profile_json(const RunResult& run);

}  // namespace icebow
