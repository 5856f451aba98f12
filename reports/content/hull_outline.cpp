#include "reports/content/hull_outline.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iomanip>
#include <limits>
#include <sstream>

namespace icebow {
namespace {

struct ObjMesh {
  std::vector<Vec3> points;
  std::vector<std::vector<int>> faces;
};

// By strtod: a study has hundreds of meshes of a megabyte, and streams take a tenth of a second for each.
ObjMesh read_obj(const std::string& path) {
  ObjMesh mesh;
  std::ifstream file(path);
  for (std::string line; std::getline(file, line);) {
    const char* at = line.c_str() + 1;
    char* end = nullptr;
    if (line[0] == 'v' && line[1] == ' ') {
      Vec3 p = Vec3::Zero();
      for (int k = 0; k < 3; ++k, at = end) p[k] = std::strtod(at, &end);
      mesh.points.push_back(p);
    } else if (line[0] == 'f') {
      std::vector<int> face;
      for (long corner = std::strtol(at, &end, 10); end != at; corner = std::strtol(at, &end, 10)) {
        const bool counts = corner > 0 && corner <= std::numeric_limits<int>::max();
        face.push_back(counts ? static_cast<int>(corner - 1) : -1);
        at = end + std::strcspn(end, " \t");  // "12/3/4": texture and normal are of no interest
      }
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

// Points at least so far from each other; the ends stay.
std::vector<Vec3> apart(const std::vector<Vec3>& points, double distance) {
  std::vector<Vec3> kept = {points.front()};
  for (const Vec3& p : points)
    if ((p - kept.back()).norm() >= distance) kept.push_back(p);
  if (kept.back() != points.back()) kept.push_back(points.back());
  return kept;
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

BowOutline bow_outline(const std::vector<Vec3>& waterline, double length, double scale) {
  BowOutline outline;
  if (waterline.size() < 2) return outline;
  const double half = waterline.back()[1] * scale;
  outline.width = length * scale, outline.height = 2.0 * half;
  std::ostringstream path;
  path << std::fixed << std::setprecision(1) << "M0," << 2 * half;
  const auto line_to = [&](const Vec3& p, double side) {
    path << 'L' << outline.width + std::max(p[0], -length) * scale << ',' << half + side * p[1] * scale;
  };
  const std::vector<Vec3> seen = apart(waterline, 0.7 / scale);  // no pixel holds two points
  for (auto p = seen.rbegin(); p != seen.rend(); ++p) line_to(*p, 1.0);
  for (const Vec3& p : seen) line_to(p, -1.0);
  path << "L0,0";
  outline.path = path.str();
  return outline;
}

}  // namespace icebow
