// Curves of form and righting levers on one page, as a naval architect files them: an SVG drawing with a
// table.
#pragma once

#include <string>
#include <vector>

#include "hullgen/drawing/lines_plan.h"
#include "hullgen/hydro/curves_of_form.h"

namespace icebow {

struct CurvesPage {
  std::string title;
  std::vector<FormAtDraft> curves;    // by growing draft, two at least
  FormAtDraft at_draft;               // at the design draught, drawn as a line across
  std::vector<RightingLever> levers;  // by growing heel
  double KG = 0.0;                    //!< height of the centre of gravity [m]; 0: levers are KN
  double water_density = 0.0;         //!< [kg/m^3]
};

// A self-contained <svg> element in the colours of lines_plan_svg().
std::string curves_page_svg(const CurvesPage& page, DrawnFor reader = DrawnFor::screen);

}  // namespace icebow
