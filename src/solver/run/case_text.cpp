#include "solver/run/case_text.h"

#include <cstring>
#include <map>
#include <sstream>

#include "base/text.h"
#include "solver/model/describe_scenario.h"
#include "solver/model/described_text.h"

namespace icebow {
namespace {

// FNV-1a, 64 bits.
class Checksum {
 public:
  template <class T>
  void add(const T& value) {
    unsigned char bytes[sizeof value];
    std::memcpy(bytes, &value, sizeof value);
    for (unsigned char byte : bytes) sum_ = (sum_ ^ byte) * 1099511628211u;
  }
  std::uint64_t value() const { return sum_; }

 private:
  std::uint64_t sum_ = 14695981039346656037u;
};

std::string hull_checksum(const QuadMesh& hull) {
  Checksum sum;
  for (const Vec3& p : hull.points) {
    for (int c = 0; c < 3; ++c) sum.add(p[c]);
  }
  for (const auto& quad : hull.quads) {
    for (const auto corner : quad) sum.add(corner);
  }
  return text("%016llx", static_cast<unsigned long long>(sum.value()));
}

// Numbers to their last bit.
struct Spelling {
  static constexpr const char* equals = " = ";
  static constexpr bool with_following = true;
  static std::string spelled(double value) { return text("%.17g", value); }
  static std::string spelled(int value) { return std::to_string(value); }
  static std::string spelled(bool value) { return value ? "1" : "0"; }
  static std::string spelled(const std::string& value) { return value; }
};

// Value by name.
std::map<std::string, std::string> values_of(const std::string& text) {
  std::map<std::string, std::string> values;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    const std::size_t equals = line.find(Spelling::equals);
    if (equals == std::string::npos) {
      values[line] = "";
    } else {
      values[line.substr(0, equals)] = line.substr(equals + std::strlen(Spelling::equals));
    }
  }
  return values;
}

}  // namespace

std::string case_text(const QuadMesh& hull, const Scenario& scenario, const RunOptions& options) {
  DescribedText<Spelling> words;
  Scenario shared = scenario;
  if (scenario.sheet.window_ahead > 0.0) shared.advance = 0.0;
  describe(words, shared);
  describe_output(words, options.seed, options.snapshots, options.pictures, options.snapshot_format);
  words.field("hull", hull_checksum(hull));
  return words.str();
}

std::string case_difference(const std::string& there, const std::string& here) {
  const auto a = values_of(there), b = values_of(here);
  for (const auto& [name, value] : b) {
    const auto other = a.find(name);
    if (other == a.end()) return "nothing there, " + name + Spelling::equals + value + " here";
    if (other->second != value) return name + Spelling::equals + other->second + " there, " + value + " here";
  }
  for (const auto& [name, value] : a) {
    if (b.find(name) == b.end()) return name + Spelling::equals + value + " there, nothing here";
  }
  return "";
}

}  // namespace icebow
