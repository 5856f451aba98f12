#include "solver/run/case_text.h"

#include <cstdio>
#include <cstring>
#include <sstream>

namespace icebow {
namespace {

// A field added to a scenario but not to its text would let a run continue another one: the sizes notice.
static_assert(sizeof(void*) != 8 ||
                  (sizeof(IceMaterial) == 64 && sizeof(Water) == 32 && sizeof(Sheet) == 48 &&
                   sizeof(Numerics) == 72 && sizeof(Scenario) == 64 + 32 + 48 + 72 + 32),
              "add the new field to case_text() below, then correct the size");

// FNV-1a, 64 bits.
class Checksum {
 public:
  template <class T>
  void add(const T& value) {
    unsigned char bytes[sizeof value];
    std::memcpy(bytes, &value, sizeof value);
    for (unsigned char byte : bytes) sum_ = (sum_ ^ byte) * 1099511628211u;
  }
  std::uint64_t value() const { return sum_; }

 private:
  std::uint64_t sum_ = 14695981039346656037u;
};

std::string hull_checksum(const QuadMesh& hull) {
  Checksum sum;
  for (const Vec3& p : hull.points) {
    for (int c = 0; c < 3; ++c) sum.add(p[c]);
  }
  for (const auto& quad : hull.quads) {
    for (const auto corner : quad) sum.add(corner);
  }
  char text[32];
  std::snprintf(text, sizeof text, "%016llx", static_cast<unsigned long long>(sum.value()));
  return text;
}

class Text {
 public:
  Text() { text_.precision(17); }
  template <class T>
  void add(const char* name, const T& value) {
    text_ << name << " = " << value << "\n";
  }
  std::string str() const { return text_.str(); }

 private:
  std::ostringstream text_;
};

}  // namespace

std::string case_text(const QuadMesh& hull, const Scenario& s, const RunOptions& options) {
  Text text;
  text.add("ice.h", s.ice.h);
  text.add("ice.rho", s.ice.rho);
  text.add("ice.E", s.ice.E);
  text.add("ice.nu", s.ice.nu);
  text.add("ice.s0", s.ice.s0);
  text.add("ice.K_I", s.ice.K_I);
  text.add("ice.tensile_strength", s.ice.tensile_strength);
  text.add("ice.crushing_pressure", s.ice.crushing_pressure);
  text.add("water.rho", s.water.rho);
  text.add("water.buoyancy_and_gravity", s.water.buoyancy_and_gravity);
  text.add("sheet.length", s.sheet.length);
  text.add("sheet.width", s.sheet.width);
  text.add("sheet.fixed", static_cast<int>(s.sheet.fixed));
  text.add("sheet.window_ahead", s.sheet.window_ahead);
  text.add("numerics.dx", s.numerics.dx);
  text.add("numerics.horizon_ratio", s.numerics.horizon_ratio);
  text.add("numerics.dt", s.numerics.dt);
  text.add("numerics.dt_fraction", s.numerics.dt_fraction);
  text.add("numerics.surface_correction", s.numerics.surface_correction);
  text.add("numerics.linear_below", s.numerics.linear_below);
  text.add("numerics.precision", static_cast<int>(s.numerics.precision));
  text.add("numerics.contact", static_cast<int>(s.numerics.contact));
  text.add("numerics.friction", s.numerics.friction);
  text.add("V", s.V);
  text.add("advance", s.advance);
  text.add("steady_from", s.steady_from);
  text.add("stop_when_ci95_below", s.stop_when_ci95_below);
  text.add("snapshots", options.snapshots);
  text.add("snapshot_format", static_cast<int>(options.snapshot_format));
  text.add("pictures", options.pictures);
  text.add("hull", hull_checksum(hull));
  // The last, and as a checkpoint has it that is older than the choices.
  if (s.sheet.half_model) text.add("sheet.half_model", true);
  if (options.seed != 0) text.add("seed", options.seed);
  if (s.water.added_mass > 0.0) text.add("water.added_mass", s.water.added_mass);
  if (s.water.inertia != WaterInertia::layer) text.add("water.inertia", static_cast<int>(s.water.inertia));
  if (s.water.drag > 0.0) text.add("water.drag", s.water.drag);
  if (s.sheet.absorbing > 0.0) text.add("sheet.absorbing", s.sheet.absorbing);
  if (s.numerics.floe_contact) text.add("numerics.floe_contact", true);
  return text.str();
}

std::string case_difference(const std::string& there, const std::string& here) {
  std::istringstream a(there), b(here);
  std::string x, y;
  for (;;) {
    const bool more_a = bool(std::getline(a, x)), more_b = bool(std::getline(b, y));
    if (!more_a && !more_b) return "";
    if (!more_a) x = "nothing";
    if (!more_b) y = "nothing";
    if (x == y) continue;
    const std::size_t equals = x.find(" = ");
    const bool same_name = equals != std::string::npos && y.compare(0, equals + 3, x, 0, equals + 3) == 0;
    return x + " there, " + (same_name ? y.substr(equals + 3) : y) + " here";
  }
}

}  // namespace icebow
