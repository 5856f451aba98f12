// Two runs whose ice broke alike, bit for bit.
#pragma once

#include "solver/model/breaking_process.h"

namespace icebow {

inline bool same_process(const BreakingProcess& a, const BreakingProcess& b) {
  if (a.cracks.list.size() != b.cracks.list.size() || a.ice.floes.size() != b.ice.floes.size() ||
      a.ice.channel.size() != b.ice.channel.size())
    return false;
  bool same = a.cracks.isolated == b.cracks.isolated && a.ice.volume == b.ice.volume &&
              a.ice.in_floes == b.ice.in_floes && a.ice.dust == b.ice.dust &&
              a.energy.hull_work == b.energy.hull_work && a.load.clear == b.load.clear;
  for (std::size_t n = 0; n < a.cracks.list.size(); ++n) {
    const Crack &x = a.cracks.list[n], &y = b.cracks.list[n];
    same = same && x.kind == y.kind && x.opened == y.opened && x.x == y.x && x.y == y.y &&
           x.length == y.length && x.columns == y.columns;
  }
  for (std::size_t n = 0; n < a.ice.floes.size(); ++n) {
    const Floe &x = a.ice.floes[n], &y = b.ice.floes[n];
    same = same && x.area == y.area && x.length == y.length && x.x == y.x && x.through == y.through;
  }
  for (std::size_t n = 0; n < a.ice.channel.size(); ++n)
    same = same && a.ice.channel[n].width == b.ice.channel[n].width;
  return same;
}

}  // namespace icebow
