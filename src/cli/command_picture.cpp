// `icebow picture`.
#include <algorithm>
#include <filesystem>
#include <iostream>

#include "base/errors.h"
#include "cli/commands.h"
#include "cli/number_option.h"
#include "solver/output/animation.h"

namespace icebow {
namespace {

namespace fs = std::filesystem;

// ice_000.png and so on, in order.
std::vector<std::string> pictures_in(const std::string& directory) {
  std::vector<std::string> list;
  std::error_code error;
  for (const fs::directory_entry& entry : fs::directory_iterator(directory, error)) {
    const std::string name = entry.path().filename().string();
    if (name.rfind("ice_", 0) == 0 && entry.path().extension() == ".png")
      list.push_back(entry.path().string());
  }
  if (error) throw InputError(directory + ": " + error.message());
  std::sort(list.begin(), list.end(), [](const std::string& a, const std::string& b) {
    return a.size() != b.size() ? a.size() < b.size() : a < b;
  });
  return list;
}

}  // namespace

int run_picture(const Communicator&, const Arguments& arguments) {
  const std::string directory = arguments.positional;
  const double seconds = number_option(arguments, "--seconds", 0.0, 0.01, 60.0, "seconds a picture");
  const std::vector<std::string> pictures = pictures_in(directory);
  if (pictures.size() < 2)
    throw InputError(
        directory + " holds " + std::to_string(pictures.size()) +
        " of a run's pictures (ice_000.png ...), an animation wants two or more; name the directory "
        "of a simulated design, and set output.pictures in its study");
  const std::string out =
      arguments.has("--out") ? arguments.value("--out") : (fs::path(directory) / animation_name).string();
  animate_pictures(out, pictures, seconds);
  std::cout << out << "\n";
  return exit_code::ok;
}

}  // namespace icebow
