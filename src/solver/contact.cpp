#include "solver/contact.h"

#include <algorithm>

namespace icebow {
namespace {

// Coulomb: the hull drags the sliding particle, at most to its own speed.
Vec3 friction(double mu, const Vec3& relative_velocity, const Vec3& normal, double normal_delta_v) {
  const Vec3 tangential = relative_velocity - relative_velocity.dot(normal) * normal;
  const double speed = tangential.norm();
  if (speed == 0.0) return Vec3::Zero();
  return -std::min(1.0, mu * normal_delta_v / speed) * tangential;
}

}  // namespace

ContactResponse respond(const ContactSettings& s, const ClosestPoint& hit, const Vec3& velocity) {
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
      normal_delta_v = s.penalty_stiffness * depth * s.dt / s.particle_mass;
      break;
    case ContactRule::crushing:
      normal_delta_v = approach;
      if (depth < s.crushing_depth) {
        normal_delta_v = std::min(approach, s.crushing_force * s.dt / s.particle_mass);
      } else {
        // Rubble is pushed out, no faster than the hull sails: its bonds break by and by.
        r.push = std::min(depth, s.V * s.dt) * hit.normal;
      }
      break;
  }
  r.delta_v = normal_delta_v * hit.normal + friction(s.friction, relative, hit.normal, normal_delta_v);
  return r;
}

HullContact::HullContact(const QuadMesh& hull, const Box& region, const ContactSettings& settings)
    : distance_(hull, region), settings_(settings) {}

// Failure where the hull presses is the contact rule's: bonds there hold until the ice is crushed.
void HullContact::strengthen(IceSheet& sheet, std::size_t p, double depth) const {
  if (sheet.extra_strength[p] < 0.0) return;
  sheet.extra_strength[p] = depth < settings_.crushing_depth ? IceSheet::held_together : IceSheet::crushed;
}

int HullContact::apply(IceSheet& sheet, double hull_x, int jl0, int jl1, ExactImpulse& impulse,
                       ContactLedger& ledger) const {
  const Layout& layout = sheet.layout;
  int contacts = 0;
  for (int jl = jl0; jl < jl1; ++jl) {
    for (int k = 0; k < layout.nz; ++k) {
      const std::size_t row = layout.row(jl, k);
      const double y = sheet.lattice.y(layout.j0 + jl), z = sheet.lattice.z(k);
      for (int b = 0; b < layout.blocks; ++b) {
        if (!sheet.near_hull(jl, k, b)) continue;
        for (int l = b * block; l < (b + 1) * block; ++l) {
          if (!sheet.mobile(jl, l)) continue;
          const std::size_t p = row + l;
          if (sheet.extra_strength[p] > 0.0) sheet.extra_strength[p] = 0.0;
          const Vec3 position(sheet.lattice.x(layout.i0 + l) + sheet.u[0][p] - hull_x, y + sheet.u[1][p],
                              z + sheet.u[2][p]);
          if (!distance_.may_be_inside(position)) continue;
          const ClosestPoint hit = distance_.closest(position);
          if (hit.signed_distance >= 0.0) {
            ledger.passed(p, z);
            continue;
          }
          ++contacts;
          if (settings_.rule == ContactRule::crushing) strengthen(sheet, p, -hit.signed_distance);
          const Vec3 v_before(sheet.v[0][p], sheet.v[1][p], sheet.v[2][p]);
          const ContactResponse r = respond(settings_, hit, v_before);
          Vec3 delta_v, push = Vec3::Zero();  // as stored: the hull gets exactly what the ice lost
          for (int c = 0; c < 3; ++c) {
            sheet.v[c][p] = v_before[c] + r.delta_v[c];
            delta_v[c] = sheet.v[c][p] - v_before[c];
            if (r.push[c] == 0.0) continue;
            const double u_before = sheet.u[c][p] + sheet.residual[c][p];
            sheet.u[c][p] = sheet.u[c][p] + r.push[c];
            sheet.residual[c][p] = 0.0;
            push[c] = sheet.u[c][p] - u_before;
          }
          impulse.add(-settings_.particle_mass * delta_v, hit.point);
          ledger.struck(p, z, v_before, delta_v, push);
        }
      }
    }
  }
  return contacts;
}

}  // namespace icebow
