#include "hullgen/hydro/shell_curvature.h"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <utility>

#include "base/units.h"

namespace icebow {
namespace {

constexpr std::array<double, 5> knuckles = {radians(25.0), radians(12.0), radians(6.0), radians(3.0),
                                            radians(1.5)};
constexpr double good_fit = 3e-3;  // of the neighbourhood's size
constexpr int rings = 2, fewest_points = 8;
constexpr std::size_t most_panels = 40000;

int corners(const QuadMesh& mesh, std::size_t quad) {
  return mesh.is_triangle(quad) ? 3 : 4;
}

// Twice the panel's area, along its normal.
Vec3 double_area(const QuadMesh& mesh, std::size_t quad) {
  const auto& q = mesh.quads[quad];
  const auto& p = mesh.points;
  return (p[q[2]] - p[q[0]]).cross(p[q[3]] - p[q[1]]);
}

Vec3 middle(const QuadMesh& mesh, std::size_t quad) {
  Vec3 sum = Vec3::Zero();
  const int n = corners(mesh, quad);
  for (int k = 0; k < n; ++k) sum += mesh.points[mesh.quads[quad][k]];
  return sum / n;
}

class Panels {
 public:
  explicit Panels(const QuadMesh& mesh) : mesh_(mesh), beside_(mesh.quads.size()) {
    std::map<std::pair<int, int>, std::size_t> open;
    for (std::size_t quad = 0; quad < mesh.quads.size(); ++quad) {
      const Vec3 area = double_area(mesh, quad);
      normals_.push_back(area.norm() > 0.0 ? Vec3(area.normalized()) : Vec3(Vec3::Zero()));
      const int n = corners(mesh, quad);
      for (int k = 0; k < n; ++k) {
        const int a = mesh.quads[quad][k], b = mesh.quads[quad][(k + 1) % n];
        const auto [edge, first] = open.emplace(std::minmax(a, b), quad);
        if (first) continue;
        beside_[quad].push_back(edge->second);
        beside_[edge->second].push_back(quad);
      }
    }
  }

  PanelCurvature curvature(std::size_t quad) const {
    PanelCurvature found{none, none};
    for (const double knuckle : knuckles) {
      const std::vector<int> points = around(quad, std::cos(knuckle));
      if (static_cast<int>(points.size()) < fewest_points) break;
      double off = 0.0;
      found = fitted(quad, points, off);
      if (off <= good_fit) break;
    }
    return found;
  }

 private:
  static constexpr double none = std::numeric_limits<double>::quiet_NaN();

  // Corners of the panels that are reached from this one over edges that turn less.
  std::vector<int> around(std::size_t quad, double least_cosine) const {
    std::set<std::size_t> reached{quad}, rim{quad};
    for (int ring = 0; ring < rings; ++ring) {
      std::set<std::size_t> next;
      for (const std::size_t at : rim)
        for (const std::size_t other : beside_[at])
          if (normals_[at].dot(normals_[other]) >= least_cosine && reached.insert(other).second)
            next.insert(other);
      rim = std::move(next);
    }
    std::set<int> points;
    for (const std::size_t at : reached) points.insert(mesh_.quads[at].begin(), mesh_.quads[at].end());
    return {points.begin(), points.end()};
  }

  // h = a + b u + c v + d u^2/2 + e u v + f v^2/2 in the panel's plane, u and v in sizes of the
  // neighbourhood.
  PanelCurvature fitted(std::size_t quad, const std::vector<int>& points, double& off) const {
    const Vec3 from = middle(mesh_, quad), n = normals_[quad], x = n.unitOrthogonal(), y = n.cross(x);
    double size = 0.0;
    for (const int p : points) size = std::max(size, (mesh_.points[p] - from).norm());
    const auto rows = static_cast<Eigen::Index>(points.size());
    Eigen::MatrixXd terms(rows, 6);
    Eigen::VectorXd heights(rows);
    for (Eigen::Index k = 0; k < rows; ++k) {
      const Vec3 d = (mesh_.points[points[k]] - from) / size;
      const double u = d.dot(x), v = d.dot(y);
      terms.row(k) << 1.0, u, v, 0.5 * u * u, u * v, 0.5 * v * v;
      heights(k) = d.dot(n);
    }
    const auto solver = terms.colPivHouseholderQr();
    if (solver.rank() < 6) return {none, none};
    const Eigen::VectorXd t = solver.solve(heights);
    off = (terms * t - heights).cwiseAbs().maxCoeff();
    // Eigenvalues of the shape operator, from the two fundamental forms.
    const double root = std::sqrt(1.0 + t(1) * t(1) + t(2) * t(2));
    Eigen::Matrix2d first, second;
    first << 1.0 + t(1) * t(1), t(1) * t(2), t(1) * t(2), 1.0 + t(2) * t(2);
    second << t(3), t(4), t(4), t(5);
    const Eigen::Matrix2d shape = first.inverse() * second / root;
    const double mean = 0.5 * shape.trace(),
                 half = std::sqrt(std::max(mean * mean - shape.determinant(), 0.0));
    PanelCurvature c{(mean + half) / size, (mean - half) / size};
    if (std::abs(c.smaller) > std::abs(c.larger)) std::swap(c.larger, c.smaller);
    return c;
  }

  const QuadMesh& mesh_;
  std::vector<Vec3> normals_;
  std::vector<std::vector<std::size_t>> beside_;
};

}  // namespace

std::vector<PanelCurvature> panel_curvatures(const QuadMesh& mesh) {
  const Panels panels(mesh);
  std::vector<PanelCurvature> result;
  for (std::size_t quad = 0; quad < mesh.quads.size(); ++quad) result.push_back(panels.curvature(quad));
  return result;
}

ShellShares shell_shares(const QuadMesh& mesh, double aft_end, double straight) {
  const Panels panels(mesh);
  ShellShares shares;
  std::vector<std::size_t> shell;
  for (std::size_t quad = 0; quad < mesh.quads.size(); ++quad) {
    const Vec3 at = middle(mesh, quad);
    if (at.z() >= 0.0 || at.x() <= aft_end) continue;
    shell.push_back(quad);
    shares.area += 0.5 * double_area(mesh, quad).norm();
  }
  const std::size_t step = 1 + shell.size() / most_panels;
  double told = 0.0;
  for (std::size_t k = 0; k < shell.size(); k += step) {
    const PanelCurvature c = panels.curvature(shell[k]);
    if (std::isnan(c.larger)) continue;
    const double area = 0.5 * double_area(mesh, shell[k]).norm();
    told += area;
    const bool one = std::abs(c.larger) * straight > 1.0, both = std::abs(c.smaller) * straight > 1.0;
    (both ? shares.double_curved : one ? shares.single_curved : shares.flat) += area;
  }
  if (told > 0.0)
    for (double* share : {&shares.flat, &shares.single_curved, &shares.double_curved}) *share /= told;
  return shares;
}

}  // namespace icebow
