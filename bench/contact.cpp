// Contact detection: time per query against the number of hull panels, and the share of contact in a whole
// step. `bench/contact [--json]`.
#include <cstdio>
#include <cstring>
#include <ctime>
#include <nlohmann/json.hpp>
#include <random>

#include "bench/contact_share.h"
#include "bench/machine.h"
#include "geometry/hull_distance.h"
#include "tests/support/shapes.h"

using namespace icebow;

namespace {

constexpr double dx = 0.013;  // lattice spacing of the reference case [m]

struct Row {
  std::size_t quads = 0, cells = 0;
  double cell_size_mm = 0, megabytes = 0, build_s = 0;
  double step_ns = 0;     // a particle of the sheet, all of them asked
  double contact_ns = 0;  // closest() of a point up to 2 mm inside, over as many as a step has
  double spread_ns = 0;   // the same over 20,000 points: most data come from outside the caches
  double deep_ns = 0;     // closest() of a point anywhere inside
  double brute_ns = 0;    // closest_brute_force()
  std::size_t particles = 0, inside = 0;
};

// Processor time: one thread, and the machine may be busy with other work.
template <class Work>
double seconds(const Work& work) {
  const std::clock_t start = std::clock();
  work();
  return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
}

template <class Work>
double best_seconds(const Work& work) {
  double best = 1e300;
  for (int i = 0; i < 9; ++i) best = std::min(best, seconds(work));
  return best;
}

// The sheet around the hull as a run sees it: three layers, hull in place.
struct Sheet {
  std::vector<float> x, y, z;
};

Sheet sheet_around(const Box& hull) {
  Sheet sheet;
  for (double x = hull.lower.x() - 0.2; x < hull.upper.x() + 0.2; x += dx)
    for (double y = -0.8; y < 0.8; y += dx)
      for (int layer = -2; layer <= 0; ++layer) {
        sheet.x.push_back(static_cast<float>(x));
        sheet.y.push_back(static_cast<float>(y));
        sheet.z.push_back(static_cast<float>(layer * dx));
      }
  return sheet;
}

// The particles a step really finds: all but a rim of the hull's inside is open water.
Sheet rim_of(const Sheet& sheet, const HullDistance& hull) {
  Sheet rim;
  for (std::size_t i = 0; i < sheet.x.size(); ++i) {
    const double d = hull.closest(Vec3(sheet.x[i], sheet.y[i], sheet.z[i])).signed_distance;
    if (d < -0.001) continue;
    rim.x.push_back(sheet.x[i]), rim.y.push_back(sheet.y[i]), rim.z.push_back(sheet.z[i]);
  }
  return rim;
}

// Asks all particles, as a step does that knows nothing of them.
std::size_t inside(const Sheet& sheet, const HullDistance& hull) {
  std::size_t found = 0;
  for (std::size_t i = 0; i < sheet.x.size(); ++i) {
    const Vec3 p(sheet.x[i], sheet.y[i], sheet.z[i]);
    found += hull.outlook(p).may_be_inside && hull.closest(p).signed_distance < 0.0;
  }
  return found;
}

std::vector<Vec3> points_inside(const HullDistance& hull, const Box& region, double shallow, double deep,
                                int n) {
  std::mt19937 engine(1);
  std::uniform_real_distribution<double> u(0.0, 1.0);
  std::vector<Vec3> points;
  while (static_cast<int>(points.size()) < n) {
    const Vec3 r(u(engine), u(engine), u(engine));
    const Vec3 p = region.lower + r.cwiseProduct(region.upper - region.lower);
    const ClosestPoint at = hull.closest(p);
    if (at.signed_distance >= 0.0 || at.signed_distance < -deep) continue;
    points.push_back(shallow > 0.0 ? Vec3(at.point - u(engine) * shallow * at.normal) : p);
  }
  return points;
}

double ns_per_query(const std::vector<Vec3>& points, const HullDistance& hull) {
  double sum = 0.0;
  const int repeats = 1 + 20000 / static_cast<int>(points.size());
  const double time = best_seconds([&] {
    for (int k = 0; k < repeats; ++k)
      for (const Vec3& p : points) sum += hull.closest(p).signed_distance;
  });
  if (sum > 0.0) std::fprintf(stderr, "points that should be inside are outside\n");
  return 1e9 * time / (repeats * static_cast<double>(points.size()));
}

Row measure(int quads) {
  const QuadMesh mesh = shapes::hull(6.0, 0.92, 0.54, quads);
  Box region = bounding_box(mesh);
  region.lower.z() = std::max(region.lower.z(), -0.5), region.upper.z() = std::min(region.upper.z(), 0.1);
  Row row;
  row.quads = mesh.quads.size();
  row.build_s = seconds([&] { HullDistance(mesh, region); });
  const HullDistance hull(mesh, region);
  row.cells = hull.grid().cells();
  row.cell_size_mm = 1e3 * hull.grid().size;
  row.megabytes = 1e-6 * static_cast<double>(hull.bytes());

  const Sheet sheet = rim_of(sheet_around(bounding_box(mesh)), hull);
  row.particles = sheet.x.size();
  row.step_ns =
      1e9 / static_cast<double>(row.particles) * best_seconds([&] { row.inside = inside(sheet, hull); });
  row.contact_ns = ns_per_query(points_inside(hull, region, 0.002, 0.02, 500), hull);
  row.spread_ns = ns_per_query(points_inside(hull, region, 0.002, 0.02, 20000), hull);
  row.deep_ns = ns_per_query(points_inside(hull, region, 0.0, 1.0, 4000), hull);
  const Vec3 p(-1, 0.1, -0.05);
  double sum = 0.0;
  row.brute_ns = 1e9 * best_seconds([&] { sum += closest_brute_force(hull.surface(), p).signed_distance; });
  return row;
}

}  // namespace

int main(int argc, char** argv) {
  const bool json = argc > 1 && std::strcmp(argv[1], "--json") == 0;
  nlohmann::json rows = nlohmann::json::array();
  if (!json)
    std::printf("%9s %9s %8s %7s %9s %12s %11s %10s %9s %12s %17s\n", "quads", "cells", "cell mm", "MB",
                "build s", "ns/particle", "ns/contact", "ns/spread", "ns/deep", "ns/brute",
                "inside/particles");
  for (const int quads : {500, 2000, 10000, 50000, 200000}) {
    const Row r = measure(quads);
    if (json)
      rows.push_back({{"quads", r.quads},
                      {"cells", r.cells},
                      {"cell_size_mm", r.cell_size_mm},
                      {"megabytes", r.megabytes},
                      {"build_s", r.build_s},
                      {"ns_per_particle_of_a_step", r.step_ns},
                      {"ns_per_contact_query", r.contact_ns},
                      {"ns_per_spread_query", r.spread_ns},
                      {"ns_per_deep_query", r.deep_ns},
                      {"ns_per_brute_force_query", r.brute_ns},
                      {"particles", r.particles},
                      {"inside", r.inside}});
    else
      std::printf("%9zu %9zu %8.2f %7.1f %9.3f %12.2f %11.0f %10.0f %9.0f %12.0f %8zu/%zu\n", r.quads,
                  r.cells, r.cell_size_mm, r.megabytes, r.build_s, r.step_ns, r.contact_ns, r.spread_ns,
                  r.deep_ns, r.brute_ns, r.inside, r.particles);
    std::fflush(stdout);
  }
  nlohmann::json shares = nlohmann::json::object();
  for (const int quads : {2000, 50000}) {
    const ContactShare s = contact_share(quads);
    shares[std::to_string(s.quads)] = {{"contact_share", s.share()},
                                       {"contact_ms", s.contact_ms},
                                       {"step_ms", s.step_ms},
                                       {"contacts", s.contacts}};
    if (!json)
      std::printf("%9zu quads: contact %.3f ms of a step of %.3f ms = %.1f %%, %d particles in contact\n",
                  s.quads, s.contact_ms, s.step_ms, 100.0 * s.share(), s.contacts);
    std::fflush(stdout);
  }
  const nlohmann::json all = {
      {"benchmark", "contact"}, {"rows", rows}, {"whole_step", shares}, {"machine", machine_context()}};
  if (json) std::printf("%s\n", all.dump(2).c_str());
}
