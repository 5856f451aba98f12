#include "study/run/study_directory.h"

#include <algorithm>
#include <cstdint>
#include <filesystem>

#include "base/errors.h"
#include "study/evaluate/provenance.h"
#include "study/plan/augmentation.h"
#include "study/run/crash_mark.h"
#include "study/spec/spec_ranking.h"
#include "study/store/design_files.h"

namespace icebow {
namespace {

namespace fs = std::filesystem;

// A study of somebody else's may point at files of ours: where there is no link, none is written through.
void refuse_links(const fs::path& directory) {
  std::vector<fs::path> paths = {directory / "designs"};
  for (const char* ending : {"", ".lock", "-wal", "-shm", "-journal"})
    paths.push_back(directory / (std::string("results.sqlite") + ending));
  std::error_code error;
  if (!fs::is_symlink(paths.front()))
    for (fs::directory_iterator design(paths.front(), error), end; design != end; design.increment(error))
      paths.push_back(design->path());
  for (const fs::path& path : paths)
    if (fs::is_symlink(path))
      throw RuntimeError(path.string() +
                         ": is a link; what a study writes stays in its own directory. Remove the link");
}

void make_directories(const std::string& directory) {
  std::error_code error;
  fs::create_directories(fs::path(directory) / "designs", error);
  if (error) throw RuntimeError(directory + ": cannot be made: " + error.message());
}

bool same_file(const std::string& a, const fs::path& b) {
  std::error_code error;
  return fs::equivalent(a, b, error) && !error;
}

// Somebody's own study.json is not to be lost to `--out .`.
void write_copy(const StudySpec& spec, const fs::path& copy, bool is_study_of_ours) {
  if (same_file(spec.file, copy)) return;
  if (fs::exists(copy) && !is_study_of_ours) {
    throw InputError(copy.string() +
                     ": is there already, but no study was run in that directory; choose another");
  }
  write_text_file(copy.string(), json_text(spec.document, 2) + "\n");
}

void set_facts(Store& store, const StudySpec& spec, const RunSettings& settings) {
  if (store.fact_or_nothing("created").empty()) store.set_fact("created", utc_now());
  store.set_fact("study", json_text(spec.document));
  store.set_fact("study_file", spec.file);
  store.set_fact("name", spec.name);
  store.set_fact("purpose", spec.purpose);
  store.set_fact("rank_by", spec.rank_by);
  store.set_fact("second_objective", json_text(to_json(spec.second)));
  store.set_fact("seed", std::to_string(spec.method.seed));
  store.set_fact("command", settings.command);
  store.set_fact("version", program_version());
  store.set_fact("host", host_name());
  store.set_fact("started", utc_now());
  store.set_fact("state", "running");
}

}  // namespace

StudyDirectory open_study_directory(const StudySpec& given, const RunSettings& settings,
                                    Store::Waiting waiting) {
  const fs::path directory(settings.directory);
  refuse_links(directory);
  make_directories(settings.directory);
  const bool known = fs::exists(directory / "results.sqlite");
  StudyDirectory opened{
      Store::open((directory / "results.sqlite").string(), Journal::automatic, std::move(waiting)),
      {},
      given};
  // One that is damaged is about to be written anew.
  const Json before = json_or_null(opened.store.fact_or_nothing("study"));
  if (!before.is_null()) opened.spec = continued_from(given, before);
  const StudySpec& spec = opened.spec;
  const std::string extension = words_on_extension(given, spec);
  if (!extension.empty()) opened.notes.push_back(extension);
  write_copy(spec, directory / "study.json", known);
  if (!before.is_null() && json_text(before) != json_text(spec.document)) {
    opened.notes.push_back(
        "the study file has changed since this directory was last run: designs that it does not "
        "change are taken from the store, and the ranking lists those of the present file");
  }
  set_facts(opened.store, spec, settings);
  return opened;
}

Crashes crashes_of(const Evaluation& running, const std::string& study_directory) {
  Crashes crashes;
  const Json& row = running.result;
  if (row.is_object() && row.contains("crashes") && row.at("crashes").is_number_integer())
    crashes.count =
        static_cast<int>(std::clamp<std::int64_t>(row.at("crashes").get<std::int64_t>(), 0, 1000));
  if (row.is_object() && row.contains("last_crash") && row.at("last_crash").is_string())
    crashes.last = row.at("last_crash").get<std::string>();
  const std::string mark = crash_mark_in(design_directory(study_directory, running.name));
  if (mark.empty() || mark == crashes.last) return crashes;
  return {crashes.count + 1, mark};
}

Json to_json(const Crashes& crashes) {
  return {{"crashes", crashes.count}, {"last_crash", crashes.last}};
}

void complete_result(Evaluation& e, const std::string& study_directory, bool has_files) {
  if (!e.result.is_object()) e.result = Json::object();
  const Json before = e.result;
  e.result["design"] = e.name;
  e.result["status"] = to_string(e.status);
  e.result["reason"] = e.reason;
  e.result["parameters"] = parameters_json(e.parameters);
  const fs::path file = fs::path(design_directory(study_directory, e.name)) / "result.json";
  const bool there = fs::exists(file);
  if (there ? e.result == before : !has_files) return;
  std::error_code error;
  fs::create_directories(file.parent_path(), error);
  write_text_file(file.string(), json_text(e.result, 2) + "\n");
}

}  // namespace icebow
