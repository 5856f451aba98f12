#include "hullgen/bow/family.h"

#include "base/units.h"

namespace icebow {
namespace {

constexpr double steep_deck = radians(60.0), flared_deck = radians(45.0);

FamilyRanges ranges_deg(Range stem, Range waterline, Range buttock, Range flare, Range bow_length) {
  const auto rad = [](Range r) { return Range{radians(r.lower), radians(r.upper)}; };
  return {rad(stem), rad(waterline), rad(buttock), rad(flare), bow_length};
}

// clang-format off
// In the order of the enumeration.
const std::vector<FamilyForm>& forms() {
  static const std::vector<FamilyForm> table = {
    // key, name, monotone, convex, faired, from, n, straight stem, forefoot, deck, reamers, chines, curvature
    {"straight_parallel_buttocks", "straight stem with parallel buttocks", true, true, true, 0.0, 6.0, true, 1.0, steep_deck, false, false, false,
     ranges_deg({20, 30}, {18, 30}, {20, 32}, {25, 45}, {1.0, 1.6})},
    {"thyssen_waas", "simplified Thyssen-Waas", true, false, false, 0.0, 6.0, false, 1.0, steep_deck, false, false, false,
     ranges_deg({10, 18}, {39, 90}, {10, 16}, {70, 88}, {0.15, 0.6})},
    {"concave", "concave (White)", true, true, true, 0.0, 6.0, true, 0.5, steep_deck, false, false, true,
     ranges_deg({15, 25}, {24, 32}, {18, 26}, {35, 50}, {1.0, 1.4})},
    {"high_flare", "high flare (Melville)", true, true, true, 0.0, 6.0, true, 1.0, flared_deck, false, false, true,
     ranges_deg({18, 24}, {28, 40}, {16, 24}, {50, 65}, {0.8, 1.1})},
    {"spoon_reamers", "spoon with reamers", true, true, true, 0.4, 2.0, false, 1.5, steep_deck, true, false, true,
     ranges_deg({18, 25}, {50, 90}, {18, 25}, {60, 75}, {0.4, 0.7})},
    {"semi_spoon_chines", "semi-spoon with chines", true, true, true, 0.0, 2.0, false, 1.25, steep_deck, false, true, true,
     ranges_deg({20, 25}, {40, 60}, {18, 26}, {50, 65}, {0.6, 0.9})},
    {"flat", "flat", true, true, true, 0.6, 2.0, false, 1.0, steep_deck, false, false, true,
     ranges_deg({18, 25}, {75, 90}, {18, 25}, {75, 88}, {0.2, 0.4})},
    {"thyssen_waas_side_edges", "Thyssen-Waas with side edges", false, false, false, 0.0, 6.0, false, 1.0, steep_deck, false, false, true,
     ranges_deg({10, 18}, {39, 90}, {10, 16}, {70, 88}, {0.15, 0.6})},
  };
  return table;
}

struct Preset {
  double stem, waterline, buttock, flare;  // [deg]
  double L, B, T, D, Lf;                   // [m]
};
Preset preset(BowFamily family) {
  switch (family) {
    case BowFamily::straight_parallel_buttocks: return {24.35, 22.0, 28.0, 33.0, 147.2, 23.0, 8.0, 13.5, 32.5};
    case BowFamily::thyssen_waas:               return {14.0, 39.0, 13.0, 77.0, 100.0, 20.0, 7.0, 12.0, 10.0};
    case BowFamily::concave:                    return {20.0, 28.0, 22.0, 44.0, 120.0, 23.0, 8.0, 13.5, 30.0};
    case BowFamily::high_flare:                 return {21.0, 36.0, 20.0, 57.0, 120.0, 23.0, 8.0, 13.5, 23.0};
    case BowFamily::spoon_reamers:              return {21.5, 70.0, 21.0, 68.0, 100.0, 20.0, 7.0, 12.0, 12.0};
    case BowFamily::semi_spoon_chines:          return {22.5, 50.0, 22.0, 60.0, 110.0, 22.0, 8.0, 13.0, 18.0};
    case BowFamily::flat:                       return {21.5, 82.0, 21.5, 81.0, 90.0, 20.0, 6.0, 10.5, 6.0};
    case BowFamily::thyssen_waas_side_edges:    return {14.0, 55.0, 13.0, 75.0, 100.0, 20.0, 7.0, 12.0, 4.0};
  }
  return {};
}
// clang-format on

}  // namespace

const FamilyForm& family_form(BowFamily family) {
  return forms().at(static_cast<std::size_t>(family));
}

const std::vector<BowFamily>& all_families() {
  static const std::vector<BowFamily> all = [] {
    std::vector<BowFamily> families;
    for (std::size_t k = 0; k < forms().size(); ++k) families.push_back(static_cast<BowFamily>(k));
    return families;
  }();
  return all;
}

std::vector<std::string> family_keys() {
  std::vector<std::string> keys;
  for (const FamilyForm& form : forms()) keys.push_back(form.key);
  return keys;
}

BowFamily family_of_key(const std::string& key) {
  for (const BowFamily family : all_families())
    if (family_form(family).key == key) return family;
  return all_families().front();
}

BowParameters preset_bow(BowFamily family) {
  const Preset p = preset(family);
  BowParameters bow;
  bow.family = family;
  bow.angles = {radians(p.stem), radians(p.waterline), radians(p.buttock), radians(p.flare)};
  bow.L = p.L;
  bow.B = p.B;
  bow.T = p.T;
  bow.D = p.D;
  bow.Lf = p.Lf;
  if (family_form(family).reamers) bow.reamer_step = usual_reamer_step * bow.B;
  if (family_form(family).chines) bow.chine = usual_chine;
  return bow;
}

double reamer_step(const BowParameters& bow) {
  return family_form(bow.family).reamers ? bow.reamer_step : 0.0;
}
double bow_beam(const BowParameters& bow) {
  return bow.B + 2.0 * reamer_step(bow);
}

}  // namespace icebow
