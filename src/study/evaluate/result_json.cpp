#include "study/evaluate/result_json.h"

#include <cmath>
#include <filesystem>

#include "base/units.h"
#include "hullgen/mesh/mesh_check.h"

namespace icebow {
namespace {

Json number(double value) {
  return std::isfinite(value) ? Json(value) : Json(nullptr);
}

Json angles_deg(const BowAngles& a) {
  return {{"stem", number(degrees(a.stem))},
          {"waterline", number(degrees(a.waterline))},
          {"buttock", number(degrees(a.buttock))},
          {"flare", number(degrees(a.flare))}};
}

Json mesh_json(const QuadMesh& mesh) {
  const MeshCheck check = check_mesh(mesh);
  return {{"points", check.points},
          {"quads", check.quads},
          {"triangles", check.triangles},
          {"closed", check.closed},
          {"outward", check.outward},
          {"self_intersecting", check.self_intersecting},
          {"volume_m3", number(check.volume)},
          {"max_warp", number(check.max_warp)},
          {"max_aspect", number(check.max_aspect)},
          {"max_bow_aspect", number(check.max_bow_aspect)}};
}

// The loads of a run, at the simulated scale (factor 1) or at full scale (factor lambda^3).
Json loads_json(const Metrics& m, double factor) {
  const LoadStatistics& r = m.resistance;
  return {{"mean_load_N", number(r.mean * factor)},
          {"mean_load_ci95_N", number(r.ci95 * factor)},
          {"max_load_N", number(r.max * factor)},
          {"q95_load_N", number(r.q95 * factor)},
          {"std_load_N", number(r.standard_deviation * factor)},
          {"vertical_mean_N", number(m.vertical.mean * factor)},
          {"vertical_mean_ci95_N", number(m.vertical.ci95 * factor)},
          {"vertical_max_N", number(m.vertical.max * factor)}};
}

// Lengths and volumes of the broken ice, with the factor of a length.
void add_ice_extent(Json& to, const Metrics& m, double factor) {
  const double volume = factor * factor * factor;
  to["steady_from_m"] = number(m.steady_from * factor);
  to["steady_to_m"] = number(m.steady_to * factor);
  to["channel_width_m"] = number(m.channel_width * factor);
  to["crushed_volume_m3"] = number(m.crushed_volume * volume);
  to["broken_volume_m3"] = number(m.broken_volume * volume);
}

}  // namespace

Json hull_json(const Hull& hull) {
  Json json = {{"requested_deg", angles_deg(hull.requested)},
               {"measured_deg", nullptr},
               {"derived_deg", nullptr},
               {"margins", Json::object()},
               {"margin_sentences", Json::object()},
               {"feasible", hull.status == HullStatus::ok},
               {"reason", hull.reason},
               {"mesh", nullptr}};
  for (const Margin& margin : hull.feasibility.margins) {
    json["margins"][margin.name] = number(margin.value);
    json["margin_sentences"][margin.name] = margin.sentence;
  }
  if (hull.status == HullStatus::infeasible) {
    if (hull.reason.empty()) json["reason"] = hull.feasibility.reason;
    return json;
  }
  json["measured_deg"] = angles_deg(hull.measured);
  json["derived_deg"] = {{"waterline_at_quarter_beam", number(degrees(hull.waterline_at_quarter_beam))},
                         {"flare_at_stem", number(degrees(hull.flare_at_stem))}};
  if (!hull.mesh.quads.empty()) json["mesh"] = mesh_json(hull.mesh);
  return json;
}

Json imported_json(const OwnHull& own) {
  const ImportedHull& hull = *own.imported;
  return {{"file", std::filesystem::path(own.file).filename().string()},
          {"sha256", own.sha256},
          {"repairs", in_words(hull.repairs)},
          {"bow_length_m", number(hull.Lf)},
          {"depth_m", number(hull.D)}};
}

Json lindqvist_inputs_json(const LindqvistInputs& in) {
  return {{"L_m", number(in.L)},
          {"B_m", number(in.B)},
          {"T_m", number(in.T)},
          {"stem_deg", number(degrees(in.stem))},
          {"waterline_deg", number(degrees(in.waterline))},
          {"h_m", number(in.h)},
          {"V_m_s", number(in.V)},
          {"sigma_f_Pa", number(in.sigma_f)},
          {"E_Pa", number(in.E)},
          {"nu", number(in.nu)},
          {"mu", number(in.mu)},
          {"rho_w", number(in.rho_w)},
          {"rho_i", number(in.rho_i)},
          {"g", number(in.g)}};
}

Json lindqvist_json(const LindqvistResult& result, const LindqvistInputs& inputs) {
  const auto force = [&](double value) { return result.valid ? number(value) : Json(nullptr); };
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
  json["effective_samples"] = number(m.resistance.effective_samples);
  json["broken_bonds"] = m.broken_bonds;
  json["bonds"] = m.bonds;
  json["mean_damage"] = number(m.mean_damage);
  json["channel_width_over_beam"] = number(m.channel_width_over_beam);
  json["floes"] = m.floes;
  Json full = loads_json(m, to_full_scale(1.0, lambda, scaling::force));
  add_ice_extent(full, m, lambda);
  json["full_scale"] = std::move(full);
  json["lambda"] = number(lambda);
  return json;
}

Json ended_json(const RunResult& run) {
  if (run.status != RunStatus::ok) return nullptr;
  return run.ended == RunEnd::advance_reached ? "advance reached" : "interval narrow enough";
}

Json profile_json(const RunResult& run) {
  double total = 0.0;
  for (const PhaseTime& p : run.profile) total += p.mean;
  const double ms = run.profiled_steps > 0 ? 1e3 / static_cast<double>(run.profiled_steps) : 0.0;
  Json json = Json::array();
  for (const PhaseTime& p : run.profile) {
    json.push_back({{"phase", p.phase},
                    {"ms_per_step", number(p.mean * ms)},
                    {"share", number(p.mean / total)},
                    {"max_ms_per_step", number(p.max * ms)}});
  }
  return json;
}

}  // namespace icebow
