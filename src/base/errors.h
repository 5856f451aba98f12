// What can go wrong with a user's input. An impossible bow or a failed simulation is not here: those are
// statuses that travel with a design (see study/evaluate/evaluation.h).
#pragma once

#include <stdexcept>
#include <string>
#include <vector>

namespace icebow {

// One mistake in a study file: where (JSON pointer), what is wrong with the value, and what to change.
struct Mistake {
  std::string pointer;  // e.g. "/bow/stem_deg"
  std::string message;  // e.g. "is 95, allowed 5 to 85 deg"
};

// The whole file was read before this was thrown: every mistake is in it, and what() has the first fifty.
// Exit code 2.
class InputError : public std::runtime_error {
 public:
  InputError(std::string file, std::vector<Mistake> mistakes);
  explicit InputError(const std::string& message);

  const std::string& file() const { return file_; }
  const std::vector<Mistake>& mistakes() const { return mistakes_; }

 private:
  std::string file_;
  std::vector<Mistake> mistakes_;
};

// The machine let us down (file cannot be written, store locked, child process lost). Exit code 1.
class RuntimeError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace icebow
