// What came loose of the sheet: floes, crushed ice, dust, and the channel they leave. docs/theory.md, "The
// breaking process".
#pragma once

#include <unordered_set>
#include <vector>

#include "solver/ice/sheet_state.h"
#include "solver/model/breaking_process.h"

namespace icebow {

// Counts the ice of a sheet once, in parts where a moving window drops it piece by piece. On the root alone.
class DetachedIceCount {
 public:
  // The columns i < `end` of the state, with every floe that reaches into them and was not counted before.
  // The channel is measured where x_from <= x <= x_to.
  void add(const SheetState& state, int end, double x_from, double x_to);
  const DetachedIce& total() const { return total_; }

  // As a checkpoint keeps it.
  std::vector<double> record() const;
  void restore(const std::vector<double>& record);

 private:
  void add_volumes(const SheetState& state, int end);
  void add_floes(const SheetState& state, int end);
  bool counted(const Lattice& lattice, int i, int j, int k) const;
  void remember(const Lattice& lattice, int i, int j, int k);

  DetachedIce total_;
  std::unordered_set<std::int64_t> counted_;  // particles still there, of floes already counted
};

}  // namespace icebow
