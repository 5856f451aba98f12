// Numbers of every rank for every rank, which travel while the ranks work on.
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "base/communicator.h"

namespace icebow {

class EverywhereGather {
 public:
  // Collective. So many numbers of this rank, each time.
  EverywhereGather(const Communicator& comm, std::size_t own);
  ~EverywhereGather();
  EverywhereGather(EverywhereGather&&) noexcept;
  EverywhereGather& operator=(EverywhereGather&&) noexcept;

  std::size_t size() const;  // of all ranks
  // All ranks make the same calls: start() with this rank's numbers, which waits for nobody, then finish(),
  // which gives those of all in rank order.
  void start(const std::vector<double>& own);
  bool under_way() const;
  const std::vector<double>& finish();

 private:
  struct Message;
  std::unique_ptr<Message> message_;
};

}  // namespace icebow
