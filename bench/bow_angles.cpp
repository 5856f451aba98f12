// Random feasible bows of every family, at two panel sizes: are the angles those asked for, is the hull
// closed and free of self-intersections, how good are its panels, and which part of the family's ranges can
// be had together; and what a hull of each preset costs. Prints Markdown tables; docs/bows.md has them.
//
//     bow_angles [BOWS] [SEED]      1000 bows a family, seed 1
//     bow_angles presets            the presets' hulls alone
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <map>

#include "base/units.h"
#include "hullgen/bow/bow_angles.h"
#include "hullgen/bow/bow_mesh.h"
#include "hullgen/bow/family.h"
#include "hullgen/bow/feasibility.h"
#include "hullgen/mesh/mesh_check.h"
#include "tests/support/paper_bows.h"

using namespace icebow;

namespace {

constexpr std::array<double, 2> densities = {40.0, 20.0};  // panels per beam
constexpr int most_tried = 1000000;
constexpr int asked = 100000;  // bows a family for the table of joint feasibility, without meshes

struct Sample {
  std::vector<double> errors;  // [deg], largest of the four angles of a bow
  int broken = 0;              // open, folded, intersecting itself
  double warp = 0.0, aspect = 0.0, hull_aspect = 0.0, seconds = 0.0;
};

struct Family {
  int feasible = 0;
  std::array<Sample, densities.size()> at;
};

// Which part of a family's ranges can be had together.
struct Jointly {
  std::map<std::string, int> refused;  // by margin
  std::vector<double> quarter_waterline, stem_less_buttock,
      ratio;  // of the feasible ones: [deg], [deg], Lf/B
};

// Of the processor, so that other programs on the machine count little.
double seconds_now() {
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

void add(Sample& sample, const BowParameters& bow) {
  const double start = seconds_now();
  const QuadMesh mesh = bow_mesh(bow);
  sample.errors.push_back(degrees(largest_difference(bow.angles, measure_angles(mesh, bow_beam(bow)))));
  const MeshCheck check = check_mesh(mesh);
  sample.seconds += seconds_now() - start;
  sample.broken += check.ok() ? 0 : 1;
  sample.warp = std::max(sample.warp, check.max_warp);
  sample.aspect = std::max(sample.aspect, check.max_bow_aspect);
  sample.hull_aspect = std::max(sample.hull_aspect, check.max_aspect);
}

Family sampled(BowFamily family, int bows, unsigned seed) {
  Family result;
  std::mt19937 random(seed + static_cast<unsigned>(family));
  for (int tried = 0; result.feasible < bows && tried < most_tried; ++tried) {
    BowParameters bow = random_bow(family, random);
    if (!check_feasibility(bow).feasible) continue;
    ++result.feasible;
    for (std::size_t k = 0; k < densities.size(); ++k) {
      bow.panel = bow.B / densities[k];
      add(result.at[k], bow);
    }
  }
  return result;
}

Jointly joint_feasibility(BowFamily family, unsigned seed) {
  Jointly result;
  std::mt19937 random(seed + static_cast<unsigned>(family));
  for (int k = 0; k < asked; ++k) {
    const BowParameters bow = random_bow(family, random);
    const BowFeasibility feasibility = check_feasibility(bow);
    for (const Margin& g : feasibility.margins)
      if (g.required && g.value < 0.0) ++result.refused[g.name];
    if (!feasibility.feasible) continue;
    const BowAngles& a = bow.angles;
    result.quarter_waterline.push_back(degrees(std::atan(std::tan(a.flare) * std::tan(a.buttock))));
    result.stem_less_buttock.push_back(degrees(a.stem - a.buttock));
    result.ratio.push_back(bow.Lf / bow_beam(bow));
  }
  return result;
}

double quantile(std::vector<double> values, double q) {
  if (values.empty()) return 0.0;
  std::sort(values.begin(), values.end());
  return values[static_cast<std::size_t>(q * static_cast<double>(values.size() - 1))];
}

void print_quality(BowFamily family, const Family& f) {
  for (std::size_t k = 0; k < densities.size(); ++k) {
    const Sample& s = f.at[k];
    std::printf("| `%s` | B/%g | %d | %.4f | %.4f | %d | %.4f | %.1f | %.1f | %.1f |\n",
                family_form(family).key, densities[k], f.feasible,
                *std::max_element(s.errors.begin(), s.errors.end()), quantile(s.errors, 0.99), s.broken,
                s.warp, s.aspect, s.hull_aspect, 1e3 * s.seconds / f.feasible);
  }
}

void print_jointly(BowFamily family, Jointly j) {
  std::printf("| `%s` | %.0f %% |", family_form(family).key,
              100.0 * static_cast<double>(j.ratio.size()) / asked);
  for (const char* g : {"g1", "g2", "g3", "g5", "g7"})
    std::printf(" %.0f %% |", 100.0 * j.refused[g] / asked);
  const auto range = [](const std::vector<double>& v, const char* pattern) {
    std::printf(pattern, quantile(v, 0.01), quantile(v, 0.99));
  };
  range(j.quarter_waterline, " %.0f to %.0f |");
  range(j.stem_less_buttock, " %+.0f to %+.0f |");
  range(j.ratio, " %.2f to %.2f |\n");
}

// The median of some repeats of each part, at the default panel size.
void print_preset(BowFamily family) {
  constexpr int repeats = 9;
  const BowParameters bow = preset_bow(family);
  std::vector<double> mesh_ms, angles_ms, check_ms;
  MeshCheck check;
  for (int k = 0; k < repeats; ++k) {
    const double start = seconds_now();
    const QuadMesh mesh = bow_mesh(bow);
    const double meshed = seconds_now();
    if (!angle_mismatch(bow.angles, measure_angles(mesh, bow_beam(bow))).empty()) return;
    const double measured = seconds_now();
    check = check_mesh(mesh);
    mesh_ms.push_back(1e3 * (meshed - start));
    angles_ms.push_back(1e3 * (measured - meshed));
    check_ms.push_back(1e3 * (seconds_now() - measured));
  }
  std::printf("| `%s` | %d | %.1f | %.1f | %.0f | %.1f | %.1f |\n", family_form(family).key,
              check.quads + check.triangles, quantile(mesh_ms, 0.5), quantile(angles_ms, 0.5),
              quantile(check_ms, 0.5), check.max_bow_aspect, check.max_aspect);
}

void print_presets() {
  std::printf(
      "| family | panels | mesh, ms | angles, ms | CGAL's check, ms | max aspect, bow | whole hull |\n"
      "|---|---|---|---|---|---|---|\n");
  for (const BowFamily family : all_families()) print_preset(family);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc == 2 && std::string(argv[1]) == "presets") {
    print_presets();
    return 0;
  }
  const int bows = argc > 1 ? std::atoi(argv[1]) : 1000;
  const unsigned seed = argc > 2 ? static_cast<unsigned>(std::atoi(argv[2])) : 1;
  if (bows < 1) {
    std::fprintf(stderr, "bow_angles [BOWS] [SEED] or bow_angles presets: BOWS must be a positive number\n");
    return 2;
  }
  std::printf(
      "| family | panel | bows | max error, deg | 99 %% | broken | max warp | max aspect, bow | whole hull | "
      "ms a hull |\n"
      "|---|---|---|---|---|---|---|---|---|---|\n");
  for (const BowFamily family : all_families()) {
    const Family result = sampled(family, bows, seed);
    if (result.feasible > 0) print_quality(family, result);
    std::fflush(stdout);
  }
  std::printf(
      "\n| family | feasible | g1 | g2 | g3 | g5 | g7 | waterline at B/4, deg | stem - buttock, deg | Lf/B "
      "|\n"
      "|---|---|---|---|---|---|---|---|---|---|\n");
  for (const BowFamily family : all_families()) print_jointly(family, joint_feasibility(family, seed));
  return 0;
}
