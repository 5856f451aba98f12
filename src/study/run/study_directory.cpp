#include "study/run/study_directory.h"

#include <filesystem>

#include "base/errors.h"
#include "study/evaluate/provenance.h"
#include "study/store/design_files.h"

namespace icebow {
namespace {

namespace fs = std::filesystem;

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
  if (store.fact("created").empty()) store.set_fact("created", utc_now());
  store.set_fact("study", json_text(spec.document));
  store.set_fact("study_file", spec.file);
  store.set_fact("name", spec.name);
  store.set_fact("purpose", spec.purpose);
  store.set_fact("rank_by", spec.rank_by);
  store.set_fact("seed", std::to_string(spec.method.seed));
  store.set_fact("command", settings.command);
  store.set_fact("version", program_version());
  store.set_fact("host", host_name());
  store.set_fact("started", utc_now());
  store.set_fact("state", "running");
}

}  // namespace

StudyDirectory open_study_directory(const StudySpec& spec, const RunSettings& settings) {
  const fs::path directory(settings.directory);
  make_directories(settings.directory);
  const bool known = fs::exists(directory / "results.sqlite");
  StudyDirectory opened{Store::open((directory / "results.sqlite").string()), {}};
  const std::string before = opened.store.fact("study");
  write_copy(spec, directory / "study.json", known);
  if (!before.empty() && before != json_text(spec.document)) {
    opened.notes.push_back(
        "the study file has changed since this directory was last run: designs that it does not "
        "change are taken from the store, and the ranking lists those of the present file");
  }
  set_facts(opened.store, spec, settings);
  return opened;
}

int attempts(const Evaluation& running) {
  return running.result.is_object() ? running.result.value("attempts", 0) : 0;
}

void complete_result(Evaluation& e, const std::string& study_directory) {
  if (!e.result.is_object()) e.result = Json::object();
  const Json before = e.result;
  e.result["design"] = e.name;
  e.result["status"] = to_string(e.status);
  e.result["reason"] = e.reason;
  e.result["parameters"] = parameters_json(e.parameters);
  const fs::path file = fs::path(design_directory(study_directory, e.name)) / "result.json";
  if (e.result == before && fs::exists(file)) return;
  std::error_code error;
  fs::create_directories(file.parent_path(), error);
  write_text_file(file.string(), json_text(e.result, 2) + "\n");
}

}  // namespace icebow
