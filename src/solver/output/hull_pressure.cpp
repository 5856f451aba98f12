#include "solver/output/hull_pressure.h"

#include "base/errors.h"

namespace icebow {
namespace {

// Outward, as long as the quad is large [m^2].
Vec3 area_vector(const QuadMesh& hull, std::size_t quad) {
  const auto& q = hull.quads[quad];
  return 0.5 * (hull.points[q[2]] - hull.points[q[0]]).cross(hull.points[q[3]] - hull.points[q[1]]);
}

}  // namespace

void HullPressure::add(const Communicator& comm, Stepper& stepper) {
  std::vector<std::int64_t> more = stepper.take_face_impulse();
  comm.sum(more.data(), static_cast<int>(more.size()));
  impulse_.resize(more.size(), 0);
  for (std::size_t n = 0; n < more.size(); ++n) impulse_[n] += more[n];
  quantum_ = stepper.impulse().linear();
}

std::vector<PressedQuad> HullPressure::take(double time) {
  std::vector<PressedQuad> list;
  const double interval = time - since_;
  for (std::size_t q = 0; 3 * q < impulse_.size() && interval > 0.0; ++q) {
    const std::int64_t* counts = &impulse_[3 * q];
    const Vec3 area = area_vector(hull_, q);
    const double size = area.norm();
    if ((counts[0] == 0 && counts[1] == 0 && counts[2] == 0) || !(size > 0.0)) continue;
    const Vec3 force = Vec3(double(counts[0]), double(counts[1]), double(counts[2])) * (quantum_ / interval);
    const Vec3 traction = force / size;
    list.push_back({static_cast<std::int32_t>(q), -traction.dot(area) / size, traction});
  }
  impulse_.assign(impulse_.size(), 0);
  since_ = time;
  return list;
}

Json HullPressure::record() const {
  Json pressed = Json::array();
  for (std::size_t q = 0; 3 * q < impulse_.size(); ++q) {
    const std::int64_t* c = &impulse_[3 * q];
    if (c[0] != 0 || c[1] != 0 || c[2] != 0) pressed.push_back({std::int64_t(q), c[0], c[1], c[2]});
  }
  return {{"since", since_}, {"impulse", pressed}};
}

void HullPressure::restore(const Json& record) {
  record.at("since").get_to(since_);
  impulse_.assign(3 * hull_.quads.size(), 0);
  for (const Json& row : record.at("impulse")) {
    const auto values = row.get<std::vector<std::int64_t>>();
    if (values.size() != 4 || values[0] < 0 || values[0] >= std::int64_t(hull_.quads.size()))
      throw RuntimeError("its list of pressures is not whole");
    for (std::size_t c = 0; c < 3; ++c) impulse_[3 * std::size_t(values[0]) + c] = values[c + 1];
  }
}

}  // namespace icebow
