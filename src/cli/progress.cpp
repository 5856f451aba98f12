#include "cli/progress.h"

#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "cli/text_table.h"
#include "study/evaluate/result_keys.h"

namespace icebow {
namespace {

constexpr double bars_interval = 1.0 / 8, lines_interval = 5.0;  //!< [s]
constexpr int bar_width = 24, short_bar_width = 8, label_width = 18;

bool is_set(const char* variable) {
  const char* value = std::getenv(variable);
  return value && *value;
}

bool understands_escapes(std::FILE* stream) {
  const char* term = std::getenv("TERM");
  return ::isatty(::fileno(stream)) && term && *term && std::string(term) != "dumb";
}

int terminal_width(std::FILE* stream) {
  struct winsize size = {};
  if (::ioctl(::fileno(stream), TIOCGWINSZ, &size) == 0 && size.ws_col > 20) return size.ws_col;
  return 80;
}

std::string label(const std::string& name) {
  const std::string text = cut(name, label_width);
  return text + std::string(static_cast<std::size_t>(label_width - columns(text)), ' ');
}

std::string percent(double fraction) {
  return decimals(std::floor(100.0 * fraction), 0) + " %";
}

std::string bar(double fraction, int width) {
  const int full = static_cast<int>(std::lround(fraction * width));
  return "[" + std::string(static_cast<std::size_t>(full), '#') +
         std::string(static_cast<std::size_t>(width - full), '-') + "] " + percent(fraction);
}

std::string first_line(const std::string& text) {
  return text.substr(0, text.find('\n'));
}

// Step, speed, load and energy of one run, for people who watch it.
std::string run_words(const Progress& p) {
  std::string words = std::to_string(p.step) + "/" + std::to_string(p.steps) + "  " +
                      decimals(p.ns_per_bond, 3) + " ns/bond  " + decimals(p.load, 1) + " N";
  if (p.hull_work > 0.0) {
    words += "  " + decimals(p.hull_work, 1) + " J " + (p.balance_error < 0.0 ? "-" : "+") +
             decimals(100.0 * std::abs(p.balance_error) / p.hull_work, 1) + " %";
  }
  return words;
}

// What there is to say of a finished design in one line.
std::string result_words(const Evaluation& e) {
  std::string words = to_string(e.status);
  const Json::json_pointer load(result_key::mean_load), formula(result_key::lindqvist_breaking);
  for (const auto& [pointer, name] :
       {std::pair{load, "mean load"}, std::pair{formula, "Lindqvist breaking"}}) {
    if (e.status != EvaluationStatus::ok || !e.result.contains(pointer) || !e.result.at(pointer).is_number())
      continue;
    words += std::string(", ") + name + " " + decimals(e.result.at(pointer).get<double>() / 1e3, 1) + " kN";
  }
  if (!e.reason.empty()) words += ": " + first_line(e.reason);
  return words;
}

}  // namespace

ProgressDisplay::ProgressDisplay(std::FILE* stream)
    : ProgressDisplay(stream, understands_escapes(stream) ? Mode::bars : Mode::lines,
                      understands_escapes(stream) && !is_set("NO_COLOR")) {}

ProgressDisplay::ProgressDisplay(std::FILE* stream, Mode mode, bool colour)
    : stream_(stream), mode_(mode), colour_(colour), begin_(std::chrono::steady_clock::now()) {}

ProgressDisplay::~ProgressDisplay() {
  erase_bars();
}

double ProgressDisplay::now() const {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin_).count();
}

void ProgressDisplay::on_planned(const StudyPlan& plan) {
  state_.planned(static_cast<int>(plan.designs.size()), plan.proposals);
}

void ProgressDisplay::on_started(const Design& design) {
  state_.started(design.name, now());
  update(true);
}

void ProgressDisplay::on_progress(const std::string& design, const Progress& progress) {
  state_.progressed(design, progress);
  update(false);
}

void ProgressDisplay::on_finished(const Evaluation& e, bool recalled) {
  state_.finished(e.name, recalled);
  const std::string count = "[" + std::to_string(state_.done()) + "/" + state_.total_words() + "] ";
  const bool ok = e.status == EvaluationStatus::ok, failed = e.status == EvaluationStatus::failed;
  const std::string words = coloured(result_words(e), ok ? "32" : failed ? "31" : "33");
  announce(count + e.name + "  " + words + (recalled ? "  (stored)" : "  " + clock_time(e.wall_seconds)));
}

void ProgressDisplay::on_leg(const RaceRecord& record) {
  announce("race: " + race_in_words(record));
}

void ProgressDisplay::on_study_finished(const StudyOutcome&) {
  erase_bars();
}

void ProgressDisplay::announce(const std::string& line) {
  erase_bars();
  std::fprintf(stream_, "%s\n", line.c_str());
  std::fflush(stream_);
  if (mode_ == Mode::bars) update(true);
}

void ProgressDisplay::update(bool at_once) {
  const double interval = mode_ == Mode::bars ? bars_interval : lines_interval, t = now();
  if (mode_ == Mode::lines && drawn_at_ < 0.0) drawn_at_ = t;  // the first line after one interval
  if (t - drawn_at_ < interval && !(at_once && mode_ == Mode::bars)) return;
  drawn_at_ = t;
  mode_ == Mode::bars ? draw_bars() : print_line();
  std::fflush(stream_);
}

std::string ProgressDisplay::coloured(const std::string& text, const char* code) const {
  return colour_ ? std::string("\033[") + code + "m" + text + "\033[0m" : text;
}

std::string ProgressDisplay::bar_line(const std::string& name, double fraction,
                                      const std::string& tail) const {
  return label(name) + " " + bar(fraction, bar_width) + "  " + tail;
}

// A run on its own: its name is known, and 80 columns are to hold what there is to say of it.
std::string ProgressDisplay::only_run_line(const ProgressState::Running& run) const {
  return bar(run.fraction(), short_bar_width) + "  eta " + clock_time(ProgressState::eta(run, now())) + "  " +
         run_words(run.progress);
}

void ProgressDisplay::draw_bars() {
  erase_bars();
  std::vector<std::string> lines;
  for (const auto& [name, running] : state_.running()) {
    if (state_.total() == 1) {
      lines.push_back(only_run_line(running));
      continue;
    }
    lines.push_back(bar_line(name, running.fraction(),
                             "eta " + clock_time(ProgressState::eta(running, now())) + "  " +
                                 decimals(running.progress.advance, 2) + " m  " +
                                 decimals(running.progress.load, 1) + " N (model)"));
  }
  if (state_.total() > 1) {
    const std::string count = std::to_string(state_.done()) + "/" + state_.total_words() + " designs";
    lines.push_back(
        bar_line("study", state_.fraction(), "eta " + clock_time(state_.eta(now())) + "  " + count));
  }
  const int width = terminal_width(stream_) - 1;
  for (const std::string& line : lines) std::fprintf(stream_, "%s\n", cut(line, width).c_str());
  drawn_lines_ = static_cast<int>(lines.size());
}

void ProgressDisplay::erase_bars() {
  if (drawn_lines_ > 0) std::fprintf(stream_, "\033[%dA\033[J", drawn_lines_);
  drawn_lines_ = 0;
}

void ProgressDisplay::print_line() {
  if (state_.total() == 1 && state_.running().size() == 1) {
    const auto& [name, running] = *state_.running().begin();
    std::fprintf(stream_, "%s %s (%s m)  eta %s  %s\n", name.c_str(), percent(running.fraction()).c_str(),
                 decimals(running.progress.advance, 2).c_str(),
                 clock_time(ProgressState::eta(running, now())).c_str(), run_words(running.progress).c_str());
    return;
  }
  std::string text = std::to_string(state_.done()) + "/" + state_.total_words() + " designs";
  for (const auto& [name, running] : state_.running()) {
    text += ", " + name + " " + percent(running.fraction()) + " (" + decimals(running.progress.advance, 2) +
            " m)";
  }
  std::fprintf(stream_, "%s, eta %s\n", text.c_str(), clock_time(state_.eta(now())).c_str());
}

}  // namespace icebow
