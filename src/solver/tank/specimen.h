// The pieces of ice that virtual tests are made on.
#pragma once

#include "solver/model/scenario.h"

namespace icebow {

// lround(h / dx). Throws InputError for a single layer, which cannot bend.
int tested_layers(const Scenario& scenario);

// nx by ny particles of the scenario's ice, as thick as its sheet, free on all sides.
Scenario specimen(const Scenario& scenario, int nx, int ny, int layers);

}  // namespace icebow
