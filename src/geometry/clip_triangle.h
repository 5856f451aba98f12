// The part of a triangle in a slab; three slabs make a cell.
#pragma once

#include <array>

#include "geometry/triangle_surface.h"

namespace icebow {

// Corners of a convex polygon: each of a cell's six planes adds at most one to the triangle's three.
struct Polygon {
  std::array<Vec3, 9> corner;
  int size = 0;

  explicit Polygon(const Corners& t) : corner{t.a, t.b, t.c}, size(3) {}
  double lower(int axis) const;
  double upper(int axis) const;
};

// Cuts off what lies outside from <= x[axis] <= to (Sutherland and Hodgman 1974). Nothing may be left: size
// 0.
void clip(Polygon& polygon, int axis, double from, double to);
double area(const Polygon& polygon);

}  // namespace icebow
