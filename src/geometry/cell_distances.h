// How far the cells of a uniform grid are from marked ones.
#pragma once

#include <cstdint>
#include <vector>

namespace icebow {

// Of n[0] x n[1] x n[2] cells, x running fastest, the steps to the nearest marked one, a step going to any of
// the 26 cells around: 0 for marked cells, `most_cells_away` where it is that or more.
constexpr std::uint8_t most_cells_away = 200;
std::vector<std::uint8_t> cell_distances(const int (&n)[3], const std::vector<std::uint8_t>& marked);

}  // namespace icebow
