// Vectors: Eigen's, under the names the project uses.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace icebow {

using Vec3 = Eigen::Vector3d;

}  // namespace icebow
