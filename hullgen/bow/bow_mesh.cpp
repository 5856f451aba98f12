// The hull has the topology of a tube with two ends: the bow patch, a grid of columns (j, along y, starboard
// to port) and rows (i, keel to deck), is the front end; its boundary ring runs aft as bottom, port side,
// deck and starboard side to the transom. Stations aft of the bow thin the ring out as panels grow.
#include "hullgen/bow/bow_mesh.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "hullgen/bow/bow_grid.h"
#include "hullgen/bow/bow_surface.h"
#include "hullgen/bow/ring_thinning.h"
#include "hullgen/bow/skeg.h"
#include "hullgen/bow/spacing.h"

namespace icebow {
namespace {

class HullBuilder {
 public:
  HullBuilder(const BowSurface& bow, const BowGrid& grid, const Skeg& skeg, double L, double panel);
  QuadMesh build();

 private:
  int ny() const { return static_cast<int>(grid_.eta.size()) - 1; }  // columns of one side
  int nz() const { return static_cast<int>(grid_.z.size()) - 1; }
  int front(GridNode c) const { return (c.j + ny()) * (nz() + 1) + c.i; }
  Vec3 front_point(GridNode c) const;
  Vec3 tube_point(GridNode c) const;  // where the ship's own beam begins: behind the reamers
  bool kept(GridNode c) const { return thinning_.column(c.j) && thinning_.row(c.i); }
  Patch patch(GridNode from, GridNode to) const;

  void add(Patch patch, int a, int b, int c, int d);
  void add_bow();
  void add_reamers();
  std::vector<double> stations() const;
  void add_tube();
  void join(const std::vector<int>& fore, const std::vector<int>& aft);
  void add_transom();

  const BowSurface& bow_;
  const BowGrid& grid_;
  const Skeg& skeg_;
  double L_, panel_;
  RingThinning thinning_;
  bool on_reamer_ = false;      // the current station is on the step
  std::vector<GridNode> ring_;  // counter-clockwise seen from ahead
  std::vector<int> station_;    // point of each ring place at the current station, -1 where thinned out
  QuadMesh mesh_;
};

HullBuilder::HullBuilder(const BowSurface& bow, const BowGrid& grid, const Skeg& skeg, double L, double panel)
    : bow_(bow),
      grid_(grid),
      skeg_(skeg),
      L_(L),
      panel_(panel),
      thinning_(bow, grid, skeg.half_width, panel) {
  for (int j = -ny(); j < ny(); ++j) ring_.push_back({j, 0});
  for (int i = 0; i < nz(); ++i) ring_.push_back({ny(), i});
  for (int j = ny(); j > -ny(); --j) ring_.push_back({j, nz()});
  for (int i = nz(); i > 0; --i) ring_.push_back({-ny(), i});
}

Vec3 HullBuilder::front_point(GridNode c) const {
  Vec3 p = bow_.point(grid_.eta[std::abs(c.j)], grid_.z[c.i]);
  if (c.j < 0) p.y() = -p.y();
  return p;
}

// The step of a reamer faces aft at 45 deg; bottom and deck draw in with it.
Vec3 HullBuilder::tube_point(GridNode c) const {
  Vec3 p = front_point(c);
  if (bow_.reamer == 0.0) return p;
  p.x() -= bow_.reamer;
  p.y() *= 1.0 - bow_.reamer / bow_.half_breadth(p.z());
  return p;
}

Patch HullBuilder::patch(GridNode from, GridNode to) const {
  if (from.i == 0 && to.i == 0) return Patch::bottom;
  if (from.i == nz() && to.i == nz()) return Patch::deck;
  return on_reamer_ ? Patch::reamer : Patch::side;
}

void HullBuilder::add(Patch patch, int a, int b, int c, int d) {
  mesh_.quads.push_back({a, b, c, d});
  mesh_.patch.push_back(patch);
}

void HullBuilder::add_bow() {
  for (int j = -ny(); j <= ny(); ++j)
    for (int i = 0; i <= nz(); ++i) mesh_.points.push_back(front_point({j, i}));
  for (int j = -ny(); j < ny(); ++j)
    for (int i = 0; i < nz(); ++i)
      add(Patch::bow, front({j, i}), front({j + 1, i}), front({j + 1, i + 1}), front({j, i + 1}));
}

// Panels between two stations; where the aft one has lost a point, three triangles around it.
void HullBuilder::join(const std::vector<int>& fore, const std::vector<int>& aft) {
  const int n = static_cast<int>(ring_.size());
  for (int a = 0; a < n;) {
    int b = a + 1, middle = -1;
    for (; aft[b % n] < 0; ++b)
      if (fore[b] >= 0) middle = fore[b];
    const int fa = fore[a], fb = fore[b % n], ga = aft[a], gb = aft[b % n];
    const Patch side = patch(ring_[a], ring_[b % n]);
    if (middle < 0) {
      add(side, fa, ga, gb, fb);
    } else {
      add(side, fa, ga, middle, middle);
      add(side, ga, gb, middle, middle);
      add(side, middle, gb, fb, fb);
    }
    a = b;
  }
}

void HullBuilder::add_reamers() {
  if (bow_.reamer == 0.0) return;
  on_reamer_ = true;
  const int cells = std::max(1, static_cast<int>(std::lround(std::sqrt(2.0) * bow_.reamer / panel_)));
  for (int k = 1; k <= cells; ++k) {
    std::vector<int> next;
    for (const GridNode& c : ring_) {
      next.push_back(static_cast<int>(mesh_.points.size()));
      const Vec3 from = front_point(c);
      mesh_.points.push_back(from + static_cast<double>(k) / cells * (tube_point(c) - from));
    }
    join(station_, next);
    station_ = next;
  }
  on_reamer_ = false;
}

// By their share of the way from the bow's edge to the transom, measured along the side at the waterline. The
// ends of a skeg begin and end at stations.
std::vector<double> HullBuilder::stations() const {
  const double length = L_ - (bow_.Lf - bow_.setback) - bow_.reamer;
  const auto along = [&](double share) { return Vec3(share * length, 0.0, 0.0); };
  std::vector<double> ends = skeg_.shares(), shares{0.0};
  ends.push_back(1.0);
  for (const double end : ends) {
    const double from = shares.back();
    if (end - from < 1e-9) continue;
    const auto wanted = [&](double, double run) {
      return std::min(panel_ + 0.25 * (from * length + run), thinning_.longest_cell());
    };
    const std::vector<double> piece = graded(along, from, end, wanted, ends.size() == 1 ? 4 : 1);
    shares.insert(shares.end(), piece.begin() + 1, piece.end());
  }
  return shares;
}

void HullBuilder::add_tube() {
  const double length = L_ - (bow_.Lf - bow_.setback) - bow_.reamer;
  const std::vector<double> shares = stations();
  for (std::size_t k = 1; k < shares.size(); ++k) {
    const double cell = (shares[k] - shares[k - 1]) * length;
    const auto place = [&](GridNode c) {
      Vec3 p = tube_point(c);
      p.x() += shares[k] * (-L_ - p.x());
      if (c.i == 0) p.z() -= skeg_.depth(shares[k], grid_.eta[std::abs(c.j)]);
      return p;
    };
    thinning_.advance(cell, place);
    std::vector<int> next;
    for (const GridNode& c : ring_) {
      next.push_back(kept(c) ? static_cast<int>(mesh_.points.size()) : -1);
      if (next.back() >= 0) mesh_.points.push_back(place(c));
    }
    join(station_, next);
    station_ = next;
  }
}

void HullBuilder::add_transom() {
  std::vector<int> columns, rows;
  for (int j = -ny(); j <= ny(); ++j)
    if (thinning_.column(j)) columns.push_back(j);
  for (int i = 0; i <= nz(); ++i)
    if (thinning_.row(i)) rows.push_back(i);
  std::vector<int> id(static_cast<std::size_t>(2 * ny() + 1) * (nz() + 1), -1);  // by front()
  for (std::size_t r = 0; r < ring_.size(); ++r) id[front(ring_[r])] = station_[r];
  for (int j : columns)
    for (int i : rows) {
      int& point = id[front({j, i})];
      if (point >= 0) continue;
      point = static_cast<int>(mesh_.points.size());
      const Vec3 p = tube_point({j, i});
      mesh_.points.push_back(Vec3(-L_, p.y(), p.z()));
    }
  for (std::size_t c = 1; c < columns.size(); ++c)
    for (std::size_t r = 1; r < rows.size(); ++r) {
      const int j0 = columns[c - 1], j1 = columns[c], i0 = rows[r - 1], i1 = rows[r];
      add(Patch::transom, id[front({j0, i0})], id[front({j0, i1})], id[front({j1, i1})], id[front({j1, i0})]);
    }
}

QuadMesh HullBuilder::build() {
  add_bow();
  for (const GridNode& c : ring_) station_.push_back(front(c));
  add_reamers();
  add_tube();
  add_transom();
  return std::move(mesh_);
}

}  // namespace

double panel_size(const BowParameters& bow) {
  return bow.panel > 0.0 ? bow.panel : bow.B / 60.0;
}

QuadMesh bow_mesh(const BowParameters& bow) {
  const BowSurface surface = bow_surface(bow);
  const double panel = panel_size(bow);
  const Skeg skeg = skeg_of(bow);
  const BowGrid grid =
      bow_grid(surface, panel, family_form(bow.family).graded_by_curvature, {skeg.half_width});
  return HullBuilder(surface, grid, skeg, bow.L, panel).build();
}

}  // namespace icebow
