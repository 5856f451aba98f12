// A fuzzer without libFuzzer: every file of the given directories, then so many inputs made of them by
// chance.
//   replay_NAME COUNT DIRECTORY ...
#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <random>
#include <string>
#include <vector>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace {

using Bytes = std::vector<std::uint8_t>;

std::vector<Bytes> files_of(int count, char** directories) {
  std::vector<std::filesystem::path> paths;
  for (int k = 0; k < count; ++k)
    for (const auto& entry : std::filesystem::directory_iterator(directories[k]))
      paths.push_back(entry.path());
  std::sort(paths.begin(), paths.end());
  std::vector<Bytes> files;
  for (const auto& path : paths) {
    std::ifstream file(path, std::ios::binary);
    files.emplace_back(std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>());
  }
  return files;
}

class Mutator {
 public:
  explicit Mutator(const std::vector<Bytes>& files) : files_(files) {}

  Bytes next() {
    Bytes input = one();
    for (int change = 1 + below(4); change > 0 && !input.empty(); --change) mutate(input);
    return input;
  }

 private:
  int below(std::size_t n) { return static_cast<int>(dice_() % std::max<std::size_t>(1, n)); }
  const Bytes& one() { return files_[static_cast<std::size_t>(below(files_.size()))]; }

  void mutate(Bytes& input) {
    static const char* const words[] = {"1e308", "-1", "null",        "0",   "\"",
                                        "{",     "[",  "99999999999", "nan", ","};
    const auto at = input.begin() + below(input.size());
    const Bytes& other = one();
    switch (below(6)) {
      case 0:
        *at ^= static_cast<std::uint8_t>(1 << below(8));
        break;
      case 1:
        *at = static_cast<std::uint8_t>(below(256));
        break;
      case 2:
        input.erase(at, at + std::min<std::ptrdiff_t>(input.end() - at, 1 + below(64)));
        break;
      case 3: {
        const std::string word = words[below(std::size(words))];
        input.insert(at, word.begin(), word.end());
        break;
      }
      case 4: {
        const auto from = other.begin() + below(other.size());
        const Bytes part(from, from + std::min<std::ptrdiff_t>(other.end() - from, 1 + below(200)));
        input.insert(at, part.begin(), part.end());
        break;
      }
      default:
        if (below(4) == 0) input.erase(at, input.end());
    }
  }

  const std::vector<Bytes>& files_;
  std::mt19937 dice_{1};
};

}  // namespace

int main(int argc, char** argv) {
  if (argc < 3) return 2;
  const std::vector<Bytes> files = files_of(argc - 2, argv + 2);
  if (files.empty()) return 2;
  for (const Bytes& file : files) LLVMFuzzerTestOneInput(file.data(), file.size());
  Mutator mutator(files);
  const long count = std::atol(argv[1]);
  for (long k = 0; k < count; ++k) {
    const Bytes input = mutator.next();
    std::ofstream(std::string(argv[0]) + ".last", std::ios::binary)
        .write(reinterpret_cast<const char*>(input.data()), static_cast<std::streamsize>(input.size()));
    LLVMFuzzerTestOneInput(input.data(), input.size());
  }
  std::cout << files.size() << " files, " << count << " inputs made of them\n";
  return 0;
}
