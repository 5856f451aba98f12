// The files `icebow hull` writes: mesh, surfaces, lines plan of one hull or of two.
#pragma once

#include <optional>
#include <string>

#include "cli/study_choice.h"
#include "hullgen/bow/bow.h"

namespace icebow {

// Before the hull is made: a wrong ending is known at once, and what this build lacks, and options that do
// not go together. Throws InputError.
void check_hull_output(const Arguments& arguments);

// Whether its ending asks for surfaces: .step, .stp, .igs, .iges.
bool is_surface_file(const std::string& path);

struct OverlaidHull {
  std::string name;
  Hull hull;
  BowParameters bow;  // its dimensions
};
// What --overlay names: a study file (its own hull), a family (its preset) or a design of this study; nothing
// where it is not given. Throws InputError, where there is no such hull too.
std::optional<OverlaidHull> overlaid_hull(const StudySpec& spec, const Arguments& arguments);

// Throws RuntimeError where the file cannot be written.
void write_hull_output(const std::string& path, const Hull& hull, const BowParameters& bow,
                       const std::string& title, const std::optional<OverlaidHull>& overlaid);

}  // namespace icebow
