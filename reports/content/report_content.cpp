#include "reports/content/report_content.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>

#include "base/errors.h"
#include "base/json_fields.h"
#include "reports/content/comparison.h"
#include "reports/content/inline_svg.h"
#include "reports/text/text_format.h"
#include "solver/model/drift.h"
#include "study/evaluate/result_keys.h"
#include "study/plan/repeats.h"
#include "study/store/design_files.h"

namespace icebow {
namespace {

namespace fs = std::filesystem;

constexpr std::uintmax_t picture_budget = 3'500'000;  // bytes of PNG in the whole page
constexpr std::size_t history_points = 40'000;        // of all designs together
constexpr std::size_t most_histories = 60;            // designs with a record in the page
constexpr std::size_t drawing_budget = 2'000'000;     // bytes of lines plans and voyages in the page
constexpr double plan_height_px = 26.0;

constexpr std::uintmax_t largest_drawing = 8'000'000;  // bytes; ours have some hundred thousand

// A design's directory, from which nothing is read that does not lie in the study's: a study that somebody
// has sent may hold links to files of the reader's own.
class DesignFiles {
 public:
  DesignFiles(const std::string& study_directory, const std::string& name)
      : study_(fs::weakly_canonical(study_directory)), directory_(design_directory(study_directory, name)) {}

  // Empty where there is no such file.
  std::string path(const std::string& name) const {
    std::error_code error;
    const fs::path file = fs::canonical(directory_ / fs::path(name).filename(), error);
    if (error || !fs::is_regular_file(file, error)) return "";
    const auto [end, ignored] = std::mismatch(study_.begin(), study_.end(), file.begin(), file.end());
    return end == study_.end() ? file.string() : "";
  }

  // The file a result names, in the design's own directory whatever the name says.
  std::string named(const Json& result, const std::string& key, const char* usual) const {
    const std::string name = text_at(result, result_key::file(key));
    return path(name.empty() ? usual : name);
  }

 private:
  fs::path study_, directory_;
};

bool is_png(const std::string& path) {
  char head[8] = {};
  std::ifstream(path, std::ios::binary).read(head, 8);
  return std::string(head, 8) == "\x89PNG\r\n\x1a\n";
}

constexpr int most_animations = 2;                       // likewise
constexpr std::uintmax_t largest_animation = 1'500'000;  // bytes

constexpr int most_voyages = 5;  // in a page: of the first ranks

std::string lines_plan(const std::string& file, const std::string& id) {
  try {
    return file.empty() ? std::string() : inline_svg(read_text_file(file, largest_drawing), id + "-");
  } catch (const InputError&) {
    return {};
  }
}

std::vector<Picture> pictures_of(const DesignFiles& files, const Json& result) {
  std::vector<Picture> pictures;
  const Json& list = part_at(result, result_key::pictures);
  if (!list.is_array()) return pictures;
  for (const Json& entry : list) {
    const std::string file = files.path(text_at(entry, result_key::picture_file));
    if (!file.empty() && is_png(file))
      pictures.push_back({file, number_at(entry, result_key::picture_advance)});
  }
  return pictures;
}

// The file, where it is one a page can carry.
std::string animation(const std::string& file) {
  return !file.empty() && is_png(file) && fs::file_size(file) <= largest_animation ? file : "";
}

// Of the first run that is ok.
DesignFiles files_of(const StudyResults& study, const Evaluation& design) {
  const auto repeats = study.repeats.find(design.name);
  return {study.directory, repeats == study.repeats.end() ? design.name : repeats->second.front().name};
}

DesignContent read_design(const StudyResults& study, std::size_t index) {
  const Evaluation& e = study.ranking.rows[index].evaluation;
  const DesignFiles files = files_of(study, e);
  DesignContent design;
  design.id = "design-" + std::to_string(index + 1);
  design.lambda = number_at(e.result, result_key::lambda);
  if (!std::isfinite(design.lambda)) design.lambda = number_at(e.result, result_key::metrics_lambda);
  design.waterline = read_waterline(files.named(e.result, "hull", "hull.obj"));
  design.lines_plan = lines_plan(files.named(e.result, "lines_plan", "lines.svg"), design.id);
  const int rank = study.ranking.rows[index].rank;
  if (rank > 0 && rank <= most_voyages)
    design.voyage = lines_plan(files.named(e.result, "voyage", "voyage.svg"), design.id + "-voyage");
  design.pictures = pictures_of(files, e.result);
  if (rank > 0 && rank <= most_animations)
    design.animation = animation(files.named(e.result, "animation", "breaking.png"));
  return design;
}

// Records of the first ranks and of the baseline, of every run.
void read_histories(ReportContent& content) {
  std::size_t read = 0;
  for (std::size_t i = 0; i < content.designs.size(); ++i) {
    const Evaluation& e = content.row(i).evaluation;
    DesignContent& design = content.designs[i];
    if (e.status != EvaluationStatus::ok || !std::isfinite(design.lambda)) continue;
    if (read++ >= most_histories && e.name != "baseline") continue;
    const auto repeats = content.study.repeats.find(e.name);
    const std::vector<Evaluation> one = {e};
    for (const Evaluation& run : repeats == content.study.repeats.end() ? one : repeats->second) {
      const DesignFiles files(content.study.directory, run.name);
      LoadSeries series = read_load_series(files.named(run.result, "history", "history.csv"), design.lambda,
                                           std::pow(design.lambda, 3));
      if (!series.load.empty()) design.histories.push_back(std::move(series));
    }
  }
}

Drift drift_between(const LoadSeries& series, double from, double to) {
  std::vector<double> counted;
  for (std::size_t i = 0; i < series.load.size(); ++i)
    if (series.advance[i] >= from && series.advance[i] <= to) counted.push_back(series.load[i]);
  return drift_of(counted);
}

// "is 12 % above the first (p = 0.01)" of one run, "is 12 ± 5 % above the first over 3 runs" of several;
// empty where there is none beyond chance.
std::string drift_in_words(const DesignContent& design, const Json& result) {
  std::vector<double> relative;
  double p = NAN;
  for (const LoadSeries& series : design.histories) {
    const Drift drift = drift_between(series, number_at(result, result_key::steady_from),
                                      number_at(result, result_key::steady_to));
    relative.push_back(drift.relative);
    p = drift.p;
  }
  const RepeatedMean all = repeated_mean(relative, std::vector<double>(relative.size(), NAN));
  const bool several = relative.size() > 1;
  const bool told = several ? std::fabs(all.mean) > all.repeats : p < told_apart_below;
  if (!told) return {};
  return "is " + fixed(100.0 * std::fabs(all.mean), 0) +
         (several ? "\u00a0\u00b1\u00a0" + fixed(100.0 * all.repeats, 0) : "") + "\u00a0% " +
         (all.mean > 0.0 ? "above" : "below") + " the first " +
         (several ? "over " + std::to_string(all.runs) + " runs" : "(" + p_in_words(p) + ")");
}

// Of the three leading designs and the baseline, before the records are thinned.
void look_for_drift(ReportContent& content) {
  for (std::size_t i = 0; i < content.designs.size(); ++i) {
    const RankedDesign& row = content.row(i);
    const bool leads = row.rank > 0 && (row.rank <= 3 || row.evaluation.name == "baseline");
    if (!leads || content.designs[i].histories.empty()) continue;
    const std::string words = drift_in_words(content.designs[i], row.evaluation.result);
    if (words.empty()) continue;
    content.study.drifts.push_back("The load of " + row.evaluation.name +
                                   " drifts: the second half of its steady part " + words +
                                   "; let it begin later (operation.steady_from_m).");
  }
}

// Lines plans and voyages as far as they fit, best first.
void fit_drawings(std::vector<DesignContent>& designs) {
  std::size_t bytes = 0;
  for (DesignContent& design : designs) {
    for (std::string* drawing : {&design.lines_plan, &design.voyage}) {
      bytes += drawing->size();
      if (bytes <= drawing_budget || drawing->empty()) continue;
      bytes -= drawing->size();
      drawing->clear();
      design.drawings_left_out = true;
    }
  }
}

// `most` of them, equally spaced, the last one kept.
std::vector<Picture> spread(const std::vector<Picture>& pictures, std::size_t most) {
  const std::size_t n = pictures.size();
  if (n <= most) return pictures;
  std::vector<Picture> kept;
  for (std::size_t k = 1; k <= most; ++k) kept.push_back(pictures[k * n / most - 1]);
  return kept;
}

std::uintmax_t bytes_with(const std::vector<DesignContent>& designs, std::size_t most) {
  std::uintmax_t bytes = 0;
  for (const DesignContent& design : designs)
    for (const Picture& picture : spread(design.pictures, most)) bytes += fs::file_size(picture.path);
  return bytes;
}

void fit_pictures(std::vector<DesignContent>& designs) {
  std::size_t most = 12;
  while (most > 1 && bytes_with(designs, most) > picture_budget) --most;
  for (DesignContent& design : designs) {
    const std::size_t before = design.pictures.size();
    design.pictures = spread(design.pictures, most);
    design.pictures_left_out = before - design.pictures.size();
  }
}

void thin_histories(std::vector<DesignContent>& designs) {
  std::size_t n = 0;
  for (const DesignContent& design : designs) n += design.histories.size();
  if (n == 0) return;
  const std::size_t most = std::clamp<std::size_t>(history_points / n, 400, 2000);
  for (DesignContent& design : designs)
    for (LoadSeries& series : design.histories) series = thinned(series, most);
}

// One scale for all bows, so that the small pictures compare.
void scale_bows(ReportContent& content) {
  double beam = 0.0;
  for (const DesignContent& design : content.designs) {
    if (design.waterline.size() < 2) continue;
    beam = std::max(beam, 2.0 * design.waterline.back()[1]);
    content.bow_length = std::max(content.bow_length, -design.waterline.back()[0]);
  }
  if (beam <= 0.0) return;
  content.bow_scale = plan_height_px / beam;
  content.bow_length = std::min(1.08 * content.bow_length, 2.2 * beam);
}

}  // namespace

bool ReportContent::has_loads() const {
  return std::any_of(study.ranking.rows.begin(), study.ranking.rows.end(),
                     [](const RankedDesign& r) { return std::isfinite(r.mean_load); });
}

bool ReportContent::has_simulated() const {
  return !study.confirmations.empty() ||
         std::any_of(study.ranking.rows.begin(), study.ranking.rows.end(), [](const RankedDesign& r) {
           return r.rank > 0 && part_at(r.evaluation.result, result_key::simulation).is_object();
         });
}

bool ReportContent::has_lindqvist() const {
  return std::any_of(study.ranking.rows.begin(), study.ranking.rows.end(),
                     [](const RankedDesign& r) { return std::isfinite(r.lindqvist); });
}

bool ReportContent::has_histories() const {
  return std::any_of(designs.begin(), designs.end(),
                     [](const DesignContent& d) { return !d.histories.empty(); });
}

ReportContent read_report_content(const std::string& study_directory) {
  ReportContent content;
  content.study = read_study_results(study_directory);
  content.unit = load_unit(content.study.ranking);
  for (std::size_t i = 0; i < content.study.ranking.rows.size(); ++i)
    content.designs.push_back(read_design(content.study, i));
  fit_drawings(content.designs);
  fit_pictures(content.designs);
  read_histories(content);
  look_for_drift(content);
  thin_histories(content.designs);
  scale_bows(content);
  content.conditions = conditions(content.study);
  content.verdict = verdict(content.study);
  return content;
}

}  // namespace icebow
