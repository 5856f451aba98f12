// The whole sheet on one rank: pieces, channel, volumes, pictures. Made at snapshots and at the end, never in
// a step.
#pragma once

#include <cstdint>
#include <vector>

#include "base/communicator.h"
#include "solver/ice/ice_cloud.h"
#include "solver/ice/sheet.h"
#include "solver/model/metrics.h"

namespace icebow {

// Particles in the order of Lattice::id; both halves of a half model.
struct SheetState {
  Lattice lattice;
  std::vector<float> u[3];
  std::vector<float> damage;        // broken / initial bonds
  std::vector<std::int32_t> piece;  // 0 = standing sheet, 1.. = floes, largest first, -1 = crushed
  int floes = 0;
};

// Collective; the root gets the state, the others an empty one.
SheetState gather_state(const Communicator& comm, const IceSheet& sheet);

IceCloud cloud(const SheetState& state);

// Around the centre line the top layer does not stand between these y, at column i [m]; equal where it
// stands.
struct ChannelEdges {
  double starboard = 0.0, port = 0.0;
};
ChannelEdges channel_edges(const SheetState& state, int i);
// Their distance [m].
double channel_width(const SheetState& state, int i);

// Fills the damage, channel and volume parts of the metrics. The channel is measured at the stations x in
// [x_from, x_to] (reference positions) as the width around the centre line in which nothing stands any more.
void measure_sheet(const SheetState& state, double x_from, double x_to, double beam, Metrics& metrics);

}  // namespace icebow
