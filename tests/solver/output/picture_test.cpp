#include "solver/output/picture.h"

#include <png.h>
#include <unistd.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <functional>
#include <limits>

#include "base/errors.h"
#include "geometry/hull_section.h"
#include "solver/output/particle_tiles.h"
#include "tests/support/shapes.h"

using namespace icebow;

namespace {

struct Rgb {
  int r, g, b;
  int brightness() const { return (r + g + b) / 3; }
};

struct Picture {
  int width = 0, height = 0;
  std::vector<png_byte> bytes;
  PictureFrame frame{};

  Rgb at(double x, double y) const {
    const int column = static_cast<int>((x - frame.x_min) / (frame.x_max - frame.x_min) * width);
    const int row = static_cast<int>((frame.y_max - y) / (frame.y_max - frame.y_min) * height);
    const png_byte* p = &bytes[3 * (static_cast<std::size_t>(row) * width + column)];
    return {p[0], p[1], p[2]};
  }
};

Picture read_png(const std::string& path, const PictureFrame& frame) {
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  REQUIRE(png_image_begin_read_from_file(&image, path.c_str()));
  image.format = PNG_FORMAT_RGB;
  Picture picture;
  picture.bytes.resize(PNG_IMAGE_SIZE(image));
  REQUIRE(png_image_finish_read(&image, nullptr, picture.bytes.data(), 0, nullptr));
  picture.width = static_cast<int>(image.width), picture.height = static_cast<int>(image.height);
  picture.frame = frame;
  return picture;
}

using Placement = std::function<Vec3(const Vec3&)>;

void add(IceCloud& ice, const Vec3& X, const Vec3& x, float damage, int piece) {
  const Vec3 u = x - X;
  ice.x.push_back(static_cast<float>(x.x()));
  ice.y.push_back(static_cast<float>(x.y()));
  ice.z.push_back(static_cast<float>(x.z()));
  ice.ux.push_back(static_cast<float>(u.x()));
  ice.uy.push_back(static_cast<float>(u.y()));
  ice.uz.push_back(static_cast<float>(u.z()));
  ice.damage.push_back(damage);
  ice.piece.push_back(piece);
}

// 0 <= x < 2, -0.5 < y < 0.5, two layers; what lies at y > 0.1 and 1 < x < 1.6 is floe 1 moved by
// `placement`.
IceCloud sheet(const Placement& placement) {
  IceCloud ice;
  ice.dx = 0.02;
  for (int k = 0; k < 2; ++k)
    for (int j = -25; j < 25; ++j)
      for (int i = 0; i < 100; ++i) {
        const Vec3 X((i + 0.5) * ice.dx, (j + 0.5) * ice.dx, (k - 0.5) * ice.dx);
        const bool floe = X.y() > 0.1 && X.x() > 1.0 && X.x() < 1.6;
        const bool cracked = std::abs(X.x() - 0.5) < 0.02;
        add(ice, X, floe ? placement(X) : X, cracked ? 0.45f : 0.0f, floe ? 1 : 0);
      }
  return ice;
}

Vec3 stay(const Vec3& X) {
  return X;
}

const PictureFrame frame{-0.5, 2.5, -0.75, 0.75, 600, 1.0, "", false, {}};
const QuadMesh hull = shapes::box({-1.0, -0.2, -0.3}, {0.0, 0.2, 0.2}, {2, 2, 2});

struct Folder {
  std::filesystem::path path =
      std::filesystem::temp_directory_path() / ("icebow_picture_test" + std::to_string(::getpid()));
  Folder() { std::filesystem::create_directories(path); }
  ~Folder() { std::filesystem::remove_all(path); }
  std::string file(const char* name) const { return (path / name).string(); }
};

Picture draw(const IceCloud& ice, double hull_x) {
  const Folder folder;
  write_top_view(folder.file("top.png"), ice, hull, hull_x, frame);
  CHECK(std::distance(std::filesystem::directory_iterator(folder.path), {}) ==
        1);  // nothing temporary is left
  return read_png(folder.file("top.png"), frame);
}

}  // namespace

TEST_CASE("Picture: sea, sheet, crack, floe and hull where they belong") {
  const Picture p = draw(sheet(stay), 0.3);
  CHECK(p.width == 600);
  CHECK(p.height == 300);
  const Rgb sea = p.at(2.3, 0.0);
  CHECK(sea.b > sea.r + 40);
  CHECK(sea.brightness() < 90);
  const Rgb standing = p.at(1.8, 0.0);
  CHECK(standing.brightness() > 225);
  CHECK(p.at(0.5, 0.4).brightness() < 110);
  const Rgb floe = p.at(1.3, 0.3);
  CHECK(floe.brightness() > 150);
  CHECK(floe.brightness() < standing.brightness() - 10);
  CHECK(p.at(1.3, -0.3).brightness() == standing.brightness());  // port is up
  const Rgb under_hull = p.at(0.1, 0.1);
  CHECK(under_hull.r > under_hull.b + 20);
  CHECK(under_hull.brightness() > 120);  // the ice shows through
  const Rgb hull_on_sea = p.at(-0.3, 0.1);
  CHECK(hull_on_sea.r > sea.r + 40);
  CHECK(hull_on_sea.brightness() < 100);
  CHECK(p.at(0.299, 0.0).brightness() < under_hull.brightness() - 40);  // the waterline's line
}

TEST_CASE("Picture: a crack has the colour of its kind, and the channel its edges") {
  const auto with_crack = [](CrackKind kind) {
    IceCloud ice = sheet(stay);
    std::vector<CrackedPlace> places;
    for (int j = -25; j < 25; ++j)
      for (int i : {24, 25}) places.push_back({(i + 0.5) * ice.dx, (j + 0.5) * ice.dx, kind});
    mark_cracks(ice, places);
    CHECK(std::count(ice.crack.begin(), ice.crack.end(), 1 + static_cast<int>(kind)) == 2 * 50 * 2);
    return ice;
  };
  const Rgb none = draw(sheet(stay), -5.0).at(0.5, 0.4);
  const Rgb radial = draw(with_crack(CrackKind::radial), -5.0).at(0.5, 0.4);
  const Rgb again = draw(with_crack(CrackKind::secondary), -5.0).at(0.5, 0.4);
  CHECK(std::abs(none.r - none.b) < 40);
  CHECK(radial.r > radial.g + 30);
  CHECK(again.g > again.r + 60);

  PictureFrame with_channel = frame;
  with_channel.channel = {{Vec2(0.1, 0.4), Vec2(0.9, 0.4)}};
  const Folder folder;
  write_top_view(folder.file("top.png"), sheet(stay), hull, -5.0, with_channel);
  const Picture p = read_png(folder.file("top.png"), with_channel);
  CHECK(p.at(0.7, 0.4).r > p.at(0.7, 0.4).b + 100);
  CHECK(p.at(0.7, 0.3).brightness() > 225);
}

TEST_CASE("Picture: a turned floe has no slits and leaves open water") {
  const Eigen::AngleAxisd turn(0.6, Vec3::UnitZ());
  const Vec3 centre(1.3, 0.3, 0.0), away(0.0, 0.25, 0.0);
  const Picture p =
      draw(sheet([&](const Vec3& X) -> Vec3 { return centre + away + turn * (X - centre); }), -5.0);
  for (double s = -0.25; s <= 0.25; s += 0.004) {
    const Vec3 along = centre + away + turn * Vec3(s, 0.02 * std::sin(40 * s), 0.0);
    if (along.y() < 0.74) CHECK(p.at(along.x(), along.y()).brightness() > 150);
  }
  CHECK(p.at(1.3, 0.2).brightness() < 90);
}

TEST_CASE("Picture: what is higher hides what is lower, and deep ice is blue") {
  const auto shifted = [](double z) { return [z](const Vec3& X) -> Vec3 { return X + Vec3(0.0, -0.5, z); }; };
  const Picture above = draw(sheet(shifted(0.1)), -5.0), below = draw(sheet(shifted(-0.1)), -5.0);
  CHECK(above.at(1.3, -0.2).brightness() < below.at(1.3, -0.2).brightness() - 10);
  const auto sunk = [](const Vec3& X) -> Vec3 { return X - Vec3(0.0, 0.0, 0.6); };
  const Rgb deep = draw(sheet(sunk), -5.0).at(1.3, 0.3), floating = draw(sheet(stay), -5.0).at(1.3, 0.3);
  CHECK(deep.brightness() < floating.brightness() - 50);
}

TEST_CASE("Picture: crushed ice is grey specks with water between them") {
  IceCloud ice = sheet(stay);
  for (std::size_t i = 0; i < ice.x.size(); ++i)
    if (ice.piece[i] == 1) ice.piece[i] = -1;
  const Picture p = draw(ice, -5.0);
  int dark = 0, grey = 0;
  for (double x = 1.1; x < 1.5; x += 0.005) {
    const Rgb c = p.at(x, 0.31);
    dark += c.brightness() < 130;
    grey += c.brightness() >= 130 && c.brightness() < 190;
  }
  CHECK(dark > 0);
  CHECK(grey > 20);
}

TEST_CASE("Picture: a title and a legend stand around it, and the bar is of full-scale metres") {
  // Dark points of the bar's line, two pixels above its foot.
  const auto bar = [](const Picture& p, int foot) {
    int dark = 0;
    for (int column = 0; column < p.width; ++column) {
      const png_byte* c =
          &p.bytes[3 * (static_cast<std::size_t>(p.height - 1 - foot - 8) * p.width + column)];
      dark += c[0] < 60 && c[1] < 60 && c[2] < 60;
    }
    return dark;
  };
  const Folder folder;
  PictureFrame told = frame;
  write_top_view(folder.file("plain.png"), {}, hull, -5.0, told);
  const Picture plain = read_png(folder.file("plain.png"), told);
  CHECK(bar(plain, 0) == 100);  // 3 m are 600 pixels, a fifth of them holds 0.5 m
  told.lambda = 25.0;
  told.title = "A bow: ice from above";
  write_top_view(folder.file("told.png"), {}, hull, -5.0, told);
  const Picture p = read_png(folder.file("told.png"), told);
  const int head = 16, foot = p.height - 300 - head;  // 16 dots of one pixel
  REQUIRE(foot > 13);
  CHECK(bar(p, foot) == 80);  // 75 m are 600 pixels, a fifth of them holds 10 m
  int ink = 0, swatches = 0;
  for (int row = 0; row < head; ++row)
    for (int column = 0; column < p.width; ++column)
      ink += p.bytes[3 * (static_cast<std::size_t>(row) * p.width + column)] < 60;
  for (int row = p.height - foot; row < p.height; ++row)
    for (int column = 0; column < p.width; ++column) {
      const png_byte* c = &p.bytes[3 * (static_cast<std::size_t>(row) * p.width + column)];
      swatches += c[0] == 176 && c[1] == 60 && c[2] == 48;  // the hull's colour
    }
  CHECK(ink > 100);
  CHECK(swatches == 49);  // 7 x 7 dots
}

TEST_CASE("Picture: below the top view the centre plane is seen from the side") {
  const Folder folder;
  PictureFrame both = frame;
  both.section = true;
  write_top_view(folder.file("both.png"), sheet(stay), hull, 0.3, both);
  const Picture p = read_png(folder.file("both.png"), both);
  // The box is from -0.3 to 0.2 with 0.04 around it: 0.58 m of 200 pixels each.
  REQUIRE(p.height == 300 + 116);
  const auto at = [&](double x, double z) {
    const int column = static_cast<int>((x + 0.5) * 200), row = 300 + static_cast<int>((0.24 - z) * 200);
    const png_byte* c = &p.bytes[3 * (static_cast<std::size_t>(row) * p.width + column)];
    return Rgb{c[0], c[1], c[2]};
  };
  CHECK(at(1.8, 0.0).brightness() > 225);         // ice: two layers about z = 0
  CHECK(at(1.8, 0.1).brightness() > 215);         // air
  CHECK(at(1.8, -0.2).brightness() < 90);         // sea
  CHECK(at(0.0, -0.2).r > at(1.8, -0.2).r + 40);  // hull below the sea's level
}

TEST_CASE("Picture: an empty cloud is open water, and a bad window is refused") {
  const Picture p = draw({}, -5.0);
  CHECK(p.at(1.0, 0.0).brightness() == p.at(2.3, 0.5).brightness());
  PictureFrame empty = frame;
  empty.x_max = empty.x_min;
  CHECK_THROWS_AS(write_top_view("never.png", {}, hull, 0.0, empty), std::invalid_argument);
}

TEST_CASE("Picture: a cloud with positions that are no numbers is drawn all the same") {
  IceCloud ice = sheet(stay);
  const float nan = std::numeric_limits<float>::quiet_NaN();
  ice.x[10] = ice.ux[10] = nan;
  ice.z[20] = std::numeric_limits<float>::infinity();
  ice.ux[30] = nan;
  ice.y[40] = 1e30f;
  const Picture p = draw(ice, -5.0);
  CHECK(p.at(1.8, 0.0).brightness() > 225);
  CHECK(p.at(2.3, 0.0).brightness() < 90);
}

TEST_CASE("Picture: a file that cannot be written is named") {
  const std::string nowhere = "/nonexistent_folder/top.png";
  CHECK_THROWS_AS(write_top_view(nowhere, sheet(stay), hull, 0.0, frame), RuntimeError);
  CHECK_THROWS_WITH(write_top_view(nowhere, sheet(stay), hull, 0.0, frame), Catch::Contains(nowhere));
}

TEST_CASE("Tiles follow the ice") {
  const Eigen::AngleAxisd turn(0.7, Vec3(0.2, 0.1, 1.0).normalized());
  const IceCloud ice = sheet([&](const Vec3& X) -> Vec3 { return turn * X; });
  const std::vector<Tile> tiles = particle_tiles(ice);
  REQUIRE(tiles.size() == ice.x.size());
  double worst = 0.0;
  for (std::size_t i = 0; i < tiles.size(); ++i) {
    const Eigen::Matrix3d R = ice.piece[i] == 1 ? turn.toRotationMatrix() : Eigen::Matrix3d::Identity();
    worst = std::max({worst, (tiles[i].x.cast<double>() - ice.dx * R.col(0)).norm(),
                      (tiles[i].y.cast<double>() - ice.dx * R.col(1)).norm(),
                      (tiles[i].z.cast<double>() - ice.dx * R.col(2)).norm()});
  }
  CHECK(worst < 1e-4 * ice.dx);  // found 7e-6: single precision of positions
}

TEST_CASE("Section of a hull: closed loops of the right length") {
  const auto length = [](const std::vector<Segment>& loop) {
    double sum = 0.0;
    for (const auto& [a, b] : loop) sum += (b - a).norm();
    return sum;
  };
  const QuadMesh cube = shapes::box({0, 0, -1}, {2, 1, 1}, {3, 3, 4});
  CHECK(length(hull_section(cube, 0.1)) == Approx(6.0));
  CHECK(length(hull_section(cube, 0.0)) == Approx(6.0));  // through a row of points
  CHECK(length(hull_section(shapes::triangulated(cube), 0.1)) == Approx(6.0));
  CHECK(hull_section(cube, 1.5).empty());
}
