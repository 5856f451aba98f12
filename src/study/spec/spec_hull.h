// The section "hull" of a study file.
#pragma once

#include "study/spec/spec_section.h"
#include "study/spec/study_spec.h"

namespace icebow {

// The user's own hull, and in c.bow its dimensions and the angles asked for, as measured where none is; the
// dimensions are NaN where the section has a mistake, which is noted.
void read_hull(const Json& document, Case& c, Mistakes& mistakes);

// Makes the paths of hull files absolute, as they are meant: from the study file's directory.
void resolve_hull_files(Json& document, const std::string& study_file);

}  // namespace icebow
