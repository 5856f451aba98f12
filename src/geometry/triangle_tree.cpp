#include "geometry/triangle_tree.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace icebow {
namespace {

constexpr int triangles_per_leaf = 3;
constexpr float infinity = std::numeric_limits<float>::infinity();

// Rounded outwards, so that a box of floats holds its triangles of doubles.
float below(double x) {
  return std::nextafter(static_cast<float>(x), -infinity);
}
float above(double x) {
  return std::nextafter(static_cast<float>(x), infinity);
}

Vec3 centroid(const Corners& t) {
  return (t.a + t.b + t.c) / 3.0;
}

}  // namespace

TriangleTree::TriangleTree(const TriangleSurface& surface) {
  const int n = static_cast<int>(surface.size());
  leaves_.reserve(n);
  for (int t = 0; t < n; ++t) leaves_.push_back({surface.corners(t), t});
  if (n > 0) build(0, n);
}

TriangleTree::Box3f TriangleTree::box_of(int first, int count) const {
  Vec3 lower = Vec3::Constant(std::numeric_limits<double>::infinity()), upper = -lower;
  for (int s = first; s < first + count; ++s) {
    const Corners& t = leaves_[s].corners;
    lower = lower.cwiseMin(t.a).cwiseMin(t.b).cwiseMin(t.c);
    upper = upper.cwiseMax(t.a).cwiseMax(t.b).cwiseMax(t.c);
  }
  return {{below(lower.x()), below(lower.y()), below(lower.z())},
          {above(upper.x()), above(upper.y()), above(upper.z())}};
}

// Halves the slots at the median centroid along the longest axis; returns the number of the node.
int TriangleTree::build(int first, int count) {
  const Box3f box = box_of(first, count);
  int axis = 0;
  for (int k = 1; k < 3; ++k)
    if (box.upper[k] - box.lower[k] > box.upper[axis] - box.lower[axis]) axis = k;
  const int half = count / 2;
  const auto begin = leaves_.begin() + first;
  std::nth_element(begin, begin + half, begin + count, [axis](const Leaf& l, const Leaf& r) {
    return centroid(l.corners)[axis] < centroid(r.corners)[axis];
  });
  const int node = static_cast<int>(nodes_.size());
  nodes_.emplace_back();
  const int firsts[2] = {first, first + half}, counts[2] = {half, count - half};
  for (int side = 0; side < 2; ++side) {
    nodes_[node].box[side] = box_of(firsts[side], counts[side]);
    nodes_[node].count[side] = counts[side];
    const int child = counts[side] <= triangles_per_leaf ? ~firsts[side] : build(firsts[side], counts[side]);
    nodes_[node].child[side] = child;
  }
  return node;
}

double TriangleTree::squared_distance(const Box3f& box, const Vec3& p) {
  double sum = 0.0;
  for (int k = 0; k < 3; ++k) {
    const double gap = std::max(0.0, std::max(box.lower[k] - p[k], p[k] - box.upper[k]));
    sum += gap * gap;
  }
  return sum;
}

NearestTriangle TriangleTree::no_triangle() {
  NearestTriangle none;
  none.at.squared_distance = std::numeric_limits<double>::infinity();
  return none;
}

double TriangleTree::improve(int slot, const Vec3& p, NearestTriangle& best) const {
  const TrianglePoint at = closest_on_triangle(leaves_[slot].corners, p);
  const double gain = best.at.squared_distance - at.squared_distance;
  if (gain > 0.0 || (gain == 0.0 && leaves_[slot].triangle < best.triangle))
    best = {at, leaves_[slot].triangle, slot};
  return at.squared_distance;
}

// Calls visit(slot) for the triangles of all leaves whose box may be nearer to p than sqrt(bound()), near
// ones first.
template <class Bound, class Visit>
void TriangleTree::search(const Vec3& p, const Bound& bound, const Visit& visit) const {
  struct Pending {
    std::int32_t child, count;
    double squared_distance;
  };
  if (nodes_.empty()) return;
  // Halving keeps the tree shallower than 32 levels, and each level leaves at most one child pending.
  std::array<Pending, 64> stack;
  int pending = 0;
  stack[pending++] = {0, size(), 0.0};
  // Boxes exactly at the bound are opened, with room for rounding: ties go to the lowest number.
  const auto worth_opening = [&](double box) { return box <= bound() * (1.0 + 1e-12); };
  while (pending > 0) {
    const Pending next = stack[--pending];
    if (!worth_opening(next.squared_distance)) continue;
    if (next.child < 0) {
      for (int s = ~next.child; s < ~next.child + next.count; ++s) visit(s);
      continue;
    }
    const Node& node = nodes_[next.child];
    const double box[2] = {squared_distance(node.box[0], p), squared_distance(node.box[1], p)};
    const int near = box[0] <= box[1] ? 0 : 1, far = 1 - near;
    if (worth_opening(box[far])) stack[pending++] = {node.child[far], node.count[far], box[far]};
    if (worth_opening(box[near])) stack[pending++] = {node.child[near], node.count[near], box[near]};
  }
}

NearestTriangle TriangleTree::closest(const Vec3& p, int seed_slot) const {
  NearestTriangle best = no_triangle();
  if (seed_slot >= 0) improve(seed_slot, p, best);
  search(
      p, [&] { return best.at.squared_distance; }, [&](int slot) { improve(slot, p, best); });
  return best;
}

void TriangleTree::within(const Vec3& p, double radius, std::vector<Near>& found) const {
  found.clear();
  search(
      p, [&] { return radius * radius; },
      [&](int slot) {
        const double distance = std::sqrt(closest_on_triangle(leaves_[slot].corners, p).squared_distance);
        if (distance <= radius) found.push_back({slot, distance});
      });
}

}  // namespace icebow
