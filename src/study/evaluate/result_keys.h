// Where the numbers of a stored result are: the one place that spells the keys of result.json for those who
// read it (scripts/check_layers finds a key that is spelled elsewhere). result_json.h and process_json.h
// write them; docs/study_file.md, "Results", says what each means. A test holds all that is listed here
// against a real result.
#pragma once

#include <iterator>
#include <string>
#include <vector>

namespace icebow::result_key {

// A result has several of each of these, by name.
inline std::string requested_deg(const std::string& angle) {
  return "/hull/requested_deg/" + angle;
}
inline std::string measured_deg(const std::string& angle) {
  return "/hull/measured_deg/" + angle;
}
inline std::string derived_deg(const std::string& angle) {
  return "/hull/derived_deg/" + angle;
}
inline std::string cracks(const std::string& kind) {
  return "/process/cracks/" + kind + "/count";
}
inline std::string energy(const std::string& part) {
  return "/process/energy/" + part;
}
inline std::string file(const std::string& kind) {
  return "/files/" + kind;
}

inline std::string cycle_part(const std::string& part) {
  return "/cycle/" + part + "_N";
}
// A number of another program, like "/programs/yard/resistance_N".
inline bool is_of_program(const std::string& pointer) {
  return pointer.rfind("/programs/", 0) == 0;
}
// A number of a formula, of a hull or of a program: without a sampling error.
inline bool is_exact(const std::string& pointer) {
  for (const char* part : {"/programs/", "/lindqvist/", "/hydrostatics/", "/hull/"})
    if (pointer.rfind(part, 0) == 0) return true;
  return false;
}
inline bool is_of_cycle(const std::string& pointer) {
  return pointer.rfind("/cycle/", 0) == 0;
}
inline bool is_margin(const std::string& pointer) {
  return pointer.rfind("/hull/margins/", 0) == 0;
}
inline bool is_hydrostatic(const std::string& pointer) {
  return pointer.rfind("/hydrostatics/", 0) == 0;
}

// One crack of crack_list, one picture of pictures, one scenario of scenarios.
constexpr const char* crack_kind = "/kind";
constexpr const char* crack_opened = "/opened_m";
constexpr const char* crack_length = "/length_m";
constexpr const char* picture_file = "/file";
constexpr const char* picture_advance = "/advance_m";
constexpr const char* scenario_name = "/name";
constexpr const char* scenario_weight = "/weight";

// A load at both scales, with the half width of its interval where it has one.
struct Load {
  const char *full, *model;
  const char *full_ci95 = "", *model_ci95 = "";
};

constexpr const char* beam = "/ship/B_m";
constexpr const char* margins = "/hull/margins";
constexpr const char* margin_sentences = "/hull/margin_sentences";
constexpr const char* margins_only_reported = "/hull/margins_only_reported";  // their names
constexpr const char* imported = "/hull/imported";
constexpr const char* imported_file = "/hull/imported/file";
constexpr const char* imported_repairs = "/hull/imported/repairs";
constexpr const char* full_scale = "/metrics/full_scale";
constexpr const char* mean_load = "/metrics/full_scale/mean_load_N";
constexpr const char* mean_load_ci95 = "/metrics/full_scale/mean_load_ci95_N";
constexpr const char* max_load = "/metrics/full_scale/max_load_N";
constexpr const char* q95_load = "/metrics/full_scale/q95_load_N";
constexpr const char* std_load = "/metrics/full_scale/std_load_N";
constexpr const char* vertical_mean = "/metrics/full_scale/vertical_mean_N";
constexpr const char* vertical_mean_ci95 = "/metrics/full_scale/vertical_mean_ci95_N";
constexpr const char* steady_from = "/metrics/full_scale/steady_from_m";
constexpr const char* steady_to = "/metrics/full_scale/steady_to_m";
constexpr const char* model_mean_load = "/metrics/mean_load_N";
constexpr const char* model_mean_load_ci95 = "/metrics/mean_load_ci95_N";
constexpr const char* model_max_load = "/metrics/max_load_N";
constexpr const char* model_q95_load = "/metrics/q95_load_N";
constexpr const char* model_std_load = "/metrics/std_load_N";
constexpr const char* model_vertical_mean = "/metrics/vertical_mean_N";
constexpr const char* model_vertical_mean_ci95 = "/metrics/vertical_mean_ci95_N";
constexpr const char* model_steady_from = "/metrics/steady_from_m";
constexpr const char* model_steady_to = "/metrics/steady_to_m";
constexpr const char* effective_samples = "/metrics/effective_samples";
constexpr const char* drift = "/metrics/drift/relative";
constexpr const char* drift_p = "/metrics/drift/p";
constexpr const char* channel_width_over_beam = "/metrics/channel_width_over_beam";
constexpr const char* pieces = "/metrics/floes";
constexpr const char* broken_volume = "/metrics/broken_volume_m3";
constexpr const char* crushed_volume = "/metrics/crushed_volume_m3";
constexpr const char* broken_bonds = "/metrics/broken_bonds";
constexpr const char* metrics_lambda = "/metrics/lambda";
constexpr const char* cycle_load = "/cycle/mean_load_N";
constexpr const char* cycle_load_ci95 = "/cycle/mean_load_ci95_N";
constexpr const char* cycle = "/cycle";
constexpr const char* cycle_reason = "/cycle/reason";  // why no voyage came to its end; empty where all did
constexpr const char* cycle_same_way_load = "/cycle/same_way/mean_load_N";
constexpr const char* cycle_same_way_ci95 = "/cycle/same_way/ci95_N";
constexpr const char* cycle_voyages = "/cycle/voyages";
constexpr const char* cycle_ci95_voyages = "/cycle/ci95_voyages_N";
constexpr const char* cycle_effective_samples = "/cycle/metrics/effective_samples";
constexpr const char* cycle_submersion = "/cycle/submersion_N";
constexpr const char* bias = "/metrics/resolution_bias/relative";
constexpr const char* bias_ci95 = "/metrics/resolution_bias/ci95";
constexpr const char* bias_sentence = "/metrics/resolution_bias/sentence";
constexpr const char* lindqvist = "/lindqvist";
constexpr const char* lindqvist_valid = "/lindqvist/valid";
constexpr const char* lindqvist_reason = "/lindqvist/reason";
constexpr const char* lindqvist_caution = "/lindqvist/caution";
constexpr const char* lindqvist_crushing = "/lindqvist/crushing_N";
constexpr const char* lindqvist_bending = "/lindqvist/bending_N";
constexpr const char* lindqvist_submersion = "/lindqvist/submersion_N";
constexpr const char* lindqvist_breaking = "/lindqvist/breaking_N";
constexpr const char* lindqvist_total = "/lindqvist/total_N";
constexpr const char* thickness = "/lindqvist/inputs/h_m";
constexpr const char* speed = "/lindqvist/inputs/V_m_s";
constexpr const char* flexural_strength = "/lindqvist/inputs/sigma_f_Pa";
constexpr const char* elastic_modulus = "/lindqvist/inputs/E_Pa";
constexpr const char* friction = "/lindqvist/inputs/mu";
constexpr const char* ship_length = "/lindqvist/inputs/L_m";
constexpr const char* ship_beam = "/lindqvist/inputs/B_m";
constexpr const char* draught = "/lindqvist/inputs/T_m";
constexpr const char* simulation = "/simulation";
constexpr const char* particles_along = "/simulation/nx";
constexpr const char* particles_across = "/simulation/ny";
constexpr const char* layers = "/simulation/nz";
constexpr const char* steps = "/simulation/steps";
constexpr const char* time_step = "/simulation/dt_s";
constexpr const char* critical_stretch = "/simulation/critical_stretch";
constexpr const char* tensile_strength = "/simulation/tensile_strength_Pa";
constexpr const char* crushing_pressure = "/simulation/crushing_pressure_Pa";
constexpr const char* load_part = "/simulation/load";
constexpr const char* simulated_flexural_strength = "/simulation/ice/flexural_strength_Pa";
constexpr const char* simulated_ice_sentence = "/simulation/ice/sentence";
constexpr const char* simulated_ice_model = "/simulation/ice/model";
constexpr const char* bond_modulus = "/simulation/elastic_modulus_Pa";
constexpr const char* lambda = "/simulation/lambda";
constexpr const char* ns_per_bond = "/simulation/ns_per_bond";
constexpr const char* ranks = "/provenance/ranks";
constexpr const char* evaluated_by = "/provenance/version";
constexpr const char* evaluated_on = "/provenance/host";
constexpr const char* evaluated_at = "/provenance/date_utc";
constexpr const char* evaluation_seconds = "/provenance/wall_s";
constexpr const char* failure_cause = "/failure/cause";  // of a failed design only, as the three below
constexpr const char* failed_program = "/failure/program";
constexpr const char* failed_time_limit = "/failure/time_limit_s";
constexpr const char* failed_version = "/failure/version";
constexpr const char* simulation_seconds = "/simulation/wall_s";
constexpr const char* sailed_to = "/sailed_to_m";        // of a voyage in a race only
constexpr const char* sailing_ended = "/sailing_ended";  // why such a voyage cannot be sailed on, in words
constexpr const char* scenarios = "/scenarios";
constexpr const char* choices = "/choices";  // of variables that are words, by their pointers
constexpr const char* pictures = "/files/pictures";
constexpr const char* process = "/process";
constexpr const char* sheet_thickness = "/process/thickness_m";
constexpr const char* characteristic_length = "/process/characteristic_length_m";
constexpr const char* crack_list = "/process/cracks/list";
constexpr const char* breaking_length = "/process/breaking_length/normal_m";
constexpr const char* breaking_length_median = "/process/breaking_length/normal_median_m";
constexpr const char* breaking_length_nine_tenths = "/process/breaking_length/normal_q90_m";
constexpr const char* breaking_length_along_course = "/process/breaking_length/along_course_m";
constexpr const char* breaking_length_over_characteristic =
    "/process/breaking_length/normal_over_characteristic";
constexpr const char* in_floes_share = "/process/detached/in_floes_share";
constexpr const char* dust_share = "/process/detached/dust_share";
constexpr const char* floes = "/process/floes/count";
constexpr const char* floes_through_thickness = "/process/floes/through_thickness";
constexpr const char* floe_length = "/process/floes/length_m/mean";
constexpr const char* floe_width = "/process/floes/width_m/mean";
constexpr const char* cycles = "/process/load_cycle/cycles";
constexpr const char* cycle_advance = "/process/load_cycle/advance_m";
constexpr const char* cycle_autocorrelation = "/process/load_cycle/autocorrelation";
constexpr const char* cycle_significant_above = "/process/load_cycle/significant_above";
constexpr const char* peak_over_mean = "/process/load_cycle/peak_over_mean";
constexpr const char* std_over_mean = "/process/load_cycle/std_over_mean";
constexpr const char* without_contact_share = "/process/load_cycle/without_contact_share";
constexpr const char* channel_width = "/process/channel/width_m/mean";
constexpr const char* channel_width_std = "/process/channel/width_std_m";

// What every simulation tells.
constexpr const char* of_every_run[] = {beam,
                                        margins,
                                        margin_sentences,
                                        margins_only_reported,
                                        full_scale,
                                        mean_load,
                                        mean_load_ci95,
                                        max_load,
                                        q95_load,
                                        std_load,
                                        vertical_mean,
                                        vertical_mean_ci95,
                                        steady_from,
                                        steady_to,
                                        model_mean_load,
                                        model_mean_load_ci95,
                                        model_max_load,
                                        model_q95_load,
                                        model_std_load,
                                        model_vertical_mean,
                                        model_vertical_mean_ci95,
                                        model_steady_from,
                                        model_steady_to,
                                        effective_samples,
                                        drift,
                                        drift_p,
                                        channel_width_over_beam,
                                        pieces,
                                        broken_volume,
                                        crushed_volume,
                                        broken_bonds,
                                        metrics_lambda,
                                        bias,
                                        bias_ci95,
                                        bias_sentence,
                                        lindqvist,
                                        lindqvist_valid,
                                        lindqvist_reason,
                                        lindqvist_caution,
                                        lindqvist_crushing,
                                        lindqvist_bending,
                                        lindqvist_submersion,
                                        lindqvist_breaking,
                                        lindqvist_total,
                                        thickness,
                                        speed,
                                        flexural_strength,
                                        elastic_modulus,
                                        friction,
                                        ship_length,
                                        ship_beam,
                                        draught,
                                        simulation,
                                        particles_along,
                                        particles_across,
                                        layers,
                                        steps,
                                        time_step,
                                        critical_stretch,
                                        tensile_strength,
                                        crushing_pressure,
                                        load_part,
                                        simulated_flexural_strength,
                                        simulated_ice_sentence,
                                        simulated_ice_model,
                                        bond_modulus,
                                        lambda,
                                        ns_per_bond,
                                        ranks,
                                        evaluated_by,
                                        evaluated_on,
                                        evaluated_at,
                                        evaluation_seconds,
                                        simulation_seconds,
                                        pictures,
                                        process,
                                        sheet_thickness,
                                        characteristic_length,
                                        crack_list,
                                        breaking_length,
                                        breaking_length_median,
                                        breaking_length_nine_tenths,
                                        breaking_length_along_course,
                                        breaking_length_over_characteristic,
                                        in_floes_share,
                                        dust_share,
                                        floes,
                                        floes_through_thickness,
                                        floe_length,
                                        floe_width,
                                        cycles,
                                        cycle_advance,
                                        cycle_autocorrelation,
                                        cycle_significant_above,
                                        peak_over_mean,
                                        std_over_mean,
                                        without_contact_share,
                                        channel_width,
                                        channel_width_std};
// What the evaluator "cycle" tells where its voyages came to their end.
constexpr const char* of_every_cycle[] = {cycle,
                                          cycle_reason,
                                          cycle_load,
                                          cycle_load_ci95,
                                          cycle_voyages,
                                          cycle_ci95_voyages,
                                          cycle_effective_samples,
                                          cycle_submersion};
constexpr const char* of_every_import[] = {imported, imported_file, imported_repairs};

inline std::vector<std::string> all() {
  std::vector<std::string> keys(std::begin(of_every_run), std::end(of_every_run));
  for (const char* angle : {"stem", "waterline", "buttock", "flare"}) {
    keys.push_back(requested_deg(angle));
    keys.push_back(measured_deg(angle));
  }
  for (const char* angle : {"waterline_at_quarter_beam", "flare_at_stem"}) keys.push_back(derived_deg(angle));
  for (const char* kind : {"radial", "circumferential", "splitting", "crushed", "secondary", "held_edge"})
    keys.push_back(cracks(kind));
  for (const char* part : {"contact_loss", "fracture", "water", "floe_contact", "absorbed", "kinetic",
                           "elastic", "potential", "left_astern", "unexplained"})
    keys.push_back(energy(part));
  return keys;
}

}  // namespace icebow::result_key
