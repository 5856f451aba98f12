#include "study/store/design_files.h"

#include <filesystem>

#include "base/errors.h"
#include "base/printable.h"
#include "study/evaluate/evaluate.h"
#include "study/evaluate/scenario_result.h"
#include "study/spec/design_name.h"

namespace icebow {
namespace {

namespace fs = std::filesystem;

// Somebody else's study may point at files of ours.
void refuse_link(const fs::path& path) {
  if (fs::is_symlink(path))
    throw RuntimeError(
        path.string() +
        ": is a link; what a study writes stays in its own directory. Put a directory in its place");
}

// The directory first, then the row: a kill in between leaves a move that is completed by doing it again.
Evaluation move_design(Store& store, const std::string& study_directory, Evaluation e,
                       const std::string& name) {
  const fs::path from = design_directory(study_directory, e.name),
                 to = design_directory(study_directory, name);
  refuse_link(from);
  refuse_link(from.parent_path());
  if (fs::exists(from)) {
    fs::remove_all(to);
    fs::rename(from, to);
  }
  e.name = name;
  if (e.result.is_object() && e.result.contains("design")) e.result["design"] = name;
  const fs::path file = to / "result.json";
  if (fs::exists(file)) write_text_file(file.string(), json_text(e.result, 2) + "\n");
  store.put(e);
  return e;
}

std::string set_aside(const Evaluation& e) {
  return e.name.substr(0, e.name.find('~')) + "~" + e.key.substr(0, 8);
}

bool has_kept_scenarios(const fs::path& directory) {
  std::error_code none;
  for (const fs::directory_entry& entry : fs::directory_iterator(directory, none))
    if (is_kept_scenario(entry.path().filename().string())) return true;
  return false;
}

// What a simulation that goes on from its checkpoint still needs; `behind`: or behind a scenario that is
// over, whose files stand.
bool is_continued(const fs::directory_entry& file, bool behind) {
  const std::string name = file.path().filename().string();
  if (file.is_symlink() || !file.is_regular_file() || file.path().extension() == ".tmp") return false;
  return behind || name == checkpoint_name || name == std::string(checkpoint_name) + ".damaged" ||
         name.rfind("ice", 0) == 0 || name.rfind("hull_", 0) == 0 || name == "hull.vtp";
}

}  // namespace

std::string design_directory(const std::string& study_directory, const std::string& name) {
  if (!is_stored_name(name))
    throw RuntimeError(study_directory + ": a design is called \"" + shortened(name, 60) +
                       "\", which is no name of a design");
  return (fs::path(study_directory) / "designs" / name).string();
}

std::optional<Evaluation> settle_name(Store& store, const std::string& study_directory,
                                      const std::string& name, const std::string& key) {
  try {
    const auto holder = store.find_name(name);
    if (holder && holder->key == key) return holder;
    if (holder && holder->status == EvaluationStatus::damaged) {
      store.remove(holder->key);
    } else if (holder) {
      move_design(store, study_directory, *holder, set_aside(*holder));
    }
    const auto stored = store.find(key);
    if (stored && stored->name != name && stored->status != EvaluationStatus::damaged)
      return move_design(store, study_directory, *stored, name);
    return stored;
  } catch (const fs::filesystem_error& error) {
    throw RuntimeError(error.what());
  }
}

void clear_design_directory(const std::string& study_directory, const std::string& name) {
  const fs::path directory = design_directory(study_directory, name);
  try {
    refuse_link(directory.parent_path());
    refuse_link(directory);
    const bool behind = has_kept_scenarios(directory);
    if (!behind && !fs::exists(directory / checkpoint_name)) fs::remove_all(directory);
    fs::create_directories(directory);
    std::vector<fs::path> old;
    for (const fs::directory_entry& entry : fs::directory_iterator(directory)) {
      if (!is_continued(entry, behind)) old.push_back(entry.path());
    }
    for (const fs::path& path : old) fs::remove_all(path);
  } catch (const fs::filesystem_error& error) {
    throw RuntimeError(error.what());
  }
}

}  // namespace icebow
