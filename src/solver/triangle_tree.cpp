#include "solver/triangle_tree.h"

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

void TriangleTree::visit(int first, int count, const Vec3& p, NearestTriangle& best) const {
  for (int s = first; s < first + count; ++s) {
    const TrianglePoint at = closest_on_triangle(leaves_[s].corners, p);
    const double gain = best.at.squared_distance - at.squared_distance;
    if (gain > 0.0 || (gain == 0.0 && leaves_[s].triangle < best.triangle))
      best = {at, leaves_[s].triangle, s};
  }
}

NearestTriangle TriangleTree::closest(const Vec3& p, int seed_slot) const {
  NearestTriangle best;
  best.at.squared_distance = std::numeric_limits<double>::infinity();
  if (nodes_.empty()) return best;
  if (seed_slot >= 0) visit(seed_slot, 1, p, best);

  struct Pending {
    std::int32_t child, count;
    double bound;
  };
  // Halving keeps the tree shallower than 32 levels, and each level leaves at most one child pending.
  std::array<Pending, 64> stack;
  int pending = 0;
  stack[pending++] = {0, std::numeric_limits<std::int32_t>::max(), 0.0};
  // Boxes as near as the best triangle are opened too, with room for rounding: ties go to the lowest number.
  const auto worth_opening = [&](double bound) { return bound <= best.at.squared_distance * (1.0 + 1e-12); };
  while (pending > 0) {
    const Pending next = stack[--pending];
    if (!worth_opening(next.bound)) continue;
    if (next.child < 0) {
      visit(~next.child, next.count, p, best);
      continue;
    }
    const Node& node = nodes_[next.child];
    const double bound[2] = {squared_distance(node.box[0], p), squared_distance(node.box[1], p)};
    const int near = bound[0] <= bound[1] ? 0 : 1, far = 1 - near;
    if (worth_opening(bound[far])) stack[pending++] = {node.child[far], node.count[far], bound[far]};
    if (worth_opening(bound[near])) stack[pending++] = {node.child[near], node.count[near], bound[near]};
  }
  return best;
}

}  // namespace icebow
