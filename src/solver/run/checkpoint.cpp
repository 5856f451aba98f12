#include "solver/run/checkpoint.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <limits>
#include <vector>

#include "base/error_words.h"
#include "base/errors.h"
#include "base/json.h"
#include "base/json_fields.h"
#include "base/parallel_file.h"
#include "base/printable.h"
#include "base/text.h"
#include "base/whole_number.h"
#include "solver/model/describe_history.h"
#include "solver/run/case_text.h"
#include "solver/run/sheet_file.h"

namespace icebow {
namespace {

constexpr int format_version = 6;

// The doubles and the integers of a row, each in a list of its own.
struct RowWriter {
  std::vector<double> values;
  std::vector<std::int64_t> counts;
  void column(const char* /*name*/, double value) { values.push_back(value); }
  void column(const char* /*name*/, std::int64_t count) { counts.push_back(count); }
  void sometimes(const char* name, double value) { column(name, value); }
};

struct RowReader {
  const double* value;
  const std::int64_t* count;
  void column(const char* /*name*/, double& into) { into = *value++; }
  void column(const char* /*name*/, std::int64_t& into) { into = *count++; }
  void sometimes(const char* name, double& into) { column(name, into); }
};

void save_history(ParallelFile& file, const std::vector<HistoryRow>& rows) {
  RowWriter writer;
  for (const HistoryRow& row : rows) describe(writer, row);
  file.write_list("history", writer.values);
  file.write_list("history_counts", writer.counts);
}

std::vector<HistoryRow> load_history(ParallelFile& file) {
  RowWriter one;
  const HistoryRow any;
  describe(one, any);
  const std::vector<double> values = file.read_list<double>("history");
  const std::vector<std::int64_t> counts = file.read_list<std::int64_t>("history_counts");
  std::vector<HistoryRow> rows(counts.size() / one.counts.size());
  if (values.size() != rows.size() * one.values.size()) throw RuntimeError("its history is not whole");
  RowReader reader{values.data(), counts.data()};
  for (HistoryRow& row : rows) describe(reader, row);
  return rows;
}

// Totals over the ranks: a run on other ranks gives them to its root.
Json run_json(const Communicator& comm, const RunState& run) {
  const Stepper& stepper = run.stepper;
  ExactImpulse::Counts impulse = stepper.impulse().counts();
  const ContactCounts contact = stepper.ledger().counts();
  const EnergyCounts& dropped = stepper.dropped();
  const SurroundingsCounts& given = stepper.given_away();
  std::int64_t totals[12] = {
      stepper.broken_bonds(), contact.hull_work, contact.gain, dropped.kinetic, dropped.potential,
      dropped.elastic,        dropped.fracture,  given.water,  given.floes,     given.edges,
      run.linear.linear,      run.linear.all};
  comm.sum(impulse.data(), static_cast<int>(impulse.size()));
  comm.sum(totals, 12);
  return {{"format", format_version},
          {"precision_bytes", precision_of(stepper.sheet())},
          {"steps", stepper.steps()},
          {"broken_bonds", totals[0]},
          {"contact_energy", {totals[1], totals[2]}},
          {"window_first", stepper.sheet().lattice.first},
          {"window_dropped", {totals[3], totals[4], totals[5], totals[6]}},
          {"given_away", {totals[7], totals[8], totals[9]}},
          {"linear_blocks", {totals[10], totals[11]}},
          {"energy_watch", run.recorder.energy_watch().record()},
          {"impulse", impulse},
          {"wall_seconds", run.wall_seconds},
          {"files", run.snapshots.record()}};
}

// Particles next to the hull: [particle's number, reference height, acceleration] each, from all ranks.
void save_touches(ParallelFile& file, const Communicator& comm, const Stepper& stepper) {
  file.write_list("touches", comm.gather_everywhere(stepper.ledger().record(stepper.sheet())));
}

void write_all(ParallelFile& file, const Communicator& comm, const std::string& case_text,
               const RunState& run) {
  const Stepper& stepper = run.stepper;
  file.attribute("/", "precision", precision_of(stepper.sheet()) == 4 ? "float32" : "float64");
  file.write_text("case", case_text);
  file.write_text("run", run_json(comm, run).dump());
  save_history(file, run.recorder.history().rows);
  file.write_list("cracked_columns", run.process.crack_record());
  file.write_list("dropped_ice", run.process.ice_record());
  save_touches(file, comm, stepper);
  save_sheet(file, stepper.sheet());
  file.close();
}

// To the disk itself: after a power cut a rename without it may have put an empty file in place.
void flush(const std::string& path) {
  const int file = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (file < 0) return;
  ::fsync(file);
  ::close(file);
}

// What runs that were killed while they wrote have left beside it.
void remove_halves(const std::filesystem::path& path) {
  const std::filesystem::path folder = path.has_parent_path() ? path.parent_path() : ".";
  const std::string beginning = path.filename().string() + ".tmp";
  std::vector<std::filesystem::path> halves;
  std::error_code ignored;
  for (std::filesystem::directory_iterator entry(folder, ignored), end; entry != end;
       entry.increment(ignored))
    if (entry->path().filename().string().rfind(beginning, 0) == 0) halves.push_back(entry->path());
  for (const std::filesystem::path& half : halves) std::filesystem::remove(half, ignored);
}

std::string put_in_place(const std::string& from, const std::string& to) {
  flush(from);
  if (std::rename(from.c_str(), to.c_str()) != 0) return "cannot replace " + to + ": " + std::strerror(errno);
  const std::string folder = std::filesystem::path(to).parent_path().string();
  flush(folder.empty() ? "." : folder);
  remove_halves(to);
  return "";
}

}  // namespace

void save_checkpoint(const Communicator& comm, const std::string& path, const std::string& case_text,
                     const RunState& run) {
  // A run that was killed a moment ago may still be writing: no two have one name.
  const std::string temporary = comm.broadcast(path + ".tmp" + std::to_string(::getpid()));
  if (comm.is_root()) std::remove(temporary.c_str());  // whoever put it there, a link for one
  comm.barrier();
  try {
    ParallelFile file = ParallelFile::create(comm, temporary, Checksums::yes);
    write_all(file, comm, case_text, run);
  } catch (const RuntimeError&) {
    if (comm.is_root()) std::remove(temporary.c_str());
    throw;
  }
  const std::string trouble = comm.broadcast(comm.is_root() ? put_in_place(temporary, path) : "");
  if (!trouble.empty()) throw RuntimeError(trouble);
}

namespace {

// Why the rest of `run` is not looked at: what it holds differs from version to version. Empty where it can
// be.
std::string other_version(const Json& run) {
  const Json& format = part_at(run, "/format");
  if (format == format_version) return "";
  return "is of another version of the program (its format is " + shortened(format.dump(), 20) +
         ", that of this program " + std::to_string(format_version) + ")";
}

std::int64_t count_at(const Json& run, const char* key, double most = most_whole) {
  const Json& value = run.at(key);
  const std::string trouble = std::string(key) + " is no count";
  if (!value.is_number()) throw RuntimeError(trouble);
  return whole_number(value.get<double>(), 0.0, most, trouble);
}

}  // namespace

std::string why_not_resumable(const Communicator& comm, const std::string& path, const std::string& case_text,
                              int precision, std::int64_t last_step, bool* damaged) {
  if (damaged) *damaged = false;
  try {
    ParallelFile file = ParallelFile::open(comm, path);
    const Json run = parse_json(file.read_text("run"), "run");
    const std::string other = other_version(run);
    if (!other.empty()) return other;
    const std::string difference = case_difference(file.read_text("case"), case_text);
    if (!difference.empty()) return "is of another run: " + difference;
    if (run.at("precision_bytes") != precision) return "was computed in another floating-point precision";
    const std::int64_t steps = count_at(run, "steps");
    if (steps > last_step)
      return text("is of a longer voyage: %lld steps there, %lld here", static_cast<long long>(steps),
                  static_cast<long long>(last_step));
  } catch (const std::exception& error) {  // the same on every rank: all have read the same
    if (damaged) *damaged = true;
    return std::string("is not a whole checkpoint (") + in_words(error) + ")";
  }
  return "";
}

namespace {

// What every rank reads.
struct Lists {
  Json run;
  std::vector<HistoryRow> rows;
  std::vector<double> touches, cracked_columns, dropped_ice;
};

Lists read_lists(ParallelFile& file) {
  Json run = parse_json(file.read_text("run"), "run");
  const std::string other = other_version(run);
  if (!other.empty()) throw RuntimeError("it " + other);
  return {std::move(run), load_history(file), file.read_list<double>("touches"),
          file.read_list<double>("cracked_columns"), file.read_list<double>("dropped_ice")};
}

void restore(const Communicator& comm, const Lists& lists, RunState& run) {
  const Json &json = lists.run, &dropped = json.at("window_dropped"), &given = json.at("given_away"),
             &contact = json.at("contact_energy"), &linear = json.at("linear_blocks");
  const bool root = comm.is_root();
  const std::int64_t first = count_at(json, "window_first", std::numeric_limits<int>::max());
  if (first % block != 0) throw RuntimeError("its window begins within a block");
  run.stepper.sheet().start_at(static_cast<int>(first));
  run.stepper.restore(
      count_at(json, "steps"), root ? count_at(json, "broken_bonds") : 0,
      root ? json.at("impulse").get<ExactImpulse::Counts>() : ExactImpulse::Counts{},
      root ? EnergyCounts{dropped.at(0), dropped.at(1), dropped.at(2), dropped.at(3)} : EnergyCounts{},
      root ? SurroundingsCounts{given.at(0), given.at(1), given.at(2)} : SurroundingsCounts{});
  run.stepper.ledger().restore(root ? ContactCounts{contact.at(0), contact.at(1)} : ContactCounts{},
                               lists.touches, run.stepper.sheet());
  run.recorder.restore(lists.rows, json.at("energy_watch"));
  run.process.restore(lists.cracked_columns, lists.dropped_ice);
  run.snapshots.restore(json.at("files"));
  run.linear = root ? LinearCount{linear.at(0), linear.at(1)} : LinearCount{};
  run.wall_seconds = json.at("wall_seconds");
}

}  // namespace

void load_checkpoint(const Communicator& comm, const std::string& path, RunState& run) {
  std::string trouble;
  try {
    ParallelFile file = ParallelFile::open(comm, path);
    const Lists lists = read_lists(file);  // the same on every rank, so all throw or none
    load_sheet(file, run.stepper.sheet());
    try {
      restore(comm, lists, run);
    } catch (const std::exception& error) {
      trouble = in_words(error);
    }
    fail_together(comm, trouble);
  } catch (const std::exception& error) {
    throw DamagedCheckpoint(path + " cannot be continued: " + in_words(error) +
                            "; remove it, or start the run anew with --restart");
  }
}

void remove_checkpoint(const std::string& path) {
  std::error_code ignored;
  std::filesystem::remove(path, ignored);
  remove_halves(path);
}

Checkpoints::Checkpoints(const Communicator& comm, const QuadMesh& hull, const Scenario& scenario,
                         const RunOptions& options)
    : comm_(comm), options_(options), case_(case_text(hull, scenario, options)) {}

// The root looks: a directory that is mounted late on another machine must not part the ranks.
bool Checkpoints::there() const {
  return comm_.any(comm_.is_root() && std::filesystem::exists(options_.checkpoint_file));
}

void Checkpoints::resume(RunState& run, std::int64_t last_step) {
  const std::string& path = options_.checkpoint_file;
  if (path.empty() || options_.resume == Resume::never || !there()) return;
  bool damaged = false;
  const std::string reason =
      why_not_resumable(comm_, path, case_, precision_of(run.stepper.sheet()), last_step, &damaged);
  if (!reason.empty()) {
    if (options_.resume == Resume::if_usable) return damaged ? set_aside(reason) : void();
    throw RuntimeError(path + " " + reason +
                       "; to start this run anew remove that file or give --restart, to keep it take "
                       "another directory");
  }
  try {
    load_checkpoint(comm_, path, run);
  } catch (const DamagedCheckpoint& error) {
    if (options_.resume == Resume::if_usable) set_aside(error.what());
    throw;
  }
  last_ = Clock::now();
  if (comm_.is_root() && options_.on_resume) options_.on_resume(run.stepper.steps());
}

// Collective. It may still tell somebody what befell the disk.
void Checkpoints::set_aside(const std::string& reason) const {
  const std::string &path = options_.checkpoint_file, aside = path + ".damaged";
  std::string trouble;
  if (comm_.is_root()) {
    if (std::rename(path.c_str(), aside.c_str()) != 0)
      trouble = "cannot rename " + path + ", which is damaged: " + std::strerror(errno);
    else if (options_.on_note)
      options_.on_note("its checkpoint was damaged, so it started anew; the file is kept as " + aside + " (" +
                       shortened(reason, 160) + ")");
  }
  fail_together(comm_, trouble);
}

void Checkpoints::write_due(const RunState& run, bool stopping) {
  if (options_.checkpoint_file.empty()) return;
  const double every = options_.checkpoint_every_s;
  const bool due =
      comm_.is_root() && every > 0.0 && std::chrono::duration<double>(Clock::now() - last_).count() > every;
  if (!comm_.any(stopping || due)) return;
  save_checkpoint(comm_, options_.checkpoint_file, case_, run);
  last_ = Clock::now();
}

void Checkpoints::remove() {
  if (!options_.checkpoint_file.empty() && comm_.is_root()) remove_checkpoint(options_.checkpoint_file);
}

}  // namespace icebow
