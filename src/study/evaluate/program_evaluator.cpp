#include "study/evaluate/program_evaluator.h"

#include <chrono>
#include <csignal>
#include <filesystem>
#include <map>
#include <mutex>

#include "base/child_process.h"
#include "base/errors.h"
#include "base/printable.h"
#include "base/sha256.h"
#include "base/text.h"
#include "base/units.h"
#include "hullgen/bow/family.h"
#include "study/evaluate/evaluation.h"

namespace icebow {
namespace {

namespace fs = std::filesystem;
using std::chrono::milliseconds;

constexpr milliseconds moment(50), grace(3000);
constexpr std::size_t most_bytes = std::size_t{1}
                                   << 24;  // of what a program may print, and say on its stderr

struct Digested {
  fs::file_time_type written;
  std::uintmax_t size = 0;
  std::string sha256;
};

// Of a file's bytes; empty where there is none. A study asks once for each design.
std::string digest_of_file(const std::string& path) {
  static std::mutex mutex;
  static std::map<std::string, Digested> known;
  std::error_code none;
  if (!fs::is_regular_file(path, none)) return "";
  const std::lock_guard<std::mutex> one_at_a_time(mutex);
  Digested& file = known[path];
  const auto written = fs::last_write_time(path, none);
  const auto size = fs::file_size(path, none);
  if (file.sha256.empty() || file.written != written || file.size != size)
    file = {written, size, sha256(read_text_file(path))};
  return file.sha256;
}

ProgramOutcome failed(const std::string& reason) {
  ProgramOutcome outcome;
  outcome.reason = reason;
  return outcome;
}

bool holds_number(const Json& part) {
  if (part.is_number()) return true;
  if (!part.is_object()) return false;
  for (const auto& item : part.items())
    if (holds_number(item.value())) return true;
  return false;
}

ProgramOutcome outcome_of(const std::string& printed) {
  ProgramOutcome outcome;
  Json output;
  try {
    output = parse_json(printed, "its output");
  } catch (const InputError& error) {
    const Mistake& first = error.mistakes().front();
    return failed("printed no JSON: " + first.pointer + ": " + shortened(printable(first.message), 200));
  }
  if (!output.is_object()) return failed("printed no object but " + shortened(output.dump(), 80));
  if (output.contains("infeasible") && output.at("infeasible").is_string()) {
    outcome.infeasible = true;
    outcome.reason = shortened(printable(output.at("infeasible").get<std::string>()), 300);
    return outcome;
  }
  if (!holds_number(output)) return failed("printed an object without a number");
  outcome.output = std::move(output);
  return outcome;
}

// The last line of what it said on stderr.
std::string last_words(const std::string& log) {
  std::string text;
  try {
    text = read_text_file(log, most_bytes);
  } catch (const InputError&) {
    return "";
  }
  while (!text.empty() && (text.back() == '\n' || text.back() == '\r')) text.pop_back();
  const std::string last = shortened(printable(text.substr(text.rfind('\n') + 1)), 300);
  return last.empty() ? "" : ": " + last;
}

struct Run {
  std::string printed;
  bool timed_out = false, interrupted = false, flooded = false;
};

std::uintmax_t size_of_log(const std::string& log) {
  std::error_code none;
  const std::uintmax_t size = fs::is_regular_file(log, none) ? fs::file_size(log, none) : 0;
  return none ? 0 : size;
}

// Until the program has ended, by itself or by us.
Run listened_to(ChildProcess& child, const std::string& log, double time_limit,
                const std::function<bool()>& stop) {
  Run run;
  for (bool running = true; running;) {
    wait_for_output({&child}, moment);
    running = child.running();
    for (const std::string& line : child.read_lines())
      if (run.printed.size() <= most_bytes) run.printed += line + "\n";
    run.timed_out = run.timed_out || (running && time_limit > 0.0 && child.seconds() > time_limit);
    run.interrupted = run.interrupted || (running && stop && stop());
    run.flooded = run.flooded || size_of_log(log) > most_bytes;
    if (run.timed_out || run.interrupted || run.flooded || run.printed.size() > most_bytes)
      child.terminate(grace);
  }
  std::error_code ignored;
  if (run.flooded) fs::resize_file(log, most_bytes, ignored);
  return run;
}

ProgramOutcome judged(const Run& run, const ChildProcess& child, double time_limit, const std::string& log) {
  if (run.printed.size() > most_bytes) return failed("printed more than 16 MB");
  if (run.flooded) return failed("wrote more than 16 MB to its stderr");
  if (run.timed_out) {
    ProgramOutcome outcome = failed(text("took longer than its time limit of %g s", time_limit));
    outcome.timed_out = true;
    return outcome;
  }
  if (child.killed_by() != 0) return failed("was " + child.complaint() + last_words(log));
  if (!child.complaint().empty()) return failed("ended with " + child.complaint() + last_words(log));
  return outcome_of(run.printed);
}

}  // namespace

Json program_input(const Case& c, const std::string& design) {
  const BowAngles& a = c.bow.angles;
  return {{"icebow_evaluator", 1},
          {"design", design},
          {"ship",
           {{"family", c.own.given() ? Json(nullptr) : Json(family_form(c.bow.family).key)},
            {"length_m", c.bow.L},
            {"beam_m", c.bow.B},
            {"draft_m", c.bow.T},
            {"depth_m", c.bow.D},
            {"bow_length_m", c.bow.Lf},
            {"stem_deg", degrees(a.stem)},
            {"waterline_deg", degrees(a.waterline)},
            {"buttock_deg", degrees(a.buttock)},
            {"flare_deg", degrees(a.flare)}}},
          {"ice",
           {{"thickness_m", c.ice.h},
            {"density_kg_m3", c.ice.rho},
            {"elastic_modulus_Pa", c.ice.E},
            {"poisson", c.ice.nu},
            {"flexural_strength_Pa", c.flexural_strength},
            {"friction", c.numerics.friction}}},
          {"water", {{"density_kg_m3", c.water.rho}}},
          {"speed_m_s", c.V},
          {"hull_file", "hull.obj"}};
}

ProgramOutcome run_program(const ProgramEvaluator& program, const Json& input, const std::string& directory,
                           const std::function<bool()>& stop) {
  const std::string log =
      directory.empty() ? "/dev/null" : (fs::path(directory) / (program.name + ".log")).string();
  ChildCommand command;
  command.arguments = program.command;
  command.environment = child_environment();
  command.log = log;
  command.input = json_text(input) + "\n";
  command.directory = directory;
  ProgramOutcome outcome;
  for (int kills = 0;;) {
    ChildProcess child(command);
    const Run run = listened_to(child, log, program.time_limit, stop);
    outcome = judged(run, child, program.time_limit, log);
    outcome.interrupted = run.interrupted;
    const bool by_us = run.timed_out || run.interrupted || run.flooded || run.printed.size() > most_bytes;
    if (by_us || child.killed_by() != SIGKILL) break;
    if (++kills > 1)
      throw RuntimeError(
          "was killed by signal 9 twice, by somebody or for want of memory; the same command goes on with "
          "it, "
          "with --jobs 1 it has the memory for itself");
  }
  std::error_code ignored;
  if (!directory.empty() && fs::is_empty(log, ignored)) fs::remove(log, ignored);
  return outcome;
}

std::string program_text(const ProgramEvaluator& program) {
  std::string text = "program=" + program.name + "\n";
  for (const std::string& word : program.command) {
    const std::string digest = digest_of_file(word);
    text += digest.empty() ? "word=" + Json(word).dump() + "\n" : "file=" + digest + "\n";
  }
  return text;
}

}  // namespace icebow
