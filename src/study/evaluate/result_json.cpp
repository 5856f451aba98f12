#include "study/evaluate/result_json.h"

#include <cmath>
#include <filesystem>

#include "base/json_fields.h"
#include "base/units.h"
#include "hullgen/mesh/mesh_check.h"

namespace icebow {
namespace {

Json angles_deg(const BowAngles& a) {
  return {{"stem", finite_or_null(degrees(a.stem))},
          {"waterline", finite_or_null(degrees(a.waterline))},
          {"buttock", finite_or_null(degrees(a.buttock))},
          {"flare", finite_or_null(degrees(a.flare))}};
}

Json mesh_json(const QuadMesh& mesh) {
  const MeshCheck check = check_mesh(mesh);
  return {{"points", check.points},
          {"quads", check.quads},
          {"triangles", check.triangles},
          {"closed", check.closed},
          {"outward", check.outward},
          {"self_intersecting", check.self_intersecting},
          {"volume_m3", finite_or_null(check.volume)},
          {"max_warp", finite_or_null(check.max_warp)},
          {"max_aspect", finite_or_null(check.max_aspect)},
          {"max_bow_aspect", finite_or_null(check.max_bow_aspect)}};
}

// The loads of a run, at the simulated scale (factor 1) or at full scale (factor lambda^3).
Json loads_json(const Metrics& m, double factor) {
  const LoadStatistics& r = m.resistance;
  return {{"mean_load_N", finite_or_null(r.mean * factor)},
          {"mean_load_ci95_N", finite_or_null(r.ci95 * factor)},
          {"max_load_N", finite_or_null(r.max * factor)},
          {"q95_load_N", finite_or_null(r.q95 * factor)},
          {"std_load_N", finite_or_null(r.standard_deviation * factor)},
          {"vertical_mean_N", finite_or_null(m.vertical.mean * factor)},
          {"vertical_mean_ci95_N", finite_or_null(m.vertical.ci95 * factor)},
          {"vertical_max_N", finite_or_null(m.vertical.max * factor)}};
}

// Lengths and volumes of the broken ice, with the factor of a length.
void add_ice_extent(Json& to, const Metrics& m, double factor) {
  const double volume = factor * factor * factor;
  to["steady_from_m"] = finite_or_null(m.steady_from * factor);
  to["steady_to_m"] = finite_or_null(m.steady_to * factor);
  to["channel_width_m"] = finite_or_null(m.channel_width * factor);
  to["crushed_volume_m3"] = finite_or_null(m.crushed_volume * volume);
  to["broken_volume_m3"] = finite_or_null(m.broken_volume * volume);
}

}  // namespace

Json hydrostatics_json(const Hydrostatics& h) {
  return {{"draft_m", finite_or_null(h.draft)},
          {"length_m", finite_or_null(h.length)},
          {"beam_m", finite_or_null(h.beam)},
          {"volume_m3", finite_or_null(h.volume)},
          {"displacement_kg", finite_or_null(h.displacement)},
          {"LCB_m", finite_or_null(h.buoyancy.x())},
          {"TCB_m", finite_or_null(h.buoyancy.y())},
          {"KB_m", finite_or_null(h.KB)},
          {"waterplane_area_m2", finite_or_null(h.waterplane_area)},
          {"LCF_m", finite_or_null(h.flotation.x())},
          {"I_T_m4", finite_or_null(h.I_T)},
          {"I_L_m4", finite_or_null(h.I_L)},
          {"wetted_area_m2", finite_or_null(h.wetted_area)},
          {"block_coefficient", finite_or_null(h.block_coefficient)},
          {"waterplane_coefficient", finite_or_null(h.waterplane_coefficient)},
          {"BM_T_m", finite_or_null(h.BM_T)},
          {"BM_L_m", finite_or_null(h.BM_L)},
          {"KM_T_m", finite_or_null(h.KM_T)}};
}

Json hull_json(const Hull& hull) {
  Json json = {{"requested_deg", angles_deg(hull.requested)},
               {"measured_deg", nullptr},
               {"derived_deg", nullptr},
               {"margins", Json::object()},
               {"margin_sentences", Json::object()},
               {"margins_only_reported", Json::array()},
               {"feasible", hull.status == HullStatus::ok},
               {"reason", hull.reason},
               {"mesh", nullptr}};
  for (const Margin& margin : hull.feasibility.margins) {
    json["margins"][margin.name] = finite_or_null(margin.value);
    json["margin_sentences"][margin.name] = margin.sentence;
    if (!margin.required) json["margins_only_reported"].push_back(margin.name);
  }
  if (hull.status == HullStatus::infeasible) {
    if (hull.reason.empty()) json["reason"] = hull.feasibility.reason;
    return json;
  }
  json["measured_deg"] = angles_deg(hull.measured);
  json["derived_deg"] = {
      {"waterline_at_quarter_beam", finite_or_null(degrees(hull.waterline_at_quarter_beam))},
      {"flare_at_stem", finite_or_null(degrees(hull.flare_at_stem))}};
  if (hull.stem_radius > 0.0) json["stem_radius_m"] = finite_or_null(hull.stem_radius);
  if (!hull.mesh.quads.empty()) json["mesh"] = mesh_json(hull.mesh);
  return json;
}

Json imported_json(const OwnHull& own) {
  const ImportedHull& hull = *own.imported;
  return {{"file", std::filesystem::path(own.file).filename().string()},
          {"sha256", own.sha256},
          {"repairs", in_words(hull.repairs)},
          {"bow_length_m", finite_or_null(hull.Lf)},
          {"depth_m", finite_or_null(hull.D)}};
}

Json lindqvist_inputs_json(const LindqvistInputs& in) {
  return {{"L_m", finite_or_null(in.L)},
          {"B_m", finite_or_null(in.B)},
          {"T_m", finite_or_null(in.T)},
          {"stem_deg", finite_or_null(degrees(in.stem))},
          {"waterline_deg", finite_or_null(degrees(in.waterline))},
          {"h_m", finite_or_null(in.h)},
          {"V_m_s", finite_or_null(in.V)},
          {"sigma_f_Pa", finite_or_null(in.sigma_f)},
          {"E_Pa", finite_or_null(in.E)},
          {"nu", finite_or_null(in.nu)},
          {"mu", finite_or_null(in.mu)},
          {"rho_w", finite_or_null(in.rho_w)},
          {"rho_i", finite_or_null(in.rho_i)},
          {"g", finite_or_null(in.g)}};
}

Json lindqvist_json(const LindqvistResult& result, const LindqvistInputs& inputs) {
  const auto force = [&](double value) { return result.valid ? finite_or_null(value) : Json(nullptr); };
  return {{"crushing_N", force(result.crushing)},
          {"bending_N", force(result.bending)},
          {"submersion_N", force(result.submersion)},
          {"breaking_N", force(result.breaking)},
          {"total_N", force(result.total)},
          {"valid", result.valid},
          {"reason", result.reason},
          {"caution", result.caution},
          {"inputs", lindqvist_inputs_json(inputs)}};
}

Json metrics_json(const RunResult& run, double lambda) {
  const Metrics& m = run.metrics;
  Json json = loads_json(m, 1.0);
  add_ice_extent(json, m, 1.0);
  json["samples"] = m.resistance.samples;
  json["effective_samples"] = finite_or_null(m.resistance.effective_samples);
  json["drift"] = {{"relative", finite_or_null(m.drift.relative)}, {"p", finite_or_null(m.drift.p)}};
  json["broken_bonds"] = m.broken_bonds;
  json["bonds"] = m.bonds;
  json["mean_damage"] = finite_or_null(m.mean_damage);
  json["channel_width_over_beam"] = finite_or_null(m.channel_width_over_beam);
  json["floes"] = m.floes;
  Json full = loads_json(m, to_full_scale(1.0, lambda, scaling::force));
  add_ice_extent(full, m, lambda);
  json["full_scale"] = std::move(full);
  json["lambda"] = finite_or_null(lambda);
  return json;
}

Json ended_json(const RunResult& run) {
  if (run.status != RunStatus::ok) return nullptr;
  return run.ended == RunEnd::advance_reached ? "advance reached" : "interval narrow enough";
}

Json simulation_json(const RunResult& run, const IceMaterial& ice, double lambda) {
  const double stress = ice.tensile_strength, crushing = ice.crushing_pressure;
  return {{"dt_s", run.dt},
          {"dt_limit_s", run.dt_limit},
          {"steps", run.steps},
          {"ended", ended_json(run)},
          {"nx", run.nx},
          {"ny", run.ny},
          {"nz", run.nz},
          {"directed_bonds", run.directed_bonds},
          {"ns_per_bond", run.ns_per_bond},
          {"linear_share", run.linear_share},
          {"wall_s", run.wall_seconds},
          {"output_s", run.output_seconds},
          {"elastic_modulus_Pa", ice.E},
          {"critical_stretch", stress ? Json(nullptr) : Json(run.s0)},
          {"tensile_strength_Pa", stress ? Json(stress) : Json(nullptr)},
          {"crushing_pressure_Pa", crushing ? Json(crushing) : Json(nullptr)},
          {"lambda", lambda}};
}

Json profile_json(const RunResult& run) {
  double total = 0.0;
  for (const PhaseTime& p : run.profile) total += p.mean;
  const double ms = run.profiled_steps > 0 ? 1e3 / static_cast<double>(run.profiled_steps) : 0.0;
  Json json = Json::array();
  for (const PhaseTime& p : run.profile) {
    json.push_back({{"phase", p.phase},
                    {"ms_per_step", finite_or_null(p.mean * ms)},
                    {"share", finite_or_null(p.mean / total)},
                    {"max_ms_per_step", finite_or_null(p.max * ms)}});
  }
  return json;
}

}  // namespace icebow
