// Calibrated ice met by a sloping plate: an edge pressed over some widths and a strip, at the speeds of a
// ship's side, against the thin plate in motion. See docs/verification.md.
#include "tests/support/driven_plate.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdio>

#include "base/units.h"
#include "solver/contact/contact.h"
#include "solver/ice/cut.h"
#include "solver/lattice/stability.h"
#include "solver/step/stepper.h"
#include "solver/watch/crack_watch.h"
#include "solver/watch/cracks.h"
#include "tests/support/calibrated_ice.h"
#include "tests/support/tiny_hull.h"

using namespace icebow;

namespace {

struct Press {
  bool strip;  // 12 columns wide and 6 l long, free sides, or the edge of a sheet
  int layers;
  double width;       // of the plate, over h; of a strip its own
  double edge_speed;  //!< full scale [m/s]
  double slope_deg;
  int split_layers = 0;  // the lowest ones of an edge's sheet, cut along the plate's normal before it comes
};

// Peak over strength h^2 (a strip: for each h of its width), place over l, how far the face has come down
// since it touched over h; force at which the lower face is at its strength at the plate, as the peak.
struct Found {
  double peak = 0.0, at = 0.0, down = 0.0, first = 0.0;
};

constexpr double reach_l = 4.0;  // of the sheet beyond the pressed edge, ahead and aside, over l; held there
constexpr double strip_l = 6.0;

Press strip(int layers, double edge_speed) {
  return {true, layers, 12.0 / layers, edge_speed, 58.5};
}

Press edge(int layers, double width, double edge_speed) {
  return {false, layers, width, edge_speed, 24.35};
}

double model_speed(const Press& p) {
  return p.edge_speed / 5.0;
}

// What the crushing law bears on the rows and layers of the lattice, by how far the face has come down since
// it touched the first particle.
double lattice_contact(const Press& p, double down) {
  const TankIce ice;
  const double dx = ice.h / p.layers, slope = radians(p.slope_deg);
  const CrushingLaw law{ice.crushing * dx * dx, 0.0, dx};
  double sum = 0.0;
  for (int k = 0; k < p.layers; ++k) {
    for (int i = 0; i < 40; ++i)
      sum += law.bearable(std::max(0.0, (down - k * dx - i * dx * std::tan(slope)) * std::cos(slope)));
  }
  return sum * std::cos(slope) * p.width * p.layers;
}

enum class Contact { cut_area, lattice };
enum class Plate { whole, splits };

Found theory(const Press& p, Contact contact, Plate kind, bool in_plane = true, bool floods = true) {
  const TankIce ice;
  const double h = ice.h, l = ice.characteristic_length(), b = p.width * h, slope = radians(p.slope_deg),
               part = p.strip ? 1.0 : 0.5;
  PlateMesh mesh;
  if (p.strip) {
    mesh.x = graded_lines(0.02 * l, 2.0 * l, strip_l * l);
    mesh.y = {0.0, 0.5 * b, b};
    mesh.at_x1 = PlateEdge::clamped;
  } else {
    mesh.x = graded_lines(0.5 * h, 1.2 * l, reach_l * l);
    mesh.y = graded_lines(0.5 * h, 0.5 * b + 0.6 * l, 0.5 * b + reach_l * l);
    mesh.at_y0 = PlateEdge::mirror;
    mesh.at_x1 = mesh.at_y1 = PlateEdge::clamped;
  }
  const PlateElements plate(ice.plate(), mesh);
  Drive d;
  d.speed = model_speed(p);
  d.strength = ice.strength;
  d.ahead = in_plane ? std::tan(slope) : 0.0;
  d.freeboard = floods ? h * (1.0 - ice.rho / ice.water) : 0.0;
  d.splits = kind == Plate::splits;
  d.arm = contact == Contact::lattice ? 0.5 * h * (1.0 - 1.0 / p.layers) : 0.5 * h;
  if (contact == Contact::lattice)
    d.contact = [&](double down) { return part * lattice_contact(p, down); };
  else
    d.contact = [&](double down) {
      return part * ice.crushing * b * std::max(0.0, std::min(down, h)) / std::tan(slope);
    };
  if (p.strip)
    d.in_plane = [&](double, double) { return FaceStress{-1.0 / (b * h), 0.0, 0.0}; };
  else
    d.in_plane = [&](double x, double y) {
      const FaceStress s = pressed_half_plane(0.5 * b, h, x, y);
      return FaceStress{s.xx / part, s.yy / part, s.xy / part};
    };
  const LoadedPatch patch{0.0, 0.25 * h, 0.0, p.strip ? b : 0.5 * b};
  const DrivenBreak found = drive(plate, patch, d);
  const double unit = ice.unit_load() * part * (p.strip ? p.width : 1.0);
  return {found.peak / unit, found.at / l, found.down / h, found.first / unit};
}

// One simulation, until the ice is broken across.
class Pressed {
 public:
  explicit Pressed(const Press& p)
      : p_(p),
        s_(scenario(p)),
        lattice_(make_lattice(s_)),
        hull_(sloping_box(radians(p.slope_deg), p.strip ? 2.0 * lattice_.width() : p.width * s_.ice.h, 0.08,
                          0.2, 0.8)),
        // Particles are touched at their centres.
        stepper_(Communicator::serial(), hull_, s_, lattice_, time_step(),
                 first_touch_x(hull_, lattice_) +
                     0.5 * lattice_.dx * (1.0 + 1.0 / std::tan(radians(p.slope_deg)))),
        watch_(lattice_.dx, 1.0),
        whole_(upper_bonds()) {
    cut(stepper_.sheet(), [&](int, int j, int k, const Offset& o) {
      return j < 0 && j + o.dj >= 0 && std::min(k, k + o.dk) < p_.split_layers &&
             (o.dk == 0 || p_.split_layers == p_.layers);
    });
  }

  Found run() {
    const double sample = 0.08 * std::sqrt(s_.ice.h / gravity), most = 1.5 * s_.ice.h / model_speed(p_);
    double until = most, peak = 0.0;
    Found found;
    for (double next = sample; stepper_.time() < until; next += sample) {
      const double from = stepper_.time();
      while (stepper_.time() < next) step();
      const ExactImpulse impulse = stepper_.take_impulse();
      peak = std::max(peak, lattice_.copies() * impulse.linear() * double(impulse.counts()[2]) /
                                (stepper_.time() - from));
      watch_.look(Communicator::serial(), stepper_.sheet(), s_.V * stepper_.time());
      const double at = p_.strip ? across_strip() : across_sheet();
      if (at > 0.0 && until == most) {
        until = stepper_.time() + (p_.strip ? 0.0 : 0.25 * s_.ice.h / model_speed(p_));
        const TankIce ice;
        found.peak = peak / ice.unit_load() / (p_.strip ? p_.width : 1.0);
        found.down = model_speed(p_) * stepper_.time() / s_.ice.h;
      }
      if (at > 0.0) found.at = at / TankIce().characteristic_length();
    }
    return found;
  }
  const CrackWatch& cracked() const { return watch_; }

 private:
  static Scenario scenario(const Press& p) {
    const TankIce ice;
    const double dx = ice.h / p.layers, l = ice.characteristic_length();
    const auto columns = [&](double length) { return static_cast<int>(std::lround(length / dx)); };
    Scenario s = p.strip ? calibrated_sheet(p.layers, columns(strip_l * l), 12)
                         : calibrated_sheet(p.layers, columns(reach_l * l),
                                            2 * columns(0.5 * p.width * ice.h + reach_l * l));
    s.sheet.fixed = p.strip ? FixedEdges::none : FixedEdges::sides_and_far;
    s.sheet.half_model = !p.strip;
    s.numerics.contact = ContactRule::crushing;
    s.V = model_speed(p) / std::tan(radians(p.slope_deg));
    s.advance = 3.0 * ice.h / std::tan(radians(p.slope_deg));
    return s;
  }
  double time_step() const {
    const Material m = make_material(s_.ice, lattice_.dx, s_.numerics.horizon_ratio);
    const double limit = stable_time_step(make_stencil(lattice_.nz, lattice_.dx, m.delta), m, lattice_.dx,
                                          s_.ice.rho, s_.numerics.surface_correction);
    return 0.95 * with_contact(limit, contact_stiffness(s_), s_.ice.rho * lattice_.particle_volume());
  }
  void step() {
    stepper_.step();
    if (!p_.strip) return;
    IceSheet& sheet = stepper_.sheet();  // its far end is held
    for (int j = 0; j < lattice_.ny; ++j) {
      for (int k = 0; k < lattice_.nz; ++k) {
        for (int i = lattice_.nx - reach; i < lattice_.nx; ++i)
          for (Field& v : sheet.v) v[sheet.layout.row(j, k) + i] = 0.0;
      }
    }
  }
  // Bonds of the upper layer through each section x = i dx.
  std::vector<int> upper_bonds() {
    std::vector<int> through(lattice_.nx, 0);
    cut(stepper_.sheet(), [&](int i, int, int k, const Offset& o) {
      if (k != lattice_.nz - 1 || o.dk != 0) return false;
      for (int n = std::min(i, i + o.di); n < std::max(i, i + o.di); ++n) ++through[n + 1];
      return false;
    });
    return through;
  }
  // Where half of the bonds through the upper layer of a strip are broken; 0 = nowhere [m].
  double across_strip() {
    const std::vector<int> now = upper_bonds();
    double worst = 0.5;
    int place = 0;
    for (int i = 2 * reach; i < lattice_.nx; ++i) {
      const double left = double(now[i]) / whole_[i];
      if (left < worst) worst = left, place = i;
    }
    return place * lattice_.dx;
  }
  // How far the crack across the way out is from the plate's edge [m]; 0 = there is none. It is the longest
  // of those that are half as long as the plate is wide, and 2 h.
  double across_sheet() const {
    const double b = p_.width * s_.ice.h;
    const std::vector<Segment> plate = {{{0.0, -0.5 * b}, {0.0, 0.5 * b}},
                                        {{0.0, 0.5 * b}, {-1.0, 0.5 * b}},
                                        {{-1.0, 0.5 * b}, {-1.0, -0.5 * b}},
                                        {{-1.0, -0.5 * b}, {0.0, -0.5 * b}}};
    CrackedSheet sheet{lattice_, watch_.columns(), s_.ice.h, TankIce().characteristic_length()};
    const Crack* longest = nullptr;
    const Cracks cracks = find_cracks(sheet, plate);
    for (const Crack& c : cracks.list) {
      if (c.kind != CrackKind::circumferential || c.length < std::max(0.5 * b, 2.0 * s_.ice.h)) continue;
      if (!longest || c.length > longest->length) longest = &c;
    }
    return longest ? away(*longest) : 0.0;
  }
  // As theory counts: within 60 degrees of the plate's normal, from its nearer end; the median over the
  // columns that opened with the crack and whose bonds broke along the way out. The crack's ends lie farther
  // away.
  double away(const Crack& crack) const {
    const double h = s_.ice.h, end = 0.5 * p_.width * h;
    std::vector<double> places;
    for (const CrackedColumn& c : watch_.columns()) {
      const double x = (static_cast<double>(c.i) + 0.5) * lattice_.dx;
      const double aside = std::max(0.0, (static_cast<double>(c.j) + 0.5) * lattice_.dx - end);
      const double twice = 2.0 * std::atan2(aside, x);
      const bool with_it = c.opened >= crack.opened - 0.25 * h && c.opened <= crack.opened + h;
      const bool out = c.cos2 * std::cos(twice) + c.sin2 * std::sin(twice) > 0.0;
      if (with_it && out && x > 1.5 * h && aside < std::sqrt(3.0) * x) places.push_back(std::hypot(x, aside));
    }
    if (places.empty()) return crack.from_hull + crack.opened;  // the hull has come on since the first touch
    const auto middle = places.begin() + static_cast<std::ptrdiff_t>(places.size() / 2);
    std::nth_element(places.begin(), middle, places.end());
    return *middle;
  }

  Press p_;
  Scenario s_;
  Lattice lattice_;
  QuadMesh hull_;
  Stepper stepper_;
  CrackWatch watch_;
  std::vector<int> whole_;
};

void print_theory(const Press& p) {
  const auto line = [&](const char* name, const Found& f) {
    std::printf("  %-40s at %.2f l, peak %.3f, %.2f h down, first below %.3f\n", name, f.at, f.peak, f.down,
                f.first);
    std::fflush(stdout);
  };
  std::printf("%s, %.0f h, %.2f m/s\n", p.strip ? "strip" : "edge", p.width, p.edge_speed);
  if (p.layers == 2) {
    line("cut area, no forces ahead, no flooding", theory(p, Contact::cut_area, Plate::whole, false, false));
    line("cut area, no forces ahead", theory(p, Contact::cut_area, Plate::whole, false));
    line("cut area", theory(p, Contact::cut_area, Plate::whole));
    if (!p.strip) line("cut area, split", theory(p, Contact::cut_area, Plate::splits));
  }
  line("lattice's contact", theory(p, Contact::lattice, Plate::whole));
  if (p.strip) return;
  line("lattice's contact, split", theory(p, Contact::lattice, Plate::splits));
}

void print(const Press& p) {
  const Found f = Pressed(p).run();
  std::string name = std::to_string(p.layers) + " layers";
  if (p.split_layers > 0) name += ", split through " + std::to_string(p.split_layers);
  std::printf("  %-40s at %.2f l, peak %.3f, %.2f h down\n", name.c_str(), f.at, f.peak, f.down);
  std::fflush(stdout);
}

void table(const std::vector<Press>& pushes) {
  for (Press p : pushes) {
    for (p.layers = 2; p.layers <= 3; ++p.layers) {
      if (p.strip) p.width = 12.0 / p.layers;
      print_theory(p);
      for (const int split : {0, 1, p.layers}) {
        p.split_layers = split;
        if (!p.strip || split == 0) print(p);
      }
    }
  }
}

}  // namespace

TEST_CASE("a strip of calibrated ice met by a plate: the table", "[.long]") {
  table({strip(2, 0.07), strip(2, 0.3), strip(2, 0.55), strip(2, 0.8), strip(2, 1.1)});
}

TEST_CASE("an edge of calibrated ice met by a plate: the table", "[.long]") {
  std::vector<Press> pushes;
  for (const double width : {1.0, 2.0, 4.0, 8.0})
    for (const double speed : {1.1, 0.5, 0.07}) pushes.push_back(edge(2, width, speed));
  table(pushes);
}

TEST_CASE("a strip met by a sloping plate breaks where the driven plate of theory does, and under its load") {
  for (const double speed : {1.1, 0.55}) {
    const Press p = strip(2, speed);
    const Found t = theory(p, Contact::lattice, Plate::whole), f = Pressed(p).run();
    INFO(speed << " m/s: breaks at " << f.at << " l (theory " << t.at << "), peak " << f.peak << " ("
               << t.peak << ") strength h^2 for each h of width");
    CHECK(f.peak == Approx(t.peak).epsilon(0.12));  // weaker on the upper face by 7 % at rest
    CHECK(f.at == Approx(t.at).epsilon(0.15));      // the stress is within 2 % of its highest over 0.2 l
  }
}

TEST_CASE("an edge pressed fast breaks between the whole plate of theory and the one that has split") {
  const Press p = edge(2, 2.0, 1.1);
  const Found whole = theory(p, Contact::lattice, Plate::whole),
              split = theory(p, Contact::lattice, Plate::splits), f = Pressed(p).run();
  INFO("breaks at " << f.at << " l (theory " << split.at << " split, " << whole.at << " whole), peak "
                    << f.peak << " (" << split.peak << ", " << whole.peak << ")");
  CHECK(f.peak > 0.9 * split.peak);
  CHECK(f.peak < whole.peak);
  CHECK(f.at > 0.85 * split.at);
  CHECK(f.at < whole.at);
}

TEST_CASE(
    "an edge split through all layers breaks where the split plate of theory does; split from below, "
    "farther") {
  Press p = edge(2, 2.0, 0.5);
  const Found split = theory(p, Contact::lattice, Plate::splits);
  p.split_layers = 2;
  const Found through = Pressed(p).run();
  p.split_layers = 1;
  const Found below = Pressed(p).run();
  INFO("breaks at " << through.at << " l split through, " << below.at << " l from below, theory " << split.at
                    << " l; peak " << through.peak << ", " << below.peak << ", theory " << split.peak);
  CHECK(through.at == Approx(split.at).epsilon(0.15));      // a row of columns is 0.04 l
  CHECK(through.peak == Approx(split.peak).epsilon(0.15));  // a cut edge is weaker by half a spacing
  CHECK(below.at > 1.2 * through.at);
}
