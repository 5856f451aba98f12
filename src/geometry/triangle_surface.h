// A closed quad mesh as triangles, with what the sign of a distance needs: the outward normals of faces,
// edges and vertices. Edge and vertex normals are the angle-weighted pseudo-normals of Baerentzen and Aanaes
// 2005, with which the sign is right wherever the closest point lies.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "geometry/quad_mesh.h"

namespace icebow {

// Corners by value: the distance loop reads nothing else.
struct Corners {
  Vec3 a, b, c;
};

// Where on a triangle its closest point lies.
enum class Feature : std::uint8_t { vertex_a, vertex_b, vertex_c, edge_ab, edge_bc, edge_ca, face };

struct TrianglePoint {
  double squared_distance;
  Vec3 point;
  Feature feature;
};

// Ericson 2005, section 5.1.5. The triangle must have an area.
TrianglePoint closest_on_triangle(const Corners& t, const Vec3& p);

class TriangleSurface {
 public:
  // Points with equal coordinates are one vertex; panels of no area are left out. Throws InputError where the
  // surface is not closed: each edge must belong to two triangles that run through it in opposite directions.
  explicit TriangleSurface(const QuadMesh& mesh);

  std::size_t size() const { return triangles_.size(); }
  Corners corners(std::size_t triangle) const;
  int quad(std::size_t triangle) const { return triangles_[triangle].quad; }
  // Outward unit (pseudo-)normal of a feature of the triangle.
  const Vec3& normal(std::size_t triangle, Feature feature) const;
  std::size_t bytes() const;

 private:
  struct Triangle {
    std::array<int, 3> vertex;  // a, b, c
    std::array<int, 3> edge;    // ab, bc, ca
    int quad;
  };

  void add_quad(const QuadMesh& mesh, const std::vector<int>& vertex_of_point, int quad);
  void make_face_and_vertex_normals();
  void make_edge_normals();

  std::vector<Vec3> vertices_;
  std::vector<Triangle> triangles_;
  std::vector<Vec3> face_normal_, edge_normal_, vertex_normal_;
};

}  // namespace icebow
