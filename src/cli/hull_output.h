// The files `icebow hull` writes: mesh, surfaces, lines plan of one hull or of two.
#pragma once

#include <optional>
#include <string>

#include "cli/study_choice.h"
#include "hullgen/bow.h"

namespace icebow {

// Before the hull is made: a wrong ending is known at once, and what this build lacks, and options that do
// not go together. Throws InputError.
void check_hull_output(const Arguments& arguments);

struct OverlaidBow {
  std::string name;
  BowParameters bow;
};
// What --overlay names: a study file (its own bow), a family (its preset) or a design of this study; nothing
// where it is not given. Throws InputError.
std::optional<OverlaidBow> overlaid_bow(const StudySpec& spec, const Arguments& arguments);

// Throws InputError where the overlaid bow has no hull, RuntimeError where the file cannot be written.
void write_hull_output(const std::string& path, const Hull& hull, const BowParameters& bow,
                       const std::string& title, const std::optional<OverlaidBow>& overlaid);

}  // namespace icebow
