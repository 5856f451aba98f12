#include "solver/output/animation.h"

#include <catch2/catch.hpp>
#include <fstream>
#include <iterator>

#include "base/errors.h"
#include "base/text_file.h"
#include "solver/output/palette.h"
#include "solver/output/png_file.h"
#include "tests/support/scratch.h"

using namespace icebow;

namespace {

// Sea with a square of 3 x 2 pixels at (left, 4).
Raster square_at(int left) {
  Raster picture{20, 10, {}};
  for (int row = 0; row < 10; ++row)
    for (int column = 0; column < 20; ++column) {
      const bool in = column >= left && column < left + 3 && row >= 4 && row < 6;
      for (const int value : {in ? 240 : 24, in ? 200 : 64, in ? 160 : 96})
        picture.rgb.push_back(static_cast<std::uint8_t>(value));
    }
  return picture;
}

struct Chunk {
  std::string type, data;
  unsigned at(std::size_t from, std::size_t bytes) const {
    unsigned value = 0;
    for (std::size_t k = 0; k < bytes; ++k) value = value << 8 | static_cast<unsigned char>(data[from + k]);
    return value;
  }
};

std::vector<Chunk> chunks_of(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(file), {}};
  std::vector<Chunk> list;
  for (std::size_t at = 8; at + 12 <= bytes.size();) {
    const unsigned size = Chunk{"", bytes.substr(at, 4)}.at(0, 4);
    list.push_back({bytes.substr(at + 4, 4), bytes.substr(at + 8, size)});
    at += size + 12;
  }
  return list;
}

std::vector<Chunk> of_type(const std::vector<Chunk>& all, const std::string& type) {
  std::vector<Chunk> list;
  for (const Chunk& chunk : all)
    if (chunk.type == type) list.push_back(chunk);
  return list;
}

}  // namespace

TEST_CASE("Animation: a still reader sees the first picture, each further frame is what changed") {
  const Scratch folder("animation");
  std::vector<std::string> files;
  for (const int left : {2, 5, 5, 11}) {
    files.push_back(folder.path() + "/ice_" + std::to_string(files.size()) + ".png");
    write_png(files.back(), square_at(left));
  }
  const std::string path = folder.path() + "/breaking.png";
  animate_pictures(path, files, 0.25);

  const Raster still = read_png(path);
  CHECK(still.width == 20);
  CHECK(still.rgb == square_at(2).rgb);

  const std::vector<Chunk> all = chunks_of(path);
  CHECK(all.back().type == "IEND");
  REQUIRE(of_type(all, "acTL").size() == 1);
  CHECK(of_type(all, "acTL")[0].at(0, 4) == 4);
  const std::vector<Chunk> frames = of_type(all, "fcTL");
  REQUIRE(frames.size() == 4);
  REQUIRE(of_type(all, "fdAT").size() == 3);
  const unsigned expected[4][4] = {{20, 10, 0, 0}, {6, 2, 2, 4}, {1, 1, 0, 0}, {9, 2, 5, 4}};  // w, h, x, y
  for (std::size_t k = 0; k < 4; ++k) {
    for (std::size_t n = 0; n < 4; ++n) CHECK(frames[k].at(4 + 4 * n, 4) == expected[k][n]);
    CHECK(frames[k].at(20, 2) == (k < 3 ? 250u : 2250u));  // thousandths of a second
    CHECK(frames[k].at(22, 2) == 1000u);
  }
  // One count runs over frames and their data: 0, 1 2, 3 4, 5 6.
  std::vector<unsigned> sequence;
  for (const Chunk& chunk : all)
    if (chunk.type == "fcTL" || chunk.type == "fdAT") sequence.push_back(chunk.at(0, 4));
  CHECK(sequence == std::vector<unsigned>{0, 1, 2, 3, 4, 5, 6});
}

TEST_CASE("Animation: pictures of another size, and files that are none, are named") {
  const Scratch folder("animation_errors");
  const std::string good = folder.path() + "/a.png", other = folder.path() + "/b.png",
                    text = folder.path() + "/c.png";
  write_png(good, square_at(2));
  write_png(other, {1, 1, {0, 0, 0}});
  std::ofstream(text) << "no picture";
  CHECK_THROWS_WITH(animate_pictures(folder.path() + "/x.png", {good, other}),
                    Catch::Contains("b.png: 1 x 1"));
  CHECK_THROWS_WITH(animate_pictures(folder.path() + "/x.png", {good, text}), Catch::Contains("c.png"));
  CHECK_THROWS_AS(write_animated_png("x.png", {}, 1.0), std::invalid_argument);
}

TEST_CASE("Palette: few colours stay, many become the nearest of the most frequent 256") {
  Raster many{64, 32, {}};
  for (int k = 0; k < 64 * 32; ++k)
    for (const int value : {8 * (k % 32), 8 * (k / 64), 0})
      many.rgb.push_back(static_cast<std::uint8_t>(value));
  const Palette palette({many});
  CHECK(palette.size() == 256);
  const Indexed indexed = palette.indexed(many);
  double worst = 0.0;
  for (std::size_t i = 0; i < indexed.pixels.size(); ++i)
    for (std::size_t c = 0; c < 3; ++c)
      worst = std::max(
          worst, std::abs(double(many.rgb[3 * i + c]) - double(palette.rgb()[3u * indexed.pixels[i] + c])));
  CHECK(worst > 0.0);
  CHECK(Palette({square_at(3)}).size() == 2);
}

TEST_CASE("Animation: a header that tells of a vast picture is refused before memory is taken for it") {
  const Scratch folder("animation");
  const std::string path = folder.path() + "/vast.png";
  write_png(path, square_at(2));
  std::string file = read_text_file(path);
  for (const std::size_t at : {16, 20}) file.replace(at, 4, std::string("\0\0\xea\x60", 4));  // 60000 x 60000
  std::uint32_t sum = 0xffffffffu;  // CRC-32 of the header chunk
  for (std::size_t k = 12; k < 29; ++k) {
    sum ^= static_cast<unsigned char>(file[k]);
    for (int bit = 0; bit < 8; ++bit) sum = (sum >> 1) ^ (sum & 1 ? 0xedb88320u : 0);
  }
  for (int k = 0; k < 4; ++k) file[29 + k] = static_cast<char>(~sum >> (24 - 8 * k));
  write_text_file(path, file);
  CHECK_THROWS_WITH(read_png(path), Catch::Contains("60000 x 60000"));
}
