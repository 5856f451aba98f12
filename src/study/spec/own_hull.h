// The user's own hull: section "hull" of a study file, instead of "bow".
#pragma once

#include <memory>
#include <string>

#include "hullgen/import/imported_hull.h"

namespace icebow {

struct OwnHull {
  std::string file;    // as in the document
  std::string sha256;  // of the file's bytes; empty: the study has no hull of its own
  MeshFrame frame;
  bool mirror = false;
  bool outer_surface = false;
  std::shared_ptr<const ImportedHull> imported;

  bool given() const { return !sha256.empty(); }
};

// Reads, mends and measures the file: see import_hull(). The last few hulls of a process are kept, as a
// study's documents are read many times over; a file that has changed since is read again. Throws InputError.
OwnHull load_own_hull(const std::string& file, const MeshFrame& frame, bool mirror,
                      bool outer_surface = false);

}  // namespace icebow
