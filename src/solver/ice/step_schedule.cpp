#include "solver/ice/step_schedule.h"

#include <algorithm>

#include "solver/ice/mirror.h"

namespace icebow {

StepSchedule::StepSchedule(const Communicator& comm, IceSheet& sheet, PhaseTimer& timer)
    : sheet_(sheet),
      timer_(timer),
      displacements_(comm, sheet.partition, sheet.layout,
                     {&sheet.u[0], &sheet.u[1], &sheet.u[2], &sheet.extra_strength}, ghost_blocks, 0),
      dilatations_(comm, sheet.partition, sheet.layout, {&sheet.theta}, ghost_blocks, 1) {}

std::int64_t StepSchedule::run(const Move& move, const std::function<void()>& moved) {
  displace(move);
  moved();
  const std::int64_t broken = dilate();
  return broken + accelerate();
}

void StepSchedule::refresh() {
  displacements_.exchange();
  mirror_displacements(sheet_);
}

std::int64_t StepSchedule::look_again() {
  displacements_.start();
  displacements_.send(Halo::south);
  displacements_.send(Halo::north);
  for (int c = 0; c < displacements_.chunks(); ++c) displacements_.send(Halo::chunk(c));
  const std::int64_t broken = dilate();
  dilatations_.wait(Halo::south);
  dilatations_.wait(Halo::north);
  for (int c = 0; c < dilatations_.chunks(); ++c) dilatations_.wait(Halo::chunk(c));
  mirror_dilatations(sheet_);
  return broken;
}

void StepSchedule::displace(const Move& move) {
  Halo& halo = displacements_;
  const int n = sheet_.layout.columns, low = std::min(reach, n), high = std::max(low, n - reach);
  const bool apart = n >= 2 * reach;  // the edges
  halo.start();
  // The northern one first: there is no hull for which the neighbour would have to wait.
  if (high < n) move(high, n);
  if (apart) halo.send(Halo::north);
  move(0, low);
  halo.send(Halo::south);
  if (!apart) halo.send(Halo::north);
  timer_.lap(Phase::halo_u);
  for (int c = 0; c < halo.chunks(); ++c) {
    const int begin = std::max(low, halo.chunk_begin(c)), end = std::min(high, halo.chunk_end(c));
    if (begin < end) move(begin, end);
    halo.send(Halo::chunk(c));
    timer_.lap(Phase::halo_u);
  }
}

std::int64_t StepSchedule::dilate() {
  dilatations_.start();
  displacements_.wait(Halo::south);
  std::int64_t broken = 0;
  const int chunks = displacements_.chunks();
  int arrived = 0;  // chunks, and the north edge after the last
  for (int c = 0; c < chunks; ++c) {
    // A chunk has at least `reach` columns, as far as a column looks.
    for (; arrived <= std::min(c + 1, chunks); ++arrived)
      displacements_.wait(arrived == chunks ? Halo::north : Halo::chunk(arrived));
    timer_.lap(Phase::halo_u);
    if (c == 0) mirror_displacements(sheet_);
    broken += sheet_.dilatation(displacements_.chunk_begin(c), displacements_.chunk_end(c));
    timer_.lap(Phase::dilatation);
    if (c == 0) dilatations_.send(Halo::south);
    dilatations_.send(Halo::chunk(c));
    timer_.lap(Phase::halo_theta);
  }
  dilatations_.send(Halo::north);
  return broken;
}

std::int64_t StepSchedule::accelerate() {
  std::int64_t broken = 0;
  dilatations_.wait(Halo::north);
  dilatations_.wait(Halo::chunk(dilatations_.chunks() - 1));
  for (int c = dilatations_.chunks() - 1; c >= 0; --c) {
    dilatations_.wait(c > 0 ? Halo::chunk(c - 1) : Halo::south);
    if (c == 0) mirror_dilatations(sheet_);
    timer_.lap(Phase::halo_theta);
    broken += sheet_.force(dilatations_.chunk_begin(c), dilatations_.chunk_end(c));
    timer_.lap(Phase::force);
  }
  return broken;
}

}  // namespace icebow
