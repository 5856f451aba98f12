#include "base/errors.h"

#include <algorithm>

#include "base/printable.h"

namespace icebow {
namespace {

constexpr std::size_t most_listed = 50, longest_pointer = 160, longest_message = 1200;

std::string joined(const std::string& file, const std::vector<Mistake>& mistakes) {
  std::string text =
      file + ": " + std::to_string(mistakes.size()) + (mistakes.size() == 1 ? " mistake" : " mistakes");
  const std::size_t listed = std::min(mistakes.size(), most_listed);
  for (std::size_t k = 0; k < listed; ++k) {
    const Mistake& m = mistakes[k];
    text += "\n  " +
            (m.pointer.empty() ? std::string("(whole file)") : shortened(m.pointer, longest_pointer)) + ": " +
            shortened(m.message, longest_message);
  }
  if (listed < mistakes.size())
    text += "\n  and " + std::to_string(mistakes.size() - listed) + " more; mend these first";
  return text;
}

}  // namespace

InputError::InputError(std::string file, std::vector<Mistake> mistakes)
    : std::runtime_error(joined(file, mistakes)), file_(std::move(file)), mistakes_(std::move(mistakes)) {}

InputError::InputError(const std::string& message) : std::runtime_error(message) {}

}  // namespace icebow
