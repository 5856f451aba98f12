#include "study/spec/case_hull.h"

#include "hullgen/bow/feasibility.h"
#include "hullgen/bow/make_hull.h"
#include "hullgen/import/hull_deformation.h"

namespace icebow {

bool is_deformed(const Case& c) {
  if (!c.own.given()) return false;
  const BowAngles &own = c.own.imported->measured.angles, &asked = c.bow.angles;
  return asked.stem != own.stem || asked.waterline != own.waterline || asked.buttock != own.buttock ||
         asked.flare != own.flare;
}

Hull make_hull(const Case& c) {
  if (!c.own.given()) return make_hull(c.bow);
  return is_deformed(c) ? deformed(*c.own.imported, c.bow.angles) : as_hull(*c.own.imported);
}

BowFeasibility check_feasibility(const Case& c) {
  if (!c.own.given()) return check_feasibility(c.bow);
  BowFeasibility feasibility;
  feasibility.feasible = true;
  return feasibility;
}

}  // namespace icebow
