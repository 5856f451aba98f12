// Everything the page shows, read and thinned, before any of it becomes HTML.
#pragma once

#include <string>
#include <vector>

#include "reports/content/conditions.h"
#include "reports/content/history_file.h"
#include "reports/content/hull_outline.h"
#include "reports/content/load_unit.h"
#include "reports/content/study_results.h"
#include "reports/content/verdict.h"

namespace icebow {

struct Picture {
  std::string path;
  double advance = 0.0;  //!< model scale [m]; NaN where unknown
};

// The files of one design; whatever is missing is empty.
struct DesignContent {
  std::string id;       // anchor in the page: "design-3"
  double lambda = 0.0;  // NaN where unknown
  std::vector<Vec3> waterline;
  std::string lines_plan;  // <svg> with ids of its own
  std::string voyage;      // <svg> of the breaking cycle; of the first ranks only
  std::vector<Picture> pictures;
  std::string animation;  // a file; empty: none, or not among the first ranks
  std::size_t pictures_left_out = 0;
  bool drawings_left_out = false;     // lines plan and voyage, to keep the page small
  std::vector<LoadSeries> histories;  // full scale, one a run
};

struct ReportContent {
  StudyResults study;
  LoadUnit unit;
  std::vector<DesignContent> designs;        // as study.ranking.rows
  double bow_length = 0.0, bow_scale = 1.0;  // of the small plan views: metres shown, pixels per metre
  Conditions conditions;
  Verdict verdict;

  const RankedDesign& row(std::size_t i) const { return study.ranking.rows[i]; }
  bool has_loads() const;      // a mean load by simulation or breaking cycle, for one design at least
  bool has_simulated() const;  // by simulation
  bool has_lindqvist() const;
  bool has_histories() const;
};

ReportContent read_report_content(const std::string& study_directory);

}  // namespace icebow
