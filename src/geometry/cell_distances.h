// How far the cells of a uniform grid are from marked ones.
#pragma once

#include <cstdint>
#include <vector>

namespace icebow {

// For each of n[0] x n[1] x n[2] cells, x running fastest: steps to the nearest marked cell. A step goes to
// any of the 26 cells around. 0 for marked cells; `most_cells_away` stands for as many or more.
constexpr std::uint8_t most_cells_away = 200;
std::vector<std::uint8_t> cell_distances(const int (&n)[3], const std::vector<std::uint8_t>& marked);

}  // namespace icebow
