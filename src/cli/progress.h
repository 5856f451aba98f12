// What a running study says on stderr: bars on a terminal, a plain line every few seconds elsewhere.
#pragma once

#include <chrono>
#include <cstdio>
#include <map>
#include <string>
#include <vector>

#include "study/run/run_study.h"

namespace icebow {

// How far a study is, without a word about how it is shown. Times in seconds since it began.
class ProgressState {
 public:
  struct Running {
    double began = 0.0;  //!< [s]
    Progress progress;
    double fraction() const;
  };

  void planned(int designs, int proposals);
  void started(const std::string& design, double now);
  void progressed(const std::string& design, const Progress& progress);
  void finished(const std::string& design, bool recalled);

  int total() const { return planned_; }
  // "12", or "61 at most" while an optimiser may propose more.
  std::string total_words() const;
  int done() const { return done_; }
  const std::map<std::string, Running>& running() const { return running_; }
  double fraction() const;  // of the study, running designs in part
  // Time still to go by what was computed so far, recalled designs left out; NaN where nothing is known.
  double eta(double now) const;
  static double eta(const Running& running, double now);

 private:
  int planned_ = 0, proposals_ = 0, done_ = 0, recalled_ = 0;
  std::map<std::string, Running> running_;  // by design
};

class ProgressDisplay : public StudyObserver {
 public:
  enum class Mode { bars, lines };
  explicit ProgressDisplay(std::FILE* stream = stderr);
  ProgressDisplay(std::FILE* stream, Mode mode, bool colour);
  ~ProgressDisplay() override;

  void on_planned(const StudyPlan& plan) override;
  void on_started(const Design& design) override;
  void on_progress(const std::string& design, const Progress& progress) override;
  void on_finished(const Evaluation& evaluation, bool recalled) override;
  void on_waiting(const std::string& words) override { announce(words); }
  void on_leg(const RaceRecord& record) override;
  void on_study_finished(const StudyOutcome& outcome) override;
  void announce(const std::string& line);  // scrolls by above the bars

 private:
  double now() const;
  void update(bool at_once);
  void draw_bars();
  void erase_bars();
  void print_line();
  std::string bar_line(const std::string& label, double fraction, const std::string& tail) const;
  std::string only_run_line(const ProgressState::Running& run) const;
  std::string coloured(const std::string& text, const char* code) const;

  std::FILE* stream_;
  Mode mode_;
  bool colour_;
  ProgressState state_;
  std::chrono::steady_clock::time_point begin_;
  double drawn_at_ = -1e9;  //!< [s]
  int drawn_lines_ = 0;
};

}  // namespace icebow
