#include "study/plan/first_study.h"

#include <catch2/catch.hpp>

#include "base/errors.h"
#include "hullgen/bow/family.h"
#include "hullgen/bow/feasibility.h"
#include "study/plan/feasible_box.h"
#include "study/spec/read_study.h"

namespace icebow {

TEST_CASE("a first study is feasible, for every family and for ships from a tug to a tanker") {
  const double ships[][3] = {{147.2, 23.0, 8.0}, {60.0, 16.0, 5.0}, {110.0, 22.0, 7.5}, {280.0, 46.0, 15.0}};
  for (const BowFamily family : all_families()) {
    for (const auto& [length, beam, draft] : ships) {
      FirstStudy ship;
      ship.family = family;
      ship.length = length, ship.beam = beam, ship.draft = draft;
      CAPTURE(family_form(family).key, length);
      const StudySpec spec = read_study(first_study(ship), "first");
      CHECK(check_feasibility(spec.baseline.bow).feasible);
      CHECK(spec.baseline.bow.B == beam);
      const FeasibleBox box = feasible_box(spec);
      CHECK(box.feasible > 0.97 * box.tried);  // bounds are rounded to 0.01 deg after they were tried
      CHECK(spec.method.variables.size() >= 3);
    }
  }
}

TEST_CASE("a ship that no bow of the family fits is refused in words") {
  FirstStudy barge;
  barge.length = 20.0, barge.beam = 19.0, barge.draft = 15.0;
  CHECK_THROWS_AS(first_study(barge), InputError);
}

}  // namespace icebow
