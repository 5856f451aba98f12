#include <algorithm>
#include <limits>

#include "cli/progress.h"

namespace icebow {

double ProgressState::Running::fraction() const {
  if (progress.steps <= 0) return 0.0;
  return std::min(1.0, static_cast<double>(progress.step) / static_cast<double>(progress.steps));
}

void ProgressState::planned(int designs, int proposals) {
  planned_ = designs;
  proposals_ = proposals;
}

void ProgressState::started(const std::string& design, double now) {
  running_[design].began = now;
}

void ProgressState::progressed(const std::string& design, const Progress& progress) {
  running_[design].progress = progress;
}

// A design that nobody planned is one an optimiser has proposed.
void ProgressState::finished(const std::string& design, bool recalled) {
  running_.erase(design);
  ++done_;
  recalled_ += recalled ? 1 : 0;
  if (done_ > planned_) {
    ++planned_;
    proposals_ = std::max(0, proposals_ - 1);
  }
}

std::string ProgressState::total_words() const {
  return std::to_string(planned_ + proposals_) + (proposals_ > 0 ? " at most" : "");
}

double ProgressState::fraction() const {
  const int total = planned_ + proposals_;
  double done = done_;
  for (const auto& [name, running] : running_) done += running.fraction();
  return total > 0 ? std::min(1.0, done / total) : 0.0;
}

double ProgressState::eta(double now) const {
  double computed = done_ - recalled_;
  for (const auto& [name, running] : running_) computed += running.fraction();
  const double left = planned_ + proposals_ - recalled_ - computed;
  return computed > 0.0 ? now * left / computed : std::numeric_limits<double>::quiet_NaN();
}

double ProgressState::eta(const Running& running, double now) {
  const double f = running.fraction();
  return f > 0.0 ? (now - running.began) * (1.0 - f) / f : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace icebow
