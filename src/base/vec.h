// Vectors: Eigen's, under the names the project uses.
#pragma once

#include <Eigen/Core>

namespace icebow {

using Vec3 = Eigen::Vector3d;

}  // namespace icebow
