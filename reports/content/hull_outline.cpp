#include "reports/content/hull_outline.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iomanip>
#include <sstream>

namespace icebow {
namespace {

struct ObjMesh {
  std::vector<Vec3> points;
  std::vector<std::vector<int>> faces;
};

ObjMesh read_obj(const std::string& path) {
  ObjMesh mesh;
  std::ifstream file(path);
  for (std::string line; std::getline(file, line);) {
    std::istringstream in(line);
    std::string tag;
    in >> tag;
    if (tag == "v") {
      Vec3 p = Vec3::Zero();
      in >> p[0] >> p[1] >> p[2];
      mesh.points.push_back(p);
    } else if (tag == "f") {
      std::vector<int> face;
      for (std::string corner; in >> corner;) face.push_back(std::atoi(corner.c_str()) - 1);
      mesh.faces.push_back(face);
    }
  }
  return mesh;
}

bool has_bad_corner(const ObjMesh& mesh) {
  const int n = static_cast<int>(mesh.points.size());
  for (const auto& face : mesh.faces)
    for (const int corner : face)
      if (corner < 0 || corner >= n) return true;
  return false;
}

// Where the edges of the mesh meet the plane z = 0.
std::vector<Vec3> cut_at_waterline(const ObjMesh& mesh) {
  constexpr double on_plane = 1e-9;
  std::vector<Vec3> points;
  for (const auto& face : mesh.faces) {
    for (std::size_t k = 0; k < face.size(); ++k) {
      const Vec3& a = mesh.points[static_cast<std::size_t>(face[k])];
      const Vec3& b = mesh.points[static_cast<std::size_t>(face[(k + 1) % face.size()])];
      if (std::abs(a[2]) < on_plane) {
        points.push_back(a);
      } else if (std::abs(b[2]) >= on_plane && a[2] * b[2] < 0.0) {
        points.push_back(a + (b - a) * (a[2] / (a[2] - b[2])));
      }
    }
  }
  return points;
}

// Each y once, in rising order, with the foremost point there.
std::vector<Vec3> foremost(std::vector<Vec3> points) {
  constexpr double same = 1e-3;  //!< [m]
  for (Vec3& p : points) p[1] = std::round(p[1] / same) * same;
  std::sort(points.begin(), points.end(),
            [](const Vec3& a, const Vec3& b) { return a[1] < b[1] || (a[1] == b[1] && a[0] > b[0]); });
  points.erase(
      std::unique(points.begin(), points.end(), [](const Vec3& a, const Vec3& b) { return a[1] == b[1]; }),
      points.end());
  return points;
}

}  // namespace

std::vector<Vec3> read_waterline(const std::string& obj_path) {
  const ObjMesh mesh = read_obj(obj_path);
  if (mesh.faces.empty() || has_bad_corner(mesh)) return {};
  std::vector<Vec3> points = cut_at_waterline(mesh);
  points.erase(std::remove_if(points.begin(), points.end(),
                              [](const Vec3& p) { return !p.allFinite() || p[1] < -1e-9; }),
               points.end());
  return foremost(std::move(points));
}

std::string plan_svg(const std::vector<Vec3>& waterline, double length, double scale) {
  if (waterline.size() < 2) return {};
  const double width = length * scale, half = waterline.back()[1] * scale;
  std::ostringstream svg;
  svg << std::fixed << std::setprecision(1) << "<svg class=\"bow\" viewBox=\"-1 -1 " << width + 2 << ' '
      << 2 * half + 2 << "\" width=\"" << width + 2 << "\" height=\"" << 2 * half + 2
      << "\" aria-hidden=\"true\"><path d=\"M0," << 2 * half;
  const auto line_to = [&](const Vec3& p, double side) {
    svg << 'L' << width + std::max(p[0], -length) * scale << ',' << half + side * p[1] * scale;
  };
  for (auto p = waterline.rbegin(); p != waterline.rend(); ++p) line_to(*p, 1.0);
  for (const Vec3& p : waterline) line_to(p, -1.0);
  svg << "L0,0\"/></svg>";
  return svg.str();
}

}  // namespace icebow
