// Damaged meshes of our own bows (tests/support/damaged_mesh.h), thousands of them: how many are mended with
// a volume within 0.5 % and angles within 0.5 deg of those of the sound hull, how many are refused, and how
// many are wrong.
//   damaged_meshes [MESHES [FIRST_SEED [PANELS_PER_BEAM]]]
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <string>

#include "base/errors.h"
#include "base/units.h"
#include "hullgen/bow/bow_angles.h"
#include "hullgen/bow/bow_mesh.h"
#include "hullgen/bow/family.h"
#include "hullgen/hydro/hydrostatics.h"
#include "hullgen/import/imported_hull.h"
#include "tests/support/damaged_mesh.h"

using namespace icebow;

namespace {

struct Counts {
  int mended = 0, wrong = 0, told = 0;  // `told`: off, with a warning
  std::map<std::string, int> refused;   // by the first words of the reason
};

std::string kind_of(const std::string& reason) {
  std::string words = reason.substr(reason.find(": ") + 2, 60);
  words = words.substr(0, words.find_first_of("0123456789(,"));
  return words;
}

void run(std::uint64_t seed, double panels, Counts& counts) {
  const auto& families = all_families();
  BowParameters bow = preset_bow(families[seed % families.size()]);
  bow.panel = bow.B / panels;
  const QuadMesh sound = bow_mesh(bow);
  const DamagedMesh bad = damaged(sound, seed);
  try {
    const ImportedHull hull = hull_of_mesh(bad.mesh, "damaged");
    const double volume = displaced_volume(hull.mesh, 0.0) / displaced_volume(sound, 0.0) - 1.0;
    const BowAngles& own = hull.measured.spread;
    // An angle that is off by no more than its spread and 0.5 deg is told.
    const double spread = degrees(std::max({own.stem, own.waterline, own.buttock, own.flare}));
    const double angle = degrees(largest_difference(hull.measured.angles, bow.angles));
    if (std::abs(volume) <= 5e-3 && angle <= 0.5) {
      ++counts.mended;
      return;
    }
    const bool told = !hull.repairs.warnings.empty() || (std::abs(volume) <= 5e-3 && angle <= 0.5 + spread);
    ++(told ? counts.told : counts.wrong);
    std::printf("seed %llu, %s, %s: volume off by %.2f %%, angles by %.2f deg%s\n",
                static_cast<unsigned long long>(seed), family_form(bow.family).key, bad.damage.c_str(),
                100.0 * volume, angle, told ? ", told by a warning or the spread" : "");
  } catch (const InputError& error) {
    if (++counts.refused[kind_of(error.what())] <= 3)
      std::printf("seed %llu, %s: refused: %s\n", static_cast<unsigned long long>(seed), bad.damage.c_str(),
                  error.what());
  }
}

}  // namespace

int main(int argc, char** argv) {
  const int meshes = argc > 1 ? std::atoi(argv[1]) : 10000;
  const auto first = static_cast<std::uint64_t>(argc > 2 ? std::atoll(argv[2]) : 0);
  const double panels = argc > 3 ? std::atof(argv[3]) : 12.0;
  Counts counts;
  for (int k = 0; k < meshes; ++k) run(first + static_cast<std::uint64_t>(k), panels, counts);
  std::printf(
      "%d meshes: %d mended with the right volume and angles, %d off and told (warning or spread), %d wrong "
      "without a "
      "word\n",
      meshes, counts.mended, counts.told, counts.wrong);
  for (const auto& [reason, n] : counts.refused) std::printf("  refused %d: %s\n", n, reason.c_str());
  return counts.wrong == 0 ? 0 : 1;
}
