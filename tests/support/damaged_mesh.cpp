#include "tests/support/damaged_mesh.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <functional>
#include <random>
#include <set>
#include <vector>

#include "geometry/triangles.h"

using namespace icebow;

namespace {

class Damage {
 public:
  Damage(const QuadMesh& sound, std::uint64_t seed) : random_(seed) {
    result_.mesh = sound;
    const Box box = bounding_box(sound);
    lower_ = box.lower;
    size_ = box.upper - box.lower;
  }

  DamagedMesh done() {
    static const std::vector<std::pair<const char*, void (Damage::*)()>> kinds = {
        {"turned over", &Damage::turn_over},
        {"T-junctions", &Damage::split_one_side},
        {"gaps", &Damage::tear},
        {"panels left out", &Damage::leave_out},
        {"slivers", &Damage::add_slivers},
        {"given twice", &Damage::repeat},
        {"loose triangles", &Damage::add_islands},
        {"tank inside", &Damage::add_tank},
        {"bulkhead", &Damage::add_bulkhead},
        {"deckhouse", &Damage::add_deckhouse},
        {"all triangles", &Damage::triangulate},
        {"coordinates in millimetres", &Damage::round_off},
        {"panels with points of their own", &Damage::part_panels},
        {"no deck", &Damage::open_deck},
        {"one panel as two", &Damage::slice},
        {"all turned over", &Damage::turn_all}};
    std::set<std::size_t> chosen;
    const int wanted = 1 + below(3);
    while (static_cast<int>(chosen.size()) < wanted)
      chosen.insert(static_cast<std::size_t>(below(static_cast<int>(kinds.size()))));
    for (const std::size_t k : chosen) {
      (this->*kinds[k].second)();
      result_.damage += (result_.damage.empty() ? "" : ", ") + std::string(kinds[k].first);
    }
    return result_;
  }

 private:
  using Quad = std::array<int, 4>;
  int below(int n) { return static_cast<int>(random_() % static_cast<std::uint64_t>(n)); }
  double share() { return static_cast<double>(random_() >> 11) * 0x1p-53; }
  QuadMesh& mesh() { return result_.mesh; }
  std::size_t panel() { return static_cast<std::size_t>(below(static_cast<int>(mesh().quads.size()))); }
  std::size_t some(double largest_share) {
    return 1 + static_cast<std::size_t>(share() * largest_share * static_cast<double>(mesh().quads.size()));
  }
  int add_point(const Vec3& p) {
    mesh().points.push_back(p);
    return static_cast<int>(mesh().points.size()) - 1;
  }
  void add(const Quad& q) {
    mesh().quads.push_back(q);
    mesh().patch.push_back(Patch::other);
  }
  static Quad over(const Quad& q) {
    return q[2] == q[3] ? Quad{q[0], q[2], q[1], q[1]} : Quad{q[0], q[3], q[2], q[1]};
  }

  void turn_over() {
    for (std::size_t n = some(0.3); n > 0; --n) {
      const std::size_t k = panel();
      mesh().quads[k] = over(mesh().quads[k]);
    }
  }
  void turn_all() {
    for (Quad& q : mesh().quads) q = over(q);
  }
  void triangulate() {
    const auto facets = triangles(mesh());
    mesh().quads.clear();
    for (const auto& t : facets) mesh().quads.push_back({t[0], t[1], t[2], t[2]});
    mesh().patch.assign(facets.size(), Patch::other);
  }

  // A panel's edge gets a point in its middle that the panel beside it does not know of.
  void split_one_side() {
    for (std::size_t n = some(0.05); n > 0; --n) {
      const std::size_t k = panel();
      const Quad q = mesh().quads[k];
      const bool triangle = q[2] == q[3];
      const int middle = add_point(0.5 * (mesh().points[q[0]] + mesh().points[q[1]]));
      mesh().quads[k] = triangle ? Quad{middle, q[1], q[2], q[2]} : Quad{middle, q[1], q[2], q[3]};
      add(triangle ? Quad{q[0], middle, q[2], q[2]} : Quad{q[0], middle, q[3], q[3]});
    }
  }
  // A corner of a panel becomes a point of its own, a little off.
  void tear() {
    const double widest = std::pow(10.0, -6.0 + 3.5 * share());  // m
    for (std::size_t n = some(0.1); n > 0; --n) {
      const std::size_t k = panel();
      const int corner = below(3);
      Quad& q = mesh().quads[k];
      const Vec3 off(share() - 0.5, share() - 0.5, share() - 0.5);
      const int own = add_point(mesh().points[q[corner]] + widest * off);
      const int was = q[corner];
      for (int& c : q)
        if (c == was) c = own;
    }
  }
  void round_off() {
    for (Vec3& p : mesh().points)
      for (int k = 0; k < 3; ++k) p[k] = std::round(1e3 * p[k]) / 1e3;
  }
  void part_panels() {
    std::vector<Vec3> own;
    for (Quad& q : mesh().quads) {
      const bool triangle = q[2] == q[3];
      for (int k = 0; k < (triangle ? 3 : 4); ++k) {
        own.push_back(mesh().points[q[k]]);
        q[k] = static_cast<int>(own.size()) - 1;
      }
      if (triangle) q[3] = q[2];
    }
    mesh().points = std::move(own);
  }
  void open_deck() {
    for (std::size_t k = mesh().quads.size(); k-- > 0;) {
      const Quad& q = mesh().quads[k];
      const auto& p = mesh().points;
      const double top = lower_.z() + size_.z() - 1e-3;
      if (p[q[0]].z() < top || p[q[1]].z() < top || p[q[2]].z() < top || p[q[3]].z() < top) continue;
      mesh().quads.erase(mesh().quads.begin() + static_cast<std::ptrdiff_t>(k));
      mesh().patch.erase(mesh().patch.begin() + static_cast<std::ptrdiff_t>(k));
    }
  }
  // A panel cut in two, with the new points in the edges of its neighbours too, as a slicing program does it:
  // those neighbours get five corners, which is two panels again.
  void slice() {
    for (int n = 1 + below(20); n > 0; --n) {
      const std::size_t k = panel();
      const Quad q = mesh().quads[k];
      const auto beside = std::find_if(mesh().quads.begin(), mesh().quads.end(), [&](const Quad& o) {
        for (int c = 0; c < 4; ++c)
          if (o[c] == q[1] && o[(c + 1) % 4] == q[0]) return true;
        return false;
      });
      if (beside == mesh().quads.end()) continue;
      const auto other = beside - mesh().quads.begin();
      const int middle = add_point(0.5 * (mesh().points[q[0]] + mesh().points[q[1]]));
      for (const std::size_t own : {k, static_cast<std::size_t>(other)}) cut_at(own, q[0], q[1], middle);
    }
  }
  void cut_at(std::size_t panel, int a, int b, int middle) {
    Quad q = mesh().quads[panel];
    const bool triangle = q[2] == q[3];
    const int n = triangle ? 3 : 4;
    int at = 0;
    while (at < n && !((q[at] == a && q[(at + 1) % n] == b) || (q[at] == b && q[(at + 1) % n] == a))) ++at;
    if (at == n) return;
    std::rotate(q.begin(), q.begin() + at, q.begin() + n);
    if (triangle) q[3] = q[2];
    mesh().quads[panel] = triangle ? Quad{middle, q[1], q[2], q[2]} : Quad{middle, q[1], q[2], q[3]};
    add(triangle ? Quad{q[0], middle, q[2], q[2]} : Quad{q[0], middle, q[3], q[3]});
  }
  void leave_out() {
    for (int n = 1 + below(3); n > 0; --n) {
      const auto k = static_cast<std::ptrdiff_t>(panel());
      mesh().quads.erase(mesh().quads.begin() + k);
      mesh().patch.erase(mesh().patch.begin() + k);
    }
  }
  // Triangles along an edge: its own point in the middle, no height or next to none.
  void add_slivers() {
    for (int n = 1 + below(8); n > 0; --n) {
      const Quad q = mesh().quads[panel()];
      const int middle = add_point(0.5 * (mesh().points[q[0]] + mesh().points[q[1]]));
      add({q[0], middle, q[1], q[1]});
    }
  }
  void repeat() {
    for (int n = 1 + below(20); n > 0; --n) {
      const Quad q = mesh().quads[panel()];
      add(below(2) == 0 ? q : over(q));
    }
  }
  void add_islands() {
    for (int n = 1 + below(5); n > 0; --n) {
      const Vec3 at = lower_ + size_.cwiseProduct(Vec3(share(), share(), share()));
      const Vec3 away = below(2) == 0 ? at : Vec3(at + Vec3(0.0, 2.0 * size_.y(), 0.0));
      const double edge = 0.05 + 0.3 * share();
      const int a = add_point(away), b = add_point(away + Vec3(edge, 0.0, 0.0)),
                c = add_point(away + Vec3(0.0, edge, edge));
      add({a, b, c, c});
    }
  }
  void add_box(const Vec3& low, const Vec3& high) {
    std::array<int, 8> p;
    for (int k = 0; k < 8; ++k)
      p[k] = add_point({k & 1 ? high.x() : low.x(), k & 2 ? high.y() : low.y(), k & 4 ? high.z() : low.z()});
    add({p[0], p[2], p[3], p[1]}), add({p[4], p[5], p[7], p[6]}), add({p[0], p[1], p[5], p[4]});
    add({p[2], p[6], p[7], p[3]}), add({p[0], p[4], p[6], p[2]}), add({p[1], p[3], p[7], p[5]});
  }
  void add_tank() {
    const double x = lower_.x() + (0.1 + 0.2 * share()) * size_.x();
    add_box({x, -0.2 * size_.y(), lower_.z() + 0.3 * size_.z()},
            {x + 0.1 * size_.x(), 0.2 * size_.y(), lower_.z() + (0.4 + 0.4 * share()) * size_.z()});
  }
  void add_deckhouse() {
    const double x = lower_.x() + (0.1 + 0.2 * share()) * size_.x(), top = lower_.z() + size_.z();
    add_box({x, -0.25 * size_.y(), top - 0.05 * size_.z()},
            {x + 0.1 * size_.x(), 0.25 * size_.y(), top + 5.0});
  }
  // A wall between four points of the hull's side, well inside: a panel no body has.
  void add_bulkhead() {
    const Quad q = mesh().quads[panel()];
    const Vec3 inward = 0.5 * (mesh().points[q[0]] + mesh().points[q[1]]);
    const Vec3 middle(
        inward.x() - 0.02 * size_.x() * (inward.x() > lower_.x() + 0.5 * size_.x() ? 1.0 : -1.0),
        0.6 * inward.y(), lower_.z() + 0.6 * size_.z());
    const int tip = add_point(middle);
    add({q[0], q[1], tip, tip});
  }

  std::mt19937_64 random_;
  DamagedMesh result_;
  Vec3 lower_ = Vec3::Zero(), size_ = Vec3::Zero();
};

}  // namespace

DamagedMesh damaged(const QuadMesh& sound, std::uint64_t seed) {
  return Damage(sound, seed).done();
}
