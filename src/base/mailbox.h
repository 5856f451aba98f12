// Messages between two ranks of a group, while the others do something else. Made in communicator_native.cpp.
#pragma once

#include <optional>
#include <string>

#include "base/communicator.h"

namespace icebow {

struct Mail {
  int from = 0;  // rank
  std::string text;
};

// On a communicator with MPI. Messages from one rank to another arrive in the order they were sent.
class Mailbox {
 public:
  explicit Mailbox(const Communicator& comm) : comm_(comm) {}

  // Returns when the text may be forgotten: at once for up to some 4 kB, else when the other takes it.
  void send(int to, const std::string& text) const;
  // The next one that has come, from whomever; nothing where none has. Does not wait for one.
  std::optional<Mail> take() const;

 private:
  Communicator comm_;
};

}  // namespace icebow
