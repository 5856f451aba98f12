#include "geometry/cell_distances.h"

#include <algorithm>
#include <cstddef>

namespace icebow {
namespace {

std::uint8_t nearer(std::uint8_t now, int one_away) {
  return static_cast<std::uint8_t>(std::min<int>(now, one_away + 1));
}

// A row of cells from one beside it.
void improve(std::uint8_t* row, const std::uint8_t* beside, int n) {
  for (int x = 0; x < n; ++x) row[x] = nearer(row[x], beside[x]);
  for (int x = 1; x < n; ++x) row[x] = nearer(row[x], beside[x - 1]);
  for (int x = 0; x + 1 < n; ++x) row[x] = nearer(row[x], beside[x + 1]);
}

}  // namespace

// Two sweeps, upwards and downwards, each from the 13 cells that come before: exact for such steps.
std::vector<std::uint8_t> cell_distances(const int (&n)[3], const std::vector<std::uint8_t>& marked) {
  std::vector<std::uint8_t> away(marked.size());
  std::transform(marked.begin(), marked.end(), away.begin(),
                 [](std::uint8_t m) { return m ? std::uint8_t(0) : most_cells_away; });
  const auto row = [&](int y, int z) { return &away[n[0] * (y + std::size_t(n[1]) * z)]; };
  for (const int step : {1, -1}) {
    const auto place = [step](int count, int size) { return step > 0 ? count : size - 1 - count; };
    for (int countz = 0; countz < n[2]; ++countz) {
      for (int county = 0; county < n[1]; ++county) {
        const int y = place(county, n[1]), z = place(countz, n[2]);
        std::uint8_t* const own = row(y, z);
        if (county > 0) improve(own, row(y - step, z), n[0]);
        for (int beside = std::max(0, y - 1); countz > 0 && beside <= std::min(n[1] - 1, y + 1); ++beside)
          improve(own, row(beside, z - step), n[0]);
        for (int countx = 1; countx < n[0]; ++countx) {
          const int x = place(countx, n[0]);
          own[x] = nearer(own[x], own[x - step]);
        }
      }
    }
  }
  return away;
}

}  // namespace icebow
