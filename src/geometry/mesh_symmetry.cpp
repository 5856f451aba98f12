#include <algorithm>
#include <set>

#include "geometry/quad_mesh.h"

namespace icebow {
namespace {

// The points of a mesh by place.
class PointFinder {
 public:
  PointFinder(const QuadMesh& mesh, double tolerance) : mesh_(mesh), tolerance_(tolerance) {
    for (std::size_t n = 0; n < mesh.points.size(); ++n) by_x_.push_back({mesh.points[n].x(), int(n)});
    std::sort(by_x_.begin(), by_x_.end());
  }
  // The lowest number of the points there, -1 where there is none.
  int at(const Vec3& place) const {
    int found = -1;
    auto p = std::lower_bound(by_x_.begin(), by_x_.end(), std::make_pair(place.x() - tolerance_, -1));
    for (; p != by_x_.end() && p->first <= place.x() + tolerance_; ++p) {
      const bool lower = found < 0 || p->second < found;
      if (lower && (mesh_.points[p->second] - place).norm() <= tolerance_) found = p->second;
    }
    return found;
  }

 private:
  const QuadMesh& mesh_;
  double tolerance_;
  std::vector<std::pair<double, int>> by_x_;
};

using Corners = std::array<int, 4>;

// In no order, each once: a triangle repeats one of its corners.
Corners corners(const std::array<int, 4>& quad, const std::vector<int>& number) {
  Corners c;
  std::transform(quad.begin(), quad.end(), c.begin(), [&](int point) { return number[point]; });
  std::sort(c.begin(), c.end());
  std::fill(std::unique(c.begin(), c.end()), c.end(), -1);
  return c;
}

}  // namespace

std::optional<Vec3> place_without_mirror_image(const QuadMesh& mesh, double tolerance) {
  const PointFinder finder(mesh, tolerance);
  std::vector<int> own, image;
  for (const Vec3& p : mesh.points) {
    own.push_back(finder.at(p));
    image.push_back(finder.at(Vec3(p.x(), -p.y(), p.z())));
  }
  std::set<Corners> there;
  for (const auto& quad : mesh.quads) there.insert(corners(quad, own));
  for (const auto& quad : mesh.quads) {
    for (int corner : quad)
      if (image[corner] < 0) return mesh.points[corner];
    if (!there.count(corners(quad, image))) return mesh.points[quad[0]];
  }
  return {};
}

}  // namespace icebow
