// Rank 0 writes to the first rank of a group: {"evaluate": design, "directory": ...}, {"stop": true} or the
// end of the study (together.h). It is answered by {"design": name, "progress": line}, {"evaluation": ...} or
// {"error": message}.
#include "study/run/grouped_runner.h"

#include <algorithm>
#include <chrono>
#include <thread>

#include "base/errors.h"
#include "base/mailbox.h"
#include "study/evaluate/progress_json.h"
#include "study/run/together.h"
#include "study/store/design_files.h"

namespace icebow {
namespace {

using Clock = std::chrono::steady_clock;
using std::chrono::milliseconds;

constexpr milliseconds moment(100);  // the driver's wait for news
constexpr milliseconds nap(2);       // between two looks into the mailbox

int first_rank(int group, int ranks_of_group) {
  return 1 + group * ranks_of_group;
}

class GroupedRunner : public Runner {
 public:
  GroupedRunner(const Communicator& comm, int groups, const RunnerContext& context)
      : mailbox_(comm), context_(context), groups_(static_cast<std::size_t>(groups)) {}

  int at_once() const override { return static_cast<int>(groups_.size()); }
  bool has_room() const override {
    return std::any_of(groups_.begin(), groups_.end(), [](const Group& g) { return !g.busy; });
  }
  bool busy() const override {
    return std::any_of(groups_.begin(), groups_.end(), [](const Group& g) { return g.busy; });
  }
  void start(const PlannedDesign& planned) override;
  std::vector<Evaluation> wait() override;
  void stop() override;

 private:
  struct Group {
    bool busy = false, told_to_stop = false, timed_out = false;
    std::string design;
    Clock::time_point since;
  };
  int rank_of(std::size_t group) const {
    return first_rank(static_cast<int>(group), context_.spec.execution.ranks_per_design);
  }
  void tell_to_stop(std::size_t group);
  void watch_time();
  void read(const Mail& mail, std::vector<Evaluation>& ended);

  Mailbox mailbox_;
  RunnerContext context_;
  std::vector<Group> groups_;
};

void GroupedRunner::start(const PlannedDesign& planned) {
  const auto idle = std::find_if(groups_.begin(), groups_.end(), [](const Group& g) { return !g.busy; });
  *idle = Group{true, false, false, planned.design.name, Clock::now()};
  const std::string directory = planned.design.asked.formula_alone()
                                    ? std::string()
                                    : design_directory(context_.settings.directory, planned.design.name);
  mailbox_.send(rank_of(static_cast<std::size_t>(idle - groups_.begin())),
                json_text({{"evaluate", to_json(planned.design)}, {"directory", directory}}));
}

void GroupedRunner::tell_to_stop(std::size_t group) {
  if (!groups_[group].busy || groups_[group].told_to_stop) return;
  groups_[group].told_to_stop = true;
  mailbox_.send(rank_of(group), json_text({{"stop", true}}));
}

void GroupedRunner::watch_time() {
  const double limit = context_.spec.execution.time_limit_s;
  for (std::size_t g = 0; limit > 0.0 && g < groups_.size(); ++g) {
    const double seconds = std::chrono::duration<double>(Clock::now() - groups_[g].since).count();
    if (!groups_[g].busy || seconds <= limit) continue;
    groups_[g].timed_out = true;
    tell_to_stop(g);
  }
}

void GroupedRunner::read(const Mail& mail, std::vector<Evaluation>& ended) {
  const Json news = Json::parse(mail.text);
  if (news.contains("progress")) {
    const auto progress = progress_from_line(news.at("progress").get<std::string>());
    if (progress) context_.on_progress(news.at("design").get<std::string>(), *progress);
    return;
  }
  Group& group =
      groups_[static_cast<std::size_t>((mail.from - 1) / context_.spec.execution.ranks_per_design)];
  group.busy = false;
  if (news.contains("error")) throw RuntimeError(news.at("error").get<std::string>());
  Evaluation e = evaluation_from_json(news.at("evaluation"));
  if (group.timed_out) fail_by_time_limit(e, context_.spec.execution.time_limit_s);
  ended.push_back(std::move(e));
}

std::vector<Evaluation> GroupedRunner::wait() {
  std::vector<Evaluation> ended;
  const auto until = Clock::now() + moment;
  while (busy() && ended.empty() && Clock::now() < until) {
    if (const auto mail = mailbox_.take()) {
      read(*mail, ended);
      continue;
    }
    watch_time();
    std::this_thread::sleep_for(nap);
  }
  return ended;
}

// What they still have to say is read, so that the next order finds them waiting.
void GroupedRunner::stop() {
  for (std::size_t g = 0; g < groups_.size(); ++g) tell_to_stop(g);
  std::vector<Evaluation> dropped;
  while (busy()) {
    try {
      if (const auto mail = mailbox_.take()) read(*mail, dropped);
    } catch (const RuntimeError&) {  // the study ends anyway, for the reason it has
    }
    std::this_thread::sleep_for(nap);
  }
}

void tell_all(const Communicator& comm, const Json& order) {
  const Mailbox mailbox(comm);
  for (int rank = 1; rank < comm.size(); ++rank) mailbox.send(rank, json_text(order));
}

// On the first rank of a group: the next order that is no late word to stop.
std::string next_order(const Mailbox& mailbox) {
  for (;;) {
    const auto mail = mailbox.take();
    if (mail && !Json::parse(mail->text).contains("stop")) return mail->text;
    if (!mail) std::this_thread::sleep_for(nap);
  }
}

void evaluate_order(const Communicator& group, const Mailbox& driver, const Json& order,
                    const EvaluateFunction& evaluate) {
  EvaluateOptions options;
  options.directory = order.at("directory").get<std::string>();
  options.keep_checkpoint = true;  // until the driver has stored the result
  const Design design = design_from_json(order.at("evaluate"));
  bool stopped = false;
  if (group.is_root()) {
    options.on_progress = [&](const Progress& p) {
      driver.send(0, json_text({{"design", design.name}, {"progress", progress_line(p)}}));
    };
    options.stop = [&] { return stopped = stopped || driver.take().has_value(); };
  }
  Json answer;
  try {
    answer["evaluation"] = to_json(evaluate_together(group, evaluate, design, options));
  } catch (const RuntimeError& error) {
    answer = {{"error", error.what()}};
  }
  if (group.is_root()) driver.send(0, json_text(answer));
}

}  // namespace

int groups_of(const Communicator& comm, const Execution& execution, const RunSettings& settings) {
  const int wanted = settings.jobs > 0 ? settings.jobs : execution.designs_at_once;
  if (settings.launcher == Launcher::isolated || comm.size() == 1 || wanted < 2) return 0;
  const int room = (comm.size() - 1) / execution.ranks_per_design;
  if (room < 1)
    throw InputError(
        "this job has " + std::to_string(comm.size()) + " ranks: designs side by side, of " +
        std::to_string(execution.ranks_per_design) + " ranks each (execution.ranks_per_design), need " +
        std::to_string(1 + 2 * execution.ranks_per_design) + " for two, one of them for the driver");
  return std::min(wanted, room);
}

std::unique_ptr<Runner> make_grouped_runner(const Communicator& comm, int groups,
                                            const RunnerContext& context) {
  return std::make_unique<GroupedRunner>(comm, groups, context);
}

void end_groups(const Communicator& comm, const StudyOutcome& outcome) {
  tell_all(comm, end_order(outcome));
}

void fail_groups(const Communicator& comm, const std::exception& error) {
  tell_all(comm, error_order(error));
}

Communicator split_into_groups(const Communicator& comm, int groups, int ranks_of_group) {
  if (comm.is_root()) return comm.split(0);
  return comm.split(1 + std::min((comm.rank() - 1) / ranks_of_group, groups));
}

// The end comes to each rank by itself, so that ranks of a group and those left over are told alike.
StudyOutcome serve_group(const Communicator& comm, const Communicator& group, int groups, int ranks_of_group,
                         const EvaluateFunction& evaluate) {
  const int mine = (comm.rank() - 1) / ranks_of_group;
  const Mailbox mailbox(comm);
  for (;;) {
    const bool first = mine < groups && group.is_root();
    const std::string text =
        mine >= groups ? next_order(mailbox) : group.broadcast(first ? next_order(mailbox) : "");
    const Json order = Json::parse(text);
    if (!is_end(order)) {
      evaluate_order(group, mailbox, order, evaluate);
      continue;
    }
    if (mine < groups && !first) next_order(mailbox);  // its own copy
    return take_end(order);
  }
}

}  // namespace icebow
