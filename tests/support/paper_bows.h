// The two bows of the paper (full scale), and random ones in each family's usual range.
#pragma once

#include <random>

#include "hullgen/bow/bow.h"

namespace icebow {

BowParameters conventional_bow();
BowParameters thyssen_waas_bow();
// Not necessarily feasible.
BowParameters random_bow(BowFamily family, std::mt19937& random);

}  // namespace icebow
