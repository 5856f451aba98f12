// Which columns and rows of the bow's grid are still there in the ring that runs aft from its edge. Behind
// the bow panels grow; what is thinned out stays out.
#pragma once

#include <functional>
#include <vector>

#include "hullgen/bow/bow_grid.h"

namespace icebow {

// A node of the bow patch's grid: column j from -columns (starboard) to +columns (port), row i from the keel
// up.
struct GridNode {
  int j, i;
};

class RingThinning {
 public:
  // Neighbours are joined by the length of the panels they make, so that those stay well shaped.
  // The column at the eta `kept` stays.
  RingThinning(const BowSurface& bow, const BowGrid& grid, double kept, double panel);

  double longest_cell() const;  //!< that panels may have from station to station [m]
  // On to a station that lies `cell` [m] behind the one before, where the ring's nodes stand at `place`. No
  // two neighbours go at one station.
  void advance(double cell, const std::function<Vec3(GridNode)>& place);

  bool column(int j) const { return columns_[static_cast<std::size_t>(j < 0 ? -j : j)]; }
  bool row(int i) const { return rows_[static_cast<std::size_t>(i)]; }

 private:
  using Length = std::function<double(int a, int b)>;
  using Limit = std::function<double(int)>;
  using Bend = std::function<bool(int a, int b, int c)>;

  // First, last and `fixed` stay, and b where the line a-b-c is bent aft.
  static void join(std::vector<char>& kept, int fixed, const Length& length, const Limit& longest,
                   const Bend& bent);

  double panel_, bilge_;
  int fixed_column_ = 0;
  int bilge_rows_ = 0;  // rows up to here take part in the rounding of the bilge
  std::vector<char> columns_, rows_;
};

}  // namespace icebow
