// Hulls from STEP and IGES files, through OpenCASCADE. Built in where CMake finds that (option ICEBOW_CAD).
#pragma once

#include <string>
#include <vector>

#include "geometry/quad_mesh.h"

namespace icebow {

// Whether the name ends like a STEP or IGES file's, in any case.
bool is_cad_file(const std::string& path);

// The surfaces of a .step, .stp, .igs or .iges file as triangles, in metres whatever the file's unit; axes as
// they stand there. Faces are sewn where they meet within 0.01 % of the size; curved ones are split until
// chords are within 0.01 % of the size and turn by no more than 3 deg, and large triangles until their edges
// are an eightieth of the size. Loose faces, as IGES files have them, are fine. What was done is added to
// `notes`. Throws InputError where the file cannot be read, has no surface, or it is not built in.
QuadMesh read_cad(const std::string& path, std::vector<std::string>& notes);

}  // namespace icebow
