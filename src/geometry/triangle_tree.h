// A tree of bounding boxes over triangles that finds the closest one to a point.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "geometry/triangle_surface.h"

namespace icebow {

struct NearestTriangle {
  TrianglePoint at;
  int triangle = -1;  // of the surface; the lowest number where several are equally near
  int slot = -1;      // its place in the tree, a seed for queries near by
};

class TriangleTree {
 public:
  explicit TriangleTree(const TriangleSurface& surface);

  // Exact whatever the seed, the faster the nearer that triangle is to p. slot = -1: no seed.
  NearestTriangle closest(const Vec3& p, int seed_slot = -1) const;
  // Lets the triangle of one slot compete. `best` may come from an earlier search for the same p, or be
  // no_triangle(). Returns this triangle's squared distance.
  double improve(int slot, const Vec3& p, NearestTriangle& best) const;
  static NearestTriangle no_triangle();
  // Slots of all triangles within the radius of p, and their distances (in no order); clears `found` first.
  struct Near {
    int slot;
    double distance;
  };
  void within(const Vec3& p, double radius, std::vector<Near>& found) const;
  int triangle(int slot) const { return leaves_[slot].triangle; }
  int size() const { return static_cast<int>(leaves_.size()); }
  std::size_t bytes() const { return leaves_.size() * sizeof(Leaf) + nodes_.size() * sizeof(Node); }

 private:
  struct Leaf {
    Corners corners;
    int triangle;
  };
  struct Box3f {
    float lower[3], upper[3];
  };
  // Both children's boxes in their parent: one cache line a visit. child >= 0 is a node, else ~child the
  // first slot.
  struct alignas(64) Node {
    Box3f box[2];
    std::int32_t child[2];
    std::int32_t count[2];
  };

  Box3f box_of(int first, int count) const;
  int build(int first, int count);
  template <class Bound, class Visit>
  void search(const Vec3& p, const Bound& bound, const Visit& visit) const;
  static double squared_distance(const Box3f& box, const Vec3& p);

  std::vector<Leaf> leaves_;
  std::vector<Node> nodes_;
};

}  // namespace icebow
