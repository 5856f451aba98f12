// What ranks do together with values: gather, broadcast, fail. Everything here is collective.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <exception>
#include <memory>
#include <string>
#include <type_traits>
#include <vector>

#include "base/communicator.h"

namespace icebow {

// The root gets every rank's items in rank order, the others get nothing.
template <class T>
std::vector<T> gather(const Communicator& comm, const std::vector<T>& own) {
  static_assert(std::is_trivially_copyable_v<T>, "travels as bytes");
  const char* const bytes = reinterpret_cast<const char*>(own.data());
  std::vector<T> all;
  for (const std::vector<char>& part : comm.gather({bytes, bytes + own.size() * sizeof(T)})) {
    const std::size_t before = all.size();
    all.resize(before + part.size() / sizeof(T));
    if (!part.empty()) std::memcpy(static_cast<void*>(all.data() + before), part.data(), part.size());
  }
  return all;
}

// Every rank gets the root's value.
template <class T>
void broadcast(const Communicator& comm, T& value) {
  static_assert(std::is_trivially_copyable_v<T>, "travels as bytes");
  comm.broadcast(static_cast<void*>(&value), sizeof value);
}
template <class T>
void broadcast(const Communicator& comm, std::vector<T>& values) {
  static_assert(std::is_trivially_copyable_v<T>, "travels as bytes");
  std::uint64_t n = values.size();
  broadcast(comm, n);
  values.resize(n);
  comm.broadcast(static_cast<void*>(values.data()), n * sizeof(T));
}

// What went wrong while `act` ran; empty where nothing did.
template <class Act>
std::string trouble_in(const Act& act) {
  try {
    act();
  } catch (const std::exception& error) {
    return *error.what() ? error.what() : "an exception without a message";
  }
  return "";
}

// Every rank acts. Where it goes wrong on any of them, all throw RuntimeError with the words of the first; a
// rank that is alone throws what it met.
template <class Act>
void act_together(const Communicator& comm, const Act& act) {
  if (comm.size() == 1) return act();
  fail_together(comm, trouble_in(act));
}
// The root acts, likewise: a full disk is not to leave the others waiting.
template <class Act>
void act_on_root(const Communicator& comm, const Act& act) {
  fail_together(comm, comm.is_root() ? trouble_in(act) : "");
}

// Numbers of every rank for every rank, which travel while the ranks work on. Made in
// communicator_native.cpp.
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
