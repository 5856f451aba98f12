// `icebow new`.
#include <charconv>
#include <filesystem>
#include <iostream>

#include "base/errors.h"
#include "cli/commands.h"
#include "cli/number_option.h"
#include "hullgen/bow/family.h"
#include "study/plan/first_study.h"
#include "study/spec/spec_hints.h"

namespace icebow {
namespace {

struct Question {
  const char *option, *words, *unit;
  double lower, upper;
  double FirstStudy::*answer;
};

const Question questions[] = {
    {"--length", "Length of the ship between perpendiculars", "m", 20.0, 500.0, &FirstStudy::length},
    {"--beam", "Beam of the ship", "m", 4.0, 80.0, &FirstStudy::beam},
    {"--draft", "Draught of the ship", "m", 1.0, 30.0, &FirstStudy::draft},
    {"--thickness", "Thickness of the level ice", "m", 0.1, 3.0, &FirstStudy::thickness},
    {"--speed", "Speed of the ship in it", "kn", 0.5, 15.0, &FirstStudy::speed}};

// Asks until the answer is a number in its range; no answer takes the value in brackets, and says so.
double asked(const Question& q, double usual) {
  for (std::string line;;) {
    std::cerr << q.words << ", " << q.unit << " [" << brief(usual) << "]: " << std::flush;
    const bool given = static_cast<bool>(std::getline(std::cin, line));
    if (!given || line.empty()) {
      std::cerr << (given ? "" : brief(usual) + " (no answer)\n");
      return usual;
    }
    double value = 0.0;
    const char* const end = line.data() + line.size();
    const auto read = std::from_chars(line.data(), end, value);
    if (read.ec == std::errc() && read.ptr == end && value >= q.lower && value <= q.upper) return value;
    std::cerr << "give a number from " << brief(q.lower) << " to " << brief(q.upper) << " " << q.unit << "\n";
  }
}

BowFamily family_option(const Arguments& arguments) {
  const std::string key = arguments.value("--family");
  const std::vector<std::string> known = family_keys();
  if (!key.empty() && std::find(known.begin(), known.end(), key) == known.end())
    throw InputError("--family " + key + ": there are " + listed(known) + did_you_mean(key, known));
  return key.empty() ? BowFamily::straight_parallel_buttocks : family_of_key(key);
}

}  // namespace

int run_new(const Communicator&, const Arguments& arguments) {
  const std::string file = arguments.positional;
  if (std::filesystem::exists(file)) throw InputError(file + " is there already; name another file");
  FirstStudy ship;
  ship.family = family_option(arguments);
  ship.samples = static_cast<int>(number_option(arguments, "--samples", ship.samples, 1.0, 10000.0, "bows"));
  for (const Question& q : questions) {
    double& answer = ship.*q.answer;
    answer = arguments.has(q.option) ? number_option(arguments, q.option, answer, q.lower, q.upper, q.unit)
                                     : asked(q, answer);
  }
  write_text_file(file, first_study(ship).dump(2) + "\n");
  std::cout << "wrote " << file << ": " << ship.samples << " bows in " << brief(ship.thickness)
            << " m of ice at " << brief(ship.speed) << " kn\nnext: icebow run " << file << " --out out\n";
  return exit_code::ok;
}

}  // namespace icebow
