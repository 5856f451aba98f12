// Ranges of a bow's dimensions and angles: what must hold before any cotangent is taken.
#pragma once

#include <string>

#include "hullgen/bow/bow.h"

namespace icebow {

// The first dimension that is not a finite number or out of range, in words with what to change; "" where all
// are fine.
std::string dimension_problem(const BowParameters& bow);

// Distance of the angle nearest to the end of its range [rad], negative outside, -1 for an angle that is not
// a number. Stem, buttock and flare are taken from 1 to 89 deg, where cotangents are tame; waterline from 1
// to 90 deg.
struct AngleRange {
  double margin = 0.0;  //!< [rad]
  std::string sentence;
};
AngleRange angle_range(const BowAngles& angles);

}  // namespace icebow
