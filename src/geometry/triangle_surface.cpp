#include "geometry/triangle_surface.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>
#include <tuple>

#include "base/errors.h"

namespace icebow {
namespace {

// For each point the number of its vertex; equal points share one. Fills `vertices`.
std::vector<int> weld(const std::vector<Vec3>& points, std::vector<Vec3>& vertices) {
  std::vector<int> order(points.size());
  std::iota(order.begin(), order.end(), 0);
  const auto key = [&](int i) { return std::make_tuple(points[i].x(), points[i].y(), points[i].z()); };
  std::sort(order.begin(), order.end(), [&](int i, int j) { return key(i) < key(j); });
  std::vector<int> vertex(points.size());
  for (std::size_t k = 0; k < order.size(); ++k) {
    if (k == 0 || key(order[k]) != key(order[k - 1])) vertices.push_back(points[order[k]]);
    vertex[order[k]] = static_cast<int>(vertices.size()) - 1;
  }
  return vertex;
}

// False for corners on a line.
bool has_area(const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 ab = b - a, ac = c - a, bc = c - b;
  const double longest = std::max({ab.squaredNorm(), ac.squaredNorm(), bc.squaredNorm()});
  return ab.cross(ac).norm() > 1e-12 * longest;
}

double angle_between(const Vec3& u, const Vec3& v) {
  return std::atan2(u.cross(v).norm(), u.dot(v));
}

TrianglePoint at(const Vec3& point, Feature feature, const Vec3& p) {
  return {(p - point).squaredNorm(), point, feature};
}

}  // namespace

TrianglePoint closest_on_triangle(const Corners& t, const Vec3& p) {
  const Vec3 ab = t.b - t.a, ac = t.c - t.a, ap = p - t.a;
  const double d1 = ab.dot(ap), d2 = ac.dot(ap);
  if (d1 <= 0.0 && d2 <= 0.0) return at(t.a, Feature::vertex_a, p);
  const Vec3 bp = p - t.b;
  const double d3 = ab.dot(bp), d4 = ac.dot(bp);
  if (d3 >= 0.0 && d4 <= d3) return at(t.b, Feature::vertex_b, p);
  const double vc = d1 * d4 - d3 * d2;
  if (vc <= 0.0 && d1 >= 0.0 && d3 <= 0.0) return at(t.a + d1 / (d1 - d3) * ab, Feature::edge_ab, p);
  const Vec3 cp = p - t.c;
  const double d5 = ab.dot(cp), d6 = ac.dot(cp);
  if (d6 >= 0.0 && d5 <= d6) return at(t.c, Feature::vertex_c, p);
  const double vb = d5 * d2 - d1 * d6;
  if (vb <= 0.0 && d2 >= 0.0 && d6 <= 0.0) return at(t.a + d2 / (d2 - d6) * ac, Feature::edge_ca, p);
  const double va = d3 * d6 - d5 * d4;
  if (va <= 0.0 && d4 - d3 >= 0.0 && d5 - d6 >= 0.0)
    return at(t.b + (d4 - d3) / ((d4 - d3) + (d5 - d6)) * (t.c - t.b), Feature::edge_bc, p);
  const double share = 1.0 / (va + vb + vc);
  return at(t.a + vb * share * ab + vc * share * ac, Feature::face, p);
}

TriangleSurface::TriangleSurface(const QuadMesh& mesh) {
  const std::vector<int> vertex_of_point = weld(mesh.points, vertices_);
  triangles_.reserve(2 * mesh.quads.size());
  for (std::size_t q = 0; q < mesh.quads.size(); ++q) add_quad(mesh, vertex_of_point, static_cast<int>(q));
  make_face_and_vertex_normals();
  make_edge_normals();
}

// Split along the shorter diagonal, unless that makes a triangle of no area where the other one does not.
// Repeated corners leave one of the two without area.
void TriangleSurface::add_quad(const QuadMesh& mesh, const std::vector<int>& vertex_of_point, int quad) {
  std::array<int, 4> v{};
  for (int k = 0; k < 4; ++k) v[k] = vertex_of_point[mesh.quads[quad][k]];
  const auto good = [&](int i, int j, int k) {
    return has_area(vertices_[v[i]], vertices_[v[j]], vertices_[v[k]]);
  };
  const auto add = [&](int i, int j, int k) {
    if (good(i, j, k)) triangles_.push_back({{v[i], v[j], v[k]}, {-1, -1, -1}, quad});
  };
  const double d02 = (vertices_[v[0]] - vertices_[v[2]]).squaredNorm();
  const double d13 = (vertices_[v[1]] - vertices_[v[3]]).squaredNorm();
  const bool good02 = good(0, 1, 2) && good(0, 2, 3), good13 = good(0, 1, 3) && good(1, 2, 3);
  const bool is_triangle = v[0] == v[1] || v[1] == v[2] || v[2] == v[3] || v[3] == v[0];
  if (is_triangle || (good02 == good13 ? d02 <= d13 : good02)) {
    add(0, 1, 2), add(0, 2, 3);
  } else {
    add(0, 1, 3), add(1, 2, 3);
  }
}

void TriangleSurface::make_face_and_vertex_normals() {
  vertex_normal_.assign(vertices_.size(), Vec3::Zero());
  face_normal_.reserve(triangles_.size());
  for (std::size_t t = 0; t < triangles_.size(); ++t) {
    const auto [a, b, c] = corners(t);
    const Vec3 n = (b - a).cross(c - a).normalized();
    face_normal_.push_back(n);
    vertex_normal_[triangles_[t].vertex[0]] += angle_between(b - a, c - a) * n;
    vertex_normal_[triangles_[t].vertex[1]] += angle_between(c - b, a - b) * n;
    vertex_normal_[triangles_[t].vertex[2]] += angle_between(a - c, b - c) * n;
  }
  for (Vec3& n : vertex_normal_) n.normalize();
}

void TriangleSurface::make_edge_normals() {
  struct Side {
    int low, high;
    bool forward;
    int triangle, k;
  };
  std::vector<Side> sides;
  sides.reserve(3 * triangles_.size());
  for (std::size_t t = 0; t < triangles_.size(); ++t)
    for (int k = 0; k < 3; ++k) {
      const int from = triangles_[t].vertex[k], to = triangles_[t].vertex[(k + 1) % 3];
      sides.push_back({std::min(from, to), std::max(from, to), from < to, static_cast<int>(t), k});
    }
  std::sort(sides.begin(), sides.end(), [](const Side& s, const Side& r) {
    return std::tie(s.low, s.high, s.forward) < std::tie(r.low, r.high, r.forward);
  });
  std::size_t open = 0, edges = 0;
  edge_normal_.reserve(sides.size() / 2);
  for (std::size_t i = 0, end = 0; i < sides.size(); i = end) {
    while (end < sides.size() && sides[end].low == sides[i].low && sides[end].high == sides[i].high) ++end;
    ++edges;
    if (end - i != 2 || sides[i].forward == sides[i + 1].forward) ++open;
    Vec3 n = Vec3::Zero();
    for (std::size_t s = i; s < end; ++s) {
      n += face_normal_[sides[s].triangle];
      triangles_[sides[s].triangle].edge[sides[s].k] = static_cast<int>(edge_normal_.size());
    }
    edge_normal_.push_back(n.normalized());
  }
  if (open > 0)
    throw InputError("the hull's surface is not closed: " + std::to_string(open) + " of " +
                     std::to_string(edges) + " edges do not join exactly two panels of the same orientation");
}

Corners TriangleSurface::corners(std::size_t triangle) const {
  const auto& v = triangles_[triangle].vertex;
  return {vertices_[v[0]], vertices_[v[1]], vertices_[v[2]]};
}

const Vec3& TriangleSurface::normal(std::size_t triangle, Feature feature) const {
  const Triangle& t = triangles_[triangle];
  switch (feature) {
    case Feature::vertex_a:
      return vertex_normal_[t.vertex[0]];
    case Feature::vertex_b:
      return vertex_normal_[t.vertex[1]];
    case Feature::vertex_c:
      return vertex_normal_[t.vertex[2]];
    case Feature::edge_ab:
      return edge_normal_[t.edge[0]];
    case Feature::edge_bc:
      return edge_normal_[t.edge[1]];
    case Feature::edge_ca:
      return edge_normal_[t.edge[2]];
    case Feature::face:
      break;
  }
  return face_normal_[triangle];
}

std::size_t TriangleSurface::bytes() const {
  const std::size_t vectors =
      vertices_.size() + face_normal_.size() + edge_normal_.size() + vertex_normal_.size();
  return vectors * sizeof(Vec3) + triangles_.size() * sizeof(Triangle);
}

}  // namespace icebow
