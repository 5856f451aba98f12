#include "base/errors.h"

namespace icebow {
namespace {

std::string joined(const std::string& file, const std::vector<Mistake>& mistakes) {
  std::string text =
      file + ": " + std::to_string(mistakes.size()) + (mistakes.size() == 1 ? " mistake" : " mistakes");
  for (const Mistake& m : mistakes) {
    text += "\n  " + (m.pointer.empty() ? std::string("(whole file)") : m.pointer) + ": " + m.message;
  }
  return text;
}

}  // namespace

InputError::InputError(std::string file, std::vector<Mistake> mistakes)
    : std::runtime_error(joined(file, mistakes)), file_(std::move(file)), mistakes_(std::move(mistakes)) {}

InputError::InputError(const std::string& message) : std::runtime_error(message) {}

}  // namespace icebow
