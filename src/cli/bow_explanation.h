// What the four angles of a bow mean to those who ask for angles: the tangent planes at P0 and P1, Lindqvist,
// the Finnish-Swedish ice class rules (FSICR), IACS UR I2, and how near each angle is to a limit.
#pragma once

#include "base/json.h"
#include "hullgen/bow/bow.h"

namespace icebow {

// FSICR: alpha waterline at B/4, phi_1 rake of the stem at the centreline, phi_2 rake of the bow at B/4, psi
// = atan(tan phi_2 / sin alpha) [FSICR2021]. UR I2: alpha waterline angle, gamma buttock angle, tan beta =
// tan alpha / tan gamma (frame angle), tan beta' = tan beta cos alpha (normal frame angle) [IACSURI2]. Both
// rules name the upper ice waterline, for which the design waterline stands here.
// An imported hull is of no family, so its angles have no usual ranges.
std::string explanation_text(const BowParameters& bow, bool generated);
// {"planes", "lindqvist_psi_deg", "fsicr_deg", "ur_i2_deg", "limits"}
Json explanation_json(const BowParameters& bow, bool generated);

}  // namespace icebow
