// The directories of a study's designs: DIR/designs/<name>, one for each row of the store, under the row's
// name.
#pragma once

#include <optional>
#include <string>

#include "study/store/store.h"

namespace icebow {

// Throws RuntimeError for a name that would lead elsewhere.
std::string design_directory(const std::string& study_directory, const std::string& name);

// Makes `name` stand for `key` and nothing else, in the store and on disk, so that files always belong to the
// row of their name. A row of an earlier study file that has the name is set aside as "name~<start of its
// key>", or dropped where it is damaged; the row of this key, where it has another name, is renamed together
// with its directory. Returns the row of the key, where there is one.
std::optional<Evaluation> settle_name(Store& store, const std::string& study_directory,
                                      const std::string& name, const std::string& key);

// An empty directory for a design that is about to be evaluated; where it was interrupted, its simulation's
// checkpoint, snapshots and pictures stay.
void clear_design_directory(const std::string& study_directory, const std::string& name);

}  // namespace icebow
