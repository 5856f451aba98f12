#include "tests/support/paper_bows.h"

#include "hullgen/bow/family.h"

namespace icebow {

BowParameters conventional_bow() {
  return preset_bow(BowFamily::straight_parallel_buttocks);
}
BowParameters thyssen_waas_bow() {
  return preset_bow(BowFamily::thyssen_waas);
}

BowParameters random_bow(BowFamily family, std::mt19937& random) {
  const auto in = [&](Range r) { return std::uniform_real_distribution<>(r.lower, r.upper)(random); };
  const FamilyForm& form = family_form(family);
  BowParameters bow;
  bow.family = family;
  bow.angles.stem = in(form.ranges.stem);
  bow.angles.waterline = in(form.ranges.waterline);
  bow.angles.buttock = in(form.ranges.buttock);
  bow.angles.flare = in(form.ranges.flare);
  bow.L = in({80, 160});
  bow.B = in({15, 30});
  bow.T = in({5, 10});
  bow.D = bow.T + in({3, 6});
  if (form.reamers) bow.reamer_step = bow.B * in({0.02, 0.06});
  if (form.chines) bow.chine = in({0.65, 0.9});
  bow.Lf = bow_beam(bow) * in(form.ranges.bow_length);
  return bow;
}

}  // namespace icebow
