// A study whose evaluator is a formula: mean load over stem and waterline angle, smallest at (20, 30) deg,
// infeasible beyond a stem of 35 deg. Shared by the tests of the engine and by the child program they start.
#pragma once

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <limits>
#include <string>
#include <vector>

#include "base/errors.h"
#include "base/units.h"
#include "study/run/run_study.h"
#include "study/spec/read_study.h"

namespace icebow {

constexpr double largest_fake_stem = 35.0;  //!< [deg]

inline Json fake_document(const std::string& patch = "{}") {
  Json document = Json::parse(R"({"icebow_study": 1, "name": "fake",
    "bow": {"family": "straight_parallel_buttocks", "length_m": 147.2, "beam_m": 23.0, "draft_m": 8.0, "depth_m": 13.5,
            "bow_length_m": 32.5, "stem_deg": 25, "waterline_deg": 22, "buttock_deg": 28.0, "flare_deg": 33.0},
    "ice": {"model": "paper", "thickness_m": 1.0},
    "operation": {"speed_kn": 4.0}})");
  document.merge_patch(Json::parse(patch));
  return document;
}

inline StudySpec fake_study(const std::string& patch = "{}") {
  return read_study(fake_document(patch), "fake.json");
}

inline double fake_load(double stem_deg, double waterline_deg) {
  const double a = (stem_deg - 20.0) / 10.0, b = (waterline_deg - 30.0) / 10.0;
  return 1.0e6 * (1.0 + a * a + 0.5 * b * b);
}

inline std::vector<Margin> fake_margins(const Case& c) {
  return {{"g1", radians(largest_fake_stem) - c.bow.angles.stem, true, "stem at most 35 deg"},
          {"g2", -1.0, false, "reported only"}};
}

inline Evaluation fake_evaluate(const Communicator&, const Design& design, const EvaluateOptions& options) {
  const Case c = design.given.value();
  Evaluation e;
  e.name = design.name;
  e.key = "a fake does not know its key";
  const double stem = degrees(c.bow.angles.stem), waterline = degrees(c.bow.angles.waterline);
  if (fake_margins(c)[0].value < -1e-12) {  // rounding of degrees to radians
    e.status = EvaluationStatus::infeasible;
    e.reason = "stem beyond 35 deg";
    return e;
  }
  if (options.on_progress) options.on_progress({5, 10, 0.5, 7.0, 0.1, 2.0, 1.5, -0.01});
  e.status = EvaluationStatus::ok;
  const double load =
      design.name == "not a number" ? std::numeric_limits<double>::quiet_NaN() : fake_load(stem, waterline);
  e.result = {{"metrics", {{"full_scale", {{"mean_load_N", nullptr}, {"mean_load_ci95_N", 1000.0}}}}},
              {"ship", {{"B_m", c.bow.B}}},
              {"hull", {{"margins", {{"g1", largest_fake_stem - stem}}}}},
              {"lindqvist", {{"breaking_N", 2.0 * load}}}};
  if (std::isfinite(load)) e.result["metrics"]["full_scale"]["mean_load_N"] = load;
  return e;
}

class TemporaryDirectory {
 public:
  TemporaryDirectory() {
    std::string pattern = (std::filesystem::temp_directory_path() / "icebow_test_XXXXXX").string();
    if (!mkdtemp(pattern.data())) throw RuntimeError("no temporary directory");
    path_ = pattern;
  }
  ~TemporaryDirectory() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  TemporaryDirectory(const TemporaryDirectory&) = delete;
  TemporaryDirectory& operator=(const TemporaryDirectory&) = delete;

  std::string operator/(const std::string& name) const { return path_ + "/" + name; }

 private:
  std::string path_;
};

// What the observer was told, in order.
class RecordingObserver : public StudyObserver {
 public:
  void on_planned(const StudyPlan& plan) override { planned = plan; }
  void on_started(const Design& design) override { started.push_back(design.name); }
  void on_progress(const std::string& design, const Progress& p) override {
    progress.push_back(design);
    last_progress = p;
  }
  void on_finished(const Evaluation& e, bool was_recalled) override {
    finished.push_back(e);
    if (was_recalled) recalled.push_back(e.name);
  }
  void on_study_finished(const StudyOutcome&) override { ++ends; }

  StudyPlan planned;
  std::vector<std::string> started, progress, recalled;
  std::vector<Evaluation> finished;
  Progress last_progress;
  int ends = 0;
};

inline RunSettings fake_settings(const std::string& directory) {
  RunSettings settings;
  settings.directory = directory;
  settings.command = "icebow run fake.json";
  settings.launcher = Launcher::embedded;
  settings.evaluate = fake_evaluate;
  settings.margins = fake_margins;
  return settings;
}

}  // namespace icebow
