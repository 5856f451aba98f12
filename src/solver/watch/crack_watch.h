// Where and when the ice cracked: columns of particles whose bonds break, watched at the record's samples.
//
// A column (i, j) is the particles above one another at one place of the sheet. It has cracked once a quarter
// of the bonds it began with are broken: beside a straight crack a particle loses 0.4 of its bonds in the
// first row and 0.2 in the second (horizon of three spacings), so a crack is a column wide on either side. It
// is crushed once three quarters are: more than two crossing cracks break. docs/theory.md, "The breaking
// process".
#pragma once

#include <cstdint>
#include <limits>
#include <unordered_map>
#include <vector>

#include "base/communicator.h"
#include "solver/ice/sheet.h"

namespace icebow {

struct CrackedColumn {
  std::int64_t i = 0, j = 0;  // i from the edge the ship came in by, whatever a moving window has dropped
  double opened = 0.0;        //!< advance at which it had cracked [m]
  double crushed = std::numeric_limits<double>::infinity();  //!< advance [m]; infinite: it never was
  // Direction of the crack's normal: mean of cos and sin of twice the angle to the course, over the bonds
  // that were broken when it opened, each with the square of its length in the plane. (0, 0) is no direction.
  double cos2 = 0.0, sin2 = 0.0;
};

class CrackWatch {
 public:
  // Looks after so many samples that the ship has sailed at most one spacing.
  CrackWatch(double dx, double advance_per_sample);

  bool is_due(std::int64_t samples) const { return samples % samples_per_look_ == 0; }
  // Collective. Every rank learns of every column; of a half model those of the port half.
  void look(const Communicator& comm, const IceSheet& sheet, double advance);

  // In the order of opening, those of one look by (i, j): the same on any number of ranks.
  const std::vector<CrackedColumn>& columns() const { return columns_; }
  void restore(std::vector<CrackedColumn> columns);

 private:
  void learn(const std::vector<double>& events, double advance);

  std::int64_t samples_per_look_;
  std::vector<CrackedColumn> columns_;
  std::unordered_map<std::int64_t, std::size_t> known_;  // where in the list, by key
};

}  // namespace icebow
