#include "study/spec/own_hull.h"

#include <deque>
#include <filesystem>
#include <mutex>

#include "base/errors.h"
#include "base/file_kind.h"
#include "base/json.h"
#include "base/sha256.h"

namespace icebow {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t most_kept = 8;

struct Stamp {
  fs::file_time_type written;
  std::uintmax_t size = 0;
  bool operator==(const Stamp& other) const { return written == other.written && size == other.size; }
};

struct Kept {
  Stamp stamp;
  OwnHull hull;
};

bool same_frame(const MeshFrame& a, const MeshFrame& b) {
  return a.unit == b.unit && a.forward == b.forward && a.up == b.up && a.left_handed == b.left_handed &&
         a.waterline == b.waterline && a.draft == b.draft;
}

// Hulls by file and frame, the one asked for last in front.
class RecentHulls {
 public:
  OwnHull get(const std::string& file, const MeshFrame& frame, bool mirror, bool outer) {
    const std::lock_guard<std::mutex> lock(mutex_);
    const Stamp stamp = stamp_of(file);
    for (auto k = kept_.begin(); k != kept_.end(); ++k) {
      const OwnHull& hull = k->hull;
      if (hull.file != file || hull.mirror != mirror || hull.outer_surface != outer || !(k->stamp == stamp) ||
          !same_frame(hull.frame, frame))
        continue;
      Kept found = *k;
      kept_.erase(k);
      kept_.push_front(std::move(found));
      return kept_.front().hull;
    }
    OwnHull hull{file,  sha256(read_text_file(file)),
                 frame, mirror,
                 outer, std::make_shared<const ImportedHull>(import_hull(file, frame, {mirror, outer, {}}))};
    kept_.push_front({stamp, std::move(hull)});
    if (kept_.size() > most_kept) kept_.pop_back();
    return kept_.front().hull;
  }

 private:
  static Stamp stamp_of(const std::string& file) {
    if (!fs::is_regular_file(file)) throw InputError(file + ": " + why_no_file(file));
    return {fs::last_write_time(file), fs::file_size(file)};
  }

  std::mutex mutex_;
  std::deque<Kept> kept_;
};

}  // namespace

OwnHull load_own_hull(const std::string& file, const MeshFrame& frame, bool mirror, bool outer_surface) {
  static RecentHulls recent;
  return recent.get(file, frame, mirror, outer_surface);
}

}  // namespace icebow
