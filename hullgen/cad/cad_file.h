// A hull as a STEP or IGES file of B-spline surfaces, through OpenCASCADE. Built in where CMake finds that
// (option ICEBOW_CAD).
#pragma once

#include <string>

#include "hullgen/cad/hull_surfaces.h"

namespace icebow {

// "" where STEP and IGES are built in; otherwise why not and what to do, to stand behind a file's name.
std::string why_no_cad();

// The format follows the ending: .step or .stp is STEP AP214 with one solid, .igs or .iges is IGES 5.3 with
// the trimmed surfaces of the closed shell (entities 128 and 144). Lengths are in metres, and the file says
// so. Returns the volume of the solid [m^3]. Throws InputError for another ending or where it is not built
// in, RuntimeError where the surfaces do not close or the file cannot be written.
double write_cad(const std::string& path, const HullSurfaces& hull, const std::string& name);

}  // namespace icebow
