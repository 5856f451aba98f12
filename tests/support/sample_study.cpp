#include "tests/support/sample_study.h"

#include <cmath>
#include <filesystem>
#include <random>
#include <sstream>
#include <vector>

#include "base/json.h"
#include "base/units.h"
#include "study/plan/design_space.h"
#include "study/spec/read_study.h"
#include "study/store/design_files.h"
#include "study/store/store.h"
#include "tests/support/sample_files.h"

namespace icebow {
namespace {

constexpr double lambda = 25.0;

struct SampleBow {
  const char* name;
  double stem, waterline, buttock, flare;  //!< [deg]
  double mean, ci95;                       //!< model scale [N]; mean 0 = not simulated
};

// Invented, but of the size and order such bows have.
const std::vector<SampleBow> bows = {
    {"baseline", 24.35, 22.0, 28.0, 33.0, 62.1, 5.2},  {"Thyssen-Waas", 14.0, 39.0, 13.0, 77.0, 47.8, 3.9},
    {"steep stem", 32.0, 22.0, 30.0, 30.0, 78.4, 6.8}, {"fine entrance", 24.0, 18.0, 26.0, 38.0, 55.9, 4.1},
    {"White", 20.0, 28.0, 22.0, 45.0, 50.3, 4.4},      {"Melville", 21.0, 34.0, 20.0, 58.0, 51.7, 3.6},
    {"odd", 26.0, 25.0, 28.0, 36.0, 66.0, 5.5},        {"spoon", 22.0, 58.0, 22.0, 66.0, 59.2, 6.1},
    {"high flare", 20.5, 30.0, 18.0, 60.0, 49.1, 4.8}, {"blunt", 28.0, 44.0, 30.0, 48.0, 83.0, 7.4},
    {"too full", 20.0, 62.0, 50.0, 20.0, 0.0, 0.0},    {"too long", 12.0, 16.0, 12.0, 40.0, 0.0, 0.0},
    {"fast water", 22.0, 24.0, 26.0, 36.0, 0.0, 0.0}};

Json angles(const SampleBow& bow, double shift = 0.0) {
  return {{"stem", bow.stem + shift},
          {"waterline", bow.waterline - shift},
          {"buttock", bow.buttock + shift},
          {"flare", bow.flare}};
}

Json study_document(const SampleStudy& options) {
  Json designs = Json::array();
  for (std::size_t i = 1; i < bows.size(); ++i) {
    const SampleBow& bow = bows[i];
    designs.push_back({{"name", bow.name},
                       {"set",
                        {{"bow",
                          {{"stem_deg", bow.stem},
                           {"waterline_deg", bow.waterline},
                           {"buttock_deg", bow.buttock},
                           {"flare_deg", bow.flare}}}}}});
  }
  Json evaluators = Json::array();
  if (options.lindqvist) evaluators.push_back("lindqvist");
  if (options.peridynamics) evaluators.push_back("peridynamics");
  const SampleBow& base = bows[0];
  return {{"icebow_study", 1},
          {"name", "Thirteen bows for a 147 m icebreaker"},
          {"purpose",
           "Which bow form breaks level ice 1 m thick at 4 knots with the least load, and does Lindqvist's "
           "formula put the forms in the same order?"},
          {"scale", lambda},
          {"bow",
           {{"family", "straight_parallel_buttocks"},
            {"length_m", 147.2},
            {"beam_m", 23.0},
            {"draft_m", 8.0},
            {"depth_m", 13.5},
            {"bow_length_m", 32.5},
            {"stem_deg", base.stem},
            {"waterline_deg", base.waterline},
            {"buttock_deg", base.buttock},
            {"flare_deg", base.flare}}},
          {"ice", {{"thickness_m", 1.0}}},
          {"operation", {{"speed_kn", 4.0}}},
          {"evaluators", evaluators},
          {"designs", designs}};
}

Json hull_part(const SampleBow& bow, bool feasible) {
  const double entrance = std::tan(radians(bow.flare)) * std::tan(radians(bow.buttock));
  return {
      {"requested_deg", angles(bow)},
      {"measured_deg", feasible ? angles(bow, 0.008) : Json()},
      {"derived_deg", feasible ? Json{{"waterline_at_quarter_beam", degrees(std::atan(entrance))},
                                      {"flare_at_stem", degrees(std::atan(std::tan(radians(bow.waterline)) /
                                                                          std::tan(radians(bow.stem))))}}
                               : Json()},
      {"margins", {{"g1", feasible ? 8.73 : -3.41}, {"g2", -0.41}, {"g3", 1.92}, {"g5", 41.0}}},
      {"margins_only_reported", {"g2"}},
      {"margin_sentences",
       {{"g1", "The design waterline widens all the way aft."},
        {"g2", "The design waterline is hollow near the stem (reported only)."},
        {"g3", "Every waterline below widens all the way aft."},
        {"g5", "The forebody is long enough for the bow and its underwater shell."}}},
      {"feasible", feasible}};
}

Json lindqvist_part(const SampleBow& bow) {
  const double crushing = 1.1e4 * bow.stem + 900.0 * bow.waterline,
               bending = 3.9e3 * bow.waterline + 4.0e3 * bow.stem;
  const double factor = 1.0 + 1.4 * 2.058 / std::sqrt(gravity);
  return {{"crushing_N", crushing},
          {"bending_N", bending},
          {"submersion_N", 4.25e5},
          {"breaking_N", (crushing + bending) * factor},
          {"total_N", (crushing + bending) * factor + 6.4e5},
          {"valid", true},
          {"reason", ""},
          {"caution", bow.flare > 70 ? "Not validated for Thyssen-Waas bows." : ""},
          {"inputs",
           {{"L_m", 147.2},
            {"B_m", 23.0},
            {"T_m", 8.0},
            {"stem_deg", bow.stem},
            {"waterline_deg", bow.waterline},
            {"h_m", 1.0},
            {"V_m_s", 2.0578},
            {"sigma_f_Pa", 5e5},
            {"E_Pa", 1.3e9},
            {"nu", 0.33},
            {"mu", 0.1},
            {"rho_w", 1025.0},
            {"rho_i", 900.0},
            {"g", 9.81}}}};
}

Json loads(const SampleBow& bow, double factor) {
  return {{"mean_load_N", bow.mean * factor},       {"mean_load_ci95_N", bow.ci95 * factor},
          {"max_load_N", 1.86 * bow.mean * factor}, {"q95_load_N", 1.5 * bow.mean * factor},
          {"std_load_N", 0.31 * bow.mean * factor}, {"vertical_mean_N", 1.9 * bow.mean * factor}};
}

Json metrics_part(const SampleBow& bow) {
  Json metrics = loads(bow, 1.0);
  metrics.update({{"steady_from_m", 0.5},
                  {"steady_to_m", 2.5},
                  {"broken_bonds", 812345},
                  {"floes", 41},
                  {"effective_samples", 37.4},
                  {"channel_width_over_beam", 1.18},
                  {"crushed_volume_m3", 0.0021},
                  {"broken_volume_m3", 0.0823}});
  metrics["full_scale"] = loads(bow, std::pow(lambda, 3));
  return metrics;
}

// Saw teeth of a breaking cycle, crushing noise, and the run-up before the steady part; its mean is the
// bow's.
std::string history_csv(const SampleBow& bow, int rows, unsigned seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> noise(0.0, 1.0);
  std::ostringstream csv;
  csv << "time_s,advance_m,Fx_N,Fy_N,Fz_N,Mx_Nm,My_Nm,Mz_Nm,broken_bonds,contacts,kinetic_energy_J\n";
  double slow = 0.0;
  for (int i = 0; i < rows; ++i) {
    const double advance = 2.4997 * (i + 1) / rows;  // 62.49 m in two decimals, below the steady part's end
    slow = 0.995 * slow + 0.02 * noise(random);
    const double tooth = std::fmod(advance / (0.2 + 0.004 * seed) + slow, 1.0);
    const double load = bow.mean * std::min(1.0, advance / 0.35) *
                        std::max(0.0, 0.55 + 0.9 * tooth + slow + 0.13 * noise(random));
    csv << advance / 0.4116 << ',' << advance << ',' << -load << ',' << noise(random) << ',' << 1.9 * load
        << ",0,0,0," << 300 * i << ',' << 40 + i % 17 << ",0.4\n";
  }
  return csv.str();
}

void write_files(const std::string& directory, const SampleBow& bow, const SampleStudy& options,
                 unsigned seed, Json& result) {
  write_text_file(directory + "/hull.obj",
                  sample_hull_obj(bow.waterline, bow.flare > 70 ? 10.0 : 32.5 - 0.2 * bow.waterline));
  write_text_file(directory + "/lines.svg", sample_lines_svg(bow.name, bow.stem, bow.waterline));
  result["files"] = {{"lines_plan", "lines.svg"}, {"hull", "hull.obj"}};
  if (!options.peridynamics) return;
  write_text_file(directory + "/history.csv", history_csv(bow, options.history_rows, seed));
  result["files"]["history"] = "history.csv";
  result["files"]["pictures"] = Json::array();
  write_sample_picture(directory + "/breaking.png", options.picture_width, 2.5, seed);
  result["files"]["animation"] = "breaking.png";
  for (int k = 0; k < 3; ++k) {
    const std::string file = "ice_00" + std::to_string(k) + ".png";
    const double advance = 2.5 * (k + 1) / 3;
    write_sample_picture(directory + '/' + file, options.picture_width, advance,
                         seed + static_cast<unsigned>(k));
    result["files"]["pictures"].push_back({{"file", file}, {"advance_m", advance}});
  }
}

Evaluation evaluation_of(const PlannedDesign& planned, const SampleBow& bow, const SampleStudy& options) {
  Evaluation e;
  e.key = planned.key;
  e.name = bow.name == std::string("odd") ? options.odd_name : planned.design.name;
  e.parameters = {{"/bow/stem_deg", bow.stem}, {"/bow/waterline_deg", bow.waterline}};
  e.status = bow.mean > 0.0 ? EvaluationStatus::ok : EvaluationStatus::infeasible;
  if (bow.name == std::string("fast water")) e.status = EvaluationStatus::failed;
  if (e.status == EvaluationStatus::infeasible)
    e.reason =
        "g1 = -3.41 m: the design waterline would have to narrow aft of the stem; lengthen the bow or raise "
        "the waterline angle.";
  if (e.status == EvaluationStatus::failed)
    e.reason =
        "unstable at step 8120, t = 0.412 s: a particle moved faster than 40 m/s at x = 1.31 m; take a "
        "smaller time step.";
  e.wall_seconds = e.status == EvaluationStatus::infeasible ? 0.3 : 512.0 + bow.stem;
  return e;
}

void add_result(Evaluation& e, const SampleBow& bow, const SampleStudy& options) {
  e.result = {{"design", e.name},
              {"status", to_string(e.status)},
              {"reason", e.reason},
              {"hull", hull_part(bow, e.status != EvaluationStatus::infeasible)}};
  if (e.status == EvaluationStatus::infeasible) return;
  if (options.pareto) e.result["hydrostatics"] = {{"displacement_kg", 1.6e7 + 8e4 * bow.stem}};
  if (options.lindqvist) e.result["lindqvist"] = lindqvist_part(bow);
  if (!options.peridynamics || e.status != EvaluationStatus::ok) return;
  e.result["metrics"] = metrics_part(bow);
  e.result["simulation"] = {{"dt_s", 4.9e-5},
                            {"steps", 124000},
                            {"nx", 280},
                            {"ny", 248},
                            {"nz", 3},
                            {"directed_bonds", 21000000},
                            {"ns_per_bond", 0.61},
                            {"wall_s", e.wall_seconds},
                            {"critical_stretch", 0.0052},
                            {"lambda", lambda}};
}

}  // namespace

void write_sample_study(const std::string& directory, const SampleStudy& options) {
  const Json document = study_document(options);
  std::filesystem::create_directories(directory);
  write_text_file(directory + "/study.json", document.dump(2));
  Store store = Store::open(directory + "/results.sqlite");
  store.set_fact("study", document.dump());
  store.set_fact("command", "icebow run studies/bows.json --out out/bows");
  store.set_fact("version", "0.1.0");
  store.set_fact("host", "towing-tank");
  store.set_fact("rank_by", options.peridynamics ? "mean_load" : "lindqvist_breaking");
  if (options.pareto)
    store.set_fact("second_objective", R"({"by": "/hydrostatics/displacement_kg", "best": "largest"})");
  store.set_fact("state", options.finished ? "finished" : "running");
  store.set_fact("started", "2026-11-22T15:43:32Z");
  const StudyPlan plan = plan_study(read_study(document, "sample"));
  const std::size_t shown = options.finished ? bows.size() : bows.size() - 4;
  for (std::size_t i = 0; i < shown; ++i) {
    Evaluation e = evaluation_of(plan.designs.at(i), bows[i], options);
    const bool is_running = !options.finished && i + 1 == shown;
    if (is_running) e.status = EvaluationStatus::running;
    add_result(e, bows[i], options);
    const std::string files = design_directory(directory, e.name);
    std::filesystem::create_directories(files);
    if (e.status == EvaluationStatus::ok)
      write_files(files, bows[i], options, static_cast<unsigned>(i) + 1, e.result);
    store.put(e);
  }
}

}  // namespace icebow
