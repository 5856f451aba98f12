#include "solver/contact/contact.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace icebow {
namespace {

constexpr float ever = std::numeric_limits<float>::max();

// Coulomb: the hull drags the sliding particle, at most to its own speed.
Vec3 friction(double mu, const Vec3& relative_velocity, const Vec3& normal, double normal_delta_v) {
  const Vec3 tangential = relative_velocity - relative_velocity.dot(normal) * normal;
  const double speed = tangential.norm();
  if (speed == 0.0) return Vec3::Zero();
  return -std::min(1.0, mu * normal_delta_v / speed) * tangential;
}

// A bit for each particle of a block that may be inside after it has moved, and what the others may move.
unsigned use_up(float moved, float* rest, float& least) {
  for (int l = 0; l < block; ++l) rest[l] -= moved;
  least = ever;
  unsigned due = 0;
  for (int l = 0; l < block; ++l) {
    due |= static_cast<unsigned>(!(rest[l] > 0.0F)) << l;
    least = std::min(least, rest[l] > 0.0F ? rest[l] : ever);
  }
  return due;
}

}  // namespace

double CrushingLaw::bearable(double depth) const {
  const double rise = ramp * dx;
  return strength * (std::clamp(depth / rise, 0.0, 1.0) - std::clamp((depth - dx) / rise, 0.0, 1.0));
}

double CrushingLaw::force(double depth, double& crushed) const {
  const double elastic = std::max(0.0, stiffness * (depth - crushed)), most = bearable(depth);
  if (elastic <= most) return elastic;
  crushed = depth - most / stiffness;
  return most;
}

// Stiff enough that what it stores is nothing beside the work of crushing (2 p_c/E of it, some 0.4 %), soft
// enough that the time step is 5 % shorter for it.
double contact_stiffness(const Scenario& s) {
  const double cube = s.ice.E * s.numerics.dx;
  switch (s.numerics.contact) {
    case ContactRule::penalty:
      return cube;
    case ContactRule::crushing:
      return 0.25 * cube;
    case ContactRule::relocation:
    case ContactRule::paper:
      break;
  }
  return 0.0;
}

ContactResponse respond(const ContactSettings& s, const ClosestPoint& hit, const Vec3& velocity,
                        double& crushed) {
  const Vec3 relative = velocity - Vec3(s.V, 0.0, 0.0);
  const double approach = std::max(0.0, -relative.dot(hit.normal));
  const double depth = -hit.signed_distance;
  ContactResponse r;
  double normal_delta_v = 0.0;
  switch (s.rule) {
    case ContactRule::relocation:
      r.push = depth * hit.normal;
      normal_delta_v = approach;
      break;
    case ContactRule::paper:
      // v_new = (u_new - u_old)/dt: the push itself becomes velocity. Capped at what the particle can have
      // covered within the step: deeper ones did not get there by moving against the hull.
      r.push = depth * hit.normal;
      normal_delta_v = std::min(depth, relative.norm() * s.dt) / s.dt;
      break;
    case ContactRule::penalty:
      normal_delta_v = s.stiffness * depth * s.dt / s.particle_mass;
      break;
    case ContactRule::crushing:
      normal_delta_v = s.crushing.force(depth, crushed) * s.dt / s.particle_mass;
      break;
  }
  r.delta_v = normal_delta_v * hit.normal + friction(s.friction, relative, hit.normal, normal_delta_v);
  return r;
}

HullContact::HullContact(const QuadMesh& hull, const Box& region, const ContactSettings& settings)
    : distance_(hull, region), settings_(settings) {
  for (const auto& quad : hull.quads) {
    const Vec3 &a = hull.points[quad[0]], &b = hull.points[quad[1]], &c = hull.points[quad[2]],
               &d = hull.points[quad[3]];
    faces_.push_back({0.25 * (a + b + c + d), (c - a).cross(d - b).normalized()});
  }
}

// Ice that is being crushed is up to two spacings deep, where the nearest face may be another than the one it
// met: the side of a stem bar instead of its front. The face that it met presses it on, until it has slid to
// one of nearly the same direction or left the hull. `face` is the quad's number plus 1, or 0.
ClosestPoint HullContact::in_contact(const ClosestPoint& hit, const Vec3& position, int& face) const {
  constexpr double same_direction = 0.7;  // cosine of 45 degrees
  if (face == 0 || faces_[face - 1].normal.dot(faces_[hit.quad].normal) > same_direction) {
    face = hit.quad + 1;
    return hit;
  }
  const Plane& met = faces_[face - 1];
  const double distance = (position - met.point).dot(met.normal);
  return {distance, position - distance * met.normal, met.normal, face - 1};
}

// The drift of a row's blocks.
template <class Real>
void HullContact::approach(const IceSheet& sheet, int jl, int k) {
  const Layout& layout = sheet.layout;
  constexpr Real rounding = Real(1.001);
  const Real* const travelled2 = sheet.travelled2<Real>(jl, k);
  Watch* const watch = &blocks_[(std::size_t(jl) * layout.nz + k) * layout.blocks];
  for (int b = 0; b < layout.blocks; ++b)
    watch[b].moved += static_cast<float>(rounding * std::sqrt(travelled2[b]));
}

int HullContact::apply(IceSheet& sheet, double hull_x, int jl0, int jl1, ExactImpulse& impulse,
                       ContactLedger& ledger) {
  const Layout& layout = sheet.layout;
  if (blocks_.empty()) {
    blocks_.assign(std::size_t(layout.columns) * layout.nz * layout.blocks, Watch{});
    rest_.assign(blocks_.size() * block, 0.0F);
  }
  const Pass pass{sheet, hull_x, impulse, ledger};
  int contacts = 0;
  for (int jl = jl0; jl < jl1; ++jl) {
    for (int k = 0; k < layout.nz; ++k) {
      if (sheet.precision == Precision::fp64) {
        approach<double>(sheet, jl, k);
      } else {
        approach<float>(sheet, jl, k);
      }
      const Watch* const watch = &blocks_[(std::size_t(jl) * layout.nz + k) * layout.blocks];
      for (int b = 0; b < layout.blocks; ++b)
        if (!(watch[b].moved < watch[b].least)) contacts += look_at(pass, jl, k, b);
    }
  }
  return contacts;
}

std::vector<std::int64_t> HullContact::take_face_impulse() {
  std::vector<std::int64_t> taken(face_impulse_.size(), 0);
  taken.swap(face_impulse_);
  return taken;
}

// The particles of a block of which too little is known. Returns how many touch the hull.
int HullContact::look_at(const Pass& pass, int jl, int k, int b) {
  const IceSheet& sheet = pass.sheet;
  const Layout& layout = sheet.layout;
  const std::size_t number = (std::size_t(jl) * layout.nz + k) * layout.blocks + b,
                    row = layout.row(jl, k) + std::size_t(b) * block;
  const double y = sheet.lattice.y(layout.j0 + jl), z = sheet.lattice.z(k);
  Watch& watch = blocks_[number];
  const float moved = std::exchange(watch.moved, 0.0F);
  int contacts = 0;
  for (unsigned due = use_up(moved, &rest_[number * block], watch.least); due; due &= due - 1) {
    const int l = __builtin_ctz(due);
    float& rest = rest_[number * block + l];
    HullDistance::Known* known = watch.near < 0 ? nullptr : &near_[watch.near][l];
    if (known) known->moved(moved);
    const std::size_t p = row + l;
    if (!sheet.mobile(jl, b * block + l) || settings_.crushing.used_up(sheet.crushed_depth[p])) {
      rest = ever;
      if (known) *known = {};
      continue;
    }
    const double x = sheet.lattice.x(layout.i0 + b * block + l);
    const Vec3 position(x + sheet.u[0][p] - pass.hull_x, y + sheet.u[1][p], z + sheet.u[2][p]);
    if (!(known && known->rest > 0.0F && distance_.in_region(position))) {
      const HullDistance::Outlook outlook = distance_.outlook(position);
      if (!outlook.may_be_inside) {
        rest = outlook.clearance;
        if (known) *known = {};
        watch.least = std::min(watch.least, rest);
        continue;
      }
    }
    if (!known) {
      watch.near = static_cast<std::int32_t>(near_.size());
      known = &near_.emplace_back()[l];
    }
    rest = watch.least = 0.0F;
    contacts += touch(pass, p, position, z, *known);
  }
  return contacts;
}

// Whether a particle that may be inside is, with what follows from it.
bool HullContact::touch(const Pass& pass, std::size_t p, const Vec3& position, double z,
                        HullDistance::Known& known) {
  IceSheet& sheet = pass.sheet;
  ClosestPoint hit = distance_.closest(position, known);
  if (hit.signed_distance >= 0.0) {
    // What counts as near the hull depends on the place alone, not on what is remembered of the particle.
    if (!distance_.outlook(position).may_be_inside) return false;
    if (sheet.touched_face[p] != 0.0) sheet.touched_face[p] = 0.0;
    pass.ledger.passed(p, z);
    return false;
  }
  const Vec3 v_before(sheet.v[0][p], sheet.v[1][p], sheet.v[2][p]);
  double crushed = sheet.crushed_depth[p];
  if (settings_.rule == ContactRule::crushing) {
    int face = static_cast<int>(sheet.touched_face[p]);
    hit = in_contact(hit, position, face);
    sheet.touched_face[p] = face;
  }
  const ContactResponse r = respond(settings_, hit, v_before, crushed);
  sheet.crushed_depth[p] = crushed;
  if (settings_.crushing.used_up(crushed)) sheet.extra_strength[p] = IceSheet::crushed;
  Vec3 delta_v, push = Vec3::Zero();  // as stored: the hull gets exactly what the ice lost
  for (int c = 0; c < 3; ++c) {
    sheet.v[c][p] = v_before[c] + r.delta_v[c];
    delta_v[c] = sheet.v[c][p] - v_before[c];
    if (r.push[c] == 0.0) continue;
    known = {};
    const double u_before = sheet.u[c][p] + sheet.residual[c][p];
    sheet.u[c][p] = sheet.u[c][p] + r.push[c];
    sheet.residual[c][p] = 0.0;
    push[c] = sheet.u[c][p] - u_before;
  }
  const Vec3 on_hull = -settings_.particle_mass * delta_v;
  pass.impulse.add(on_hull, hit.point);
  if (!face_impulse_.empty())
    for (int c = 0; c < 3; ++c)
      face_impulse_[3 * std::size_t(hit.quad) + c] += whole_multiples(on_hull[c], pass.impulse.linear());
  pass.ledger.struck(p, z, v_before, delta_v, push);
  return true;
}

}  // namespace icebow
