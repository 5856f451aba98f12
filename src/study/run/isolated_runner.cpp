#include <algorithm>
#include <cmath>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <future>
#include <iterator>
#include <thread>

#include "base/child_process.h"
#include "base/error_words.h"
#include "base/errors.h"
#include "study/evaluate/evaluation_key.h"
#include "study/evaluate/progress_json.h"
#include "study/run/failure.h"
#include "study/run/runner.h"
#include "study/store/design_files.h"

namespace icebow {
namespace {

using std::chrono::milliseconds;

constexpr milliseconds moment(100);
constexpr std::size_t formulas_at_once = 256;  // a fraction of a second, and one commit of the store
constexpr milliseconds grace(10000);           // mpirun wants about 3 s to clear its ranks

// One design under way.
struct Job {
  Design design;
  std::string directory;
  std::unique_ptr<ChildProcess> child;
  bool timed_out = false;
  int kills = 0;        // by others
  std::string trouble;  // of the machine, as the child has told it
};

std::string result_file(const Job& job) {
  return job.directory + "/evaluation.json";
}
std::string log_file(const Job& job) {
  return job.directory + "/log.txt";
}

int jobs_at_once(const RunnerContext& context) {
  if (context.settings.jobs > 0) return context.settings.jobs;
  const Execution& execution = context.spec.execution;
  if (execution.designs_at_once > 0) return execution.designs_at_once;
  const int cores = static_cast<int>(std::thread::hardware_concurrency());
  return std::max(1, cores / std::max(1, execution.ranks_per_design));
}

// Open MPI frames what a program says with rules and advice.
bool says_something(const std::string& line) {
  if (line.find_first_not_of("- \t\r*") == std::string::npos) return false;
  for (const char* advice :
       {"mpirun", "Primary job", "MPI_ABORT", "a non-zero exit code", "Per user-direction"}) {
    if (line.find(advice) != std::string::npos) return false;
  }
  return true;
}

// The last words of the program: what follows a signal is Open MPI's backtrace.
std::string last_line(const std::string& path) {
  std::ifstream file(path);
  std::string last;
  for (std::string line; std::getline(file, line);) {
    if (line.find("*** Process received signal") != std::string::npos) break;
    if (says_something(line)) last = line;
  }
  return last.size() > 300 ? last.substr(0, 300) + " ..." : last;
}

bool has_violated_margin(const std::vector<Margin>& margins) {
  return std::any_of(margins.begin(), margins.end(),
                     [](const Margin& m) { return m.required && !(m.value >= 0.0); });
}

// What stands before the program: the study's words, or mpirun where a design has several ranks.
std::vector<std::string> launcher(const Execution& execution) {
  const std::string ranks = std::to_string(execution.ranks_per_design), mark = "{ranks}";
  if (execution.launcher.empty() && execution.ranks_per_design > 1)
    return {"mpirun", "-n", ranks, "--oversubscribe", "--bind-to", "none"};
  std::vector<std::string> words = execution.launcher;
  for (std::string& word : words) {
    const std::size_t at = word.find(mark);
    if (at != std::string::npos) word.replace(at, mark.size(), ranks);
  }
  return words;
}

class IsolatedRunner : public Runner {
 public:
  explicit IsolatedRunner(const RunnerContext& context)
      : context_(context), at_once_(static_cast<std::size_t>(jobs_at_once(context))) {}

  int at_once() const override { return static_cast<int>(at_once_); }
  bool has_room() const override {
    return jobs_.size() + quick_.size() + done_.size() < at_once_ && formulas_.size() < formulas_at_once;
  }
  bool busy() const override {
    return !jobs_.empty() || !quick_.empty() || !done_.empty() || !formulas_.empty();
  }
  void start(const PlannedDesign& planned) override;
  std::vector<Evaluation> wait() override;
  void stop() override;

 private:
  bool is_infeasible(const Design& design) const;
  bool is_quick(const Design& design) const;
  Evaluation evaluated_here(const Design& design, const std::string& directory) const;
  void take_quick(std::vector<Evaluation>& ended);
  void take_formulas(std::vector<Evaluation>& ended);
  std::vector<std::string> command(const Job& job) const;
  void launch(Job& job) const;
  bool launched_again(Job& job) const;
  void listen(Job& job);
  Evaluation result_of(const Job& job) const;
  Evaluation lost(const Job& job) const;

  RunnerContext context_;
  std::size_t at_once_;
  std::vector<Job> jobs_;
  std::vector<std::future<Evaluation>> quick_;  // designs without a simulation, in threads of this process
  std::vector<Design> formulas_;                // of the formula alone: evaluated by wait(), many at a time
  std::vector<Evaluation> done_;
};

bool IsolatedRunner::is_infeasible(const Design& design) const {
  return has_violated_margin(context_.settings.margins(design.given.value()));
}

// The cycle takes a second, and a program is a process already: another one would cost as much again.
bool IsolatedRunner::is_quick(const Design& design) const {
  return !design.asked.peridynamics && !design.asked.formula_alone();
}

Evaluation IsolatedRunner::evaluated_here(const Design& design, const std::string& directory) const {
  EvaluateOptions options;
  options.directory = directory;
  return context_.settings.evaluate(Communicator::serial(), design, options);
}

void IsolatedRunner::take_quick(std::vector<Evaluation>& ended) {
  for (auto quick = quick_.begin(); quick != quick_.end();) {
    if (quick->wait_for(milliseconds(0)) != std::future_status::ready) {
      ++quick;
      continue;
    }
    std::future<Evaluation> over = std::move(*quick);  // where get() throws, none is left to be waited for
    quick = quick_.erase(quick);
    ended.push_back(over.get());
  }
}

// In as many threads as designs run at once; each takes every n-th design.
void IsolatedRunner::take_formulas(std::vector<Evaluation>& ended) {
  const std::size_t threads = std::min(at_once_, formulas_.size());
  std::vector<Evaluation> results(formulas_.size());
  std::vector<std::future<void>> shares;
  for (std::size_t first = 0; first < threads; ++first)
    shares.push_back(std::async(std::launch::async, [this, &results, first, threads] {
      for (std::size_t i = first; i < formulas_.size(); i += threads)
        results[i] = evaluated_here(formulas_[i], "");
    }));
  for (const std::future<void>& share : shares) share.wait();
  for (std::future<void>& share : shares) share.get();
  std::move(results.begin(), results.end(), std::back_inserter(ended));
  formulas_.clear();
}

// An impossible bow needs no process: evaluate() says so before there is a mesh, let alone a simulation.
void IsolatedRunner::start(const PlannedDesign& planned) {
  if (planned.design.asked.formula_alone()) {
    formulas_.push_back(planned.design);
    return;
  }
  Job job;
  job.design = planned.design;
  job.directory = design_directory(context_.settings.directory, planned.design.name);
  if (is_infeasible(job.design)) {
    done_.push_back(evaluated_here(job.design, job.directory));
    return;
  }
  if (is_quick(job.design)) {
    quick_.push_back(std::async(std::launch::async, [this, design = job.design, directory = job.directory] {
      return evaluated_here(design, directory);
    }));
    return;
  }
  write_text_file(job.directory + "/design.json", json_text(to_json(job.design), 2) + "\n");
  launch(job);
  jobs_.push_back(std::move(job));
}

void IsolatedRunner::launch(Job& job) const {
  ChildCommand child;
  child.arguments = command(job);
  child.environment = child_environment();
  child.log = log_file(job);
  // A simulation writes its checkpoint on SIGTERM, which the next run of the study must not meet.
  if (context_.spec.execution.ranks_per_design <= 1) child.when_we_die = SIGKILL;
  job.child = std::make_unique<ChildProcess>(child);
}

// A process that somebody kills, the kernel where memory runs out for one, is no failure of its design: it
// goes on from its checkpoint, once. Then the machine has to be seen to.
bool IsolatedRunner::launched_again(Job& job) const {
  const int signal = job.child->killed_by();
  const bool from_outside = signal == SIGKILL || signal == SIGTERM || signal == SIGINT || signal == SIGHUP;
  if (job.timed_out || !from_outside || std::filesystem::exists(result_file(job))) return false;
  if (++job.kills > 1)
    throw RuntimeError(
        job.design.name + ": its process was " + job.child->complaint() +
        " twice, by somebody or for want of memory; the same command goes on with it, with --jobs 1 "
        "it has the memory for itself");
  launch(job);
  return true;
}

std::vector<std::string> IsolatedRunner::command(const Job& job) const {
  std::vector<std::string> words = launcher(context_.spec.execution);
  for (const std::string& word :
       {context_.settings.program, std::string("evaluate-design"), std::string("--design-json"),
        job.directory + "/design.json", std::string("--out"), job.directory, std::string("--result"),
        result_file(job)}) {
    words.push_back(word);
  }
  return words;
}

// Progress is a line of JSON; whatever else a library prints there is kept with the log.
void IsolatedRunner::listen(Job& job) {
  for (const std::string& line : job.child->read_lines()) {
    if (const auto progress = progress_from_line(line)) {
      context_.on_progress(job.design.name, *progress);
    } else if (const auto trouble = trouble_from_line(line)) {
      job.trouble = *trouble;
    } else {
      std::ofstream(log_file(job), std::ios::app) << line << "\n";
    }
  }
}

std::vector<Evaluation> IsolatedRunner::wait() {
  std::vector<const ChildProcess*> children;
  for (const Job& job : jobs_) children.push_back(job.child.get());
  const bool nothing_yet = done_.empty() && formulas_.empty();
  if (nothing_yet && !quick_.empty() && jobs_.empty()) {
    quick_.front().wait_for(moment);
  } else if (nothing_yet) {
    wait_for_output(children, moment);
  }
  std::vector<Evaluation> ended = std::move(done_);
  done_.clear();
  take_quick(ended);
  take_formulas(ended);
  const double limit = context_.spec.execution.time_limit_s;
  for (auto job = jobs_.begin(); job != jobs_.end();) {
    const bool running = job->child->running();
    listen(*job);
    if (!running && !launched_again(*job)) {
      ended.push_back(result_of(*job));
      job = jobs_.erase(job);
      continue;
    }
    job->timed_out = job->timed_out || (limit > 0.0 && job->child->seconds() > limit);
    if (job->timed_out) job->child->terminate(grace);
    ++job;
  }
  return ended;
}

void IsolatedRunner::stop() {
  for (Job& job : jobs_) job.child->terminate(grace);
  const auto any_running = [&] {
    bool any = false;
    for (Job& job : jobs_) any = job.child->running() || any;
    return any;
  };
  while (any_running()) std::this_thread::sleep_for(milliseconds(20));
  for (std::future<Evaluation>& quick : quick_) quick.wait();
  quick_.clear();
  formulas_.clear();
  jobs_.clear();
  done_.clear();
}

// A result that was written counts, even where the program stumbled afterwards.
Evaluation IsolatedRunner::result_of(const Job& job) const {
  const std::string path = result_file(job);
  if (!std::filesystem::exists(path)) return lost(job);
  Evaluation e;
  try {
    e = evaluation_from_json(read_json_file(path));
  } catch (const std::exception& error) {
    throw RuntimeError(path + " cannot be read: " + in_words(error) +
                       "; the same command evaluates the design again");
  }
  std::filesystem::remove(path);
  std::error_code ignored;
  if (std::filesystem::is_empty(log_file(job), ignored)) std::filesystem::remove(log_file(job), ignored);
  return e;
}

Evaluation IsolatedRunner::lost(const Job& job) const {
  const bool machine = !job.trouble.empty() || job.child->exit_code() == machine_trouble_code;
  if (machine && !job.timed_out)
    throw RuntimeError(job.design.name + ": " +
                       (job.trouble.empty() ? last_line(log_file(job)) : job.trouble) +
                       "; nothing is lost, the same command goes on");
  Evaluation e;
  e.name = job.design.name;
  e.status = EvaluationStatus::failed;
  e.wall_seconds = job.child->seconds();
  const std::string complaint = job.child->complaint(), said = last_line(log_file(job));
  e.reason = job.timed_out       ? time_limit_reason(context_.spec.execution.time_limit_s)
             : complaint.empty() ? "the program ended without a result"
                                 : "the program was lost: " + complaint;
  if (!said.empty() && !job.timed_out) e.reason += ": " + said;
  e.result = {{"log", "log.txt"}};
  e.result["failure"] =
      job.timed_out ? time_limit_failure(context_.spec.execution.time_limit_s) : crash_failure();
  return e;
}

}  // namespace

std::unique_ptr<Runner> make_isolated_runner(const RunnerContext& context) {
  return std::make_unique<IsolatedRunner>(context);
}

}  // namespace icebow
