// Lines as DXF, read back by the format's own rules: pairs of a group code and a value.
#include "hullgen/drawing/lines_dxf.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <map>
#include <sstream>

#include "hullgen/bow/bow_mesh.h"
#include "hullgen/bow/family.h"

using namespace icebow;

namespace {

struct Drawing {
  std::map<std::string, std::vector<std::vector<Vec3>>> lines;  // by layer
  bool ended = false;
};

Drawing read(const std::string& dxf) {
  Drawing drawing;
  std::istringstream in(dxf);
  std::string code, value, entity, layer;
  while (std::getline(in, code) && std::getline(in, value)) {
    REQUIRE_FALSE(drawing.ended);
    const int group = std::stoi(code);
    if (group == 0) entity = value;
    if (group == 0 && value == "EOF") drawing.ended = true;
    if (group == 8) layer = value;
    if (group == 8 && entity == "POLYLINE") drawing.lines[layer].emplace_back();
    if (entity != "VERTEX") continue;
    auto& line = drawing.lines.at(layer).back();
    if (group == 10) line.emplace_back(std::stod(value), 0.0, 0.0);
    if (group == 20) line.back().y() = std::stod(value);
    if (group == 30) line.back().z() = std::stod(value);
  }
  return drawing;
}

}  // namespace

TEST_CASE("lines as DXF: each layer's lines lie in their planes and reach the hull's ends") {
  BowParameters bow = preset_bow(BowFamily::concave);
  bow.panel = bow.B / 20.0;
  const Drawing drawing = read(lines_dxf(bow_mesh(bow)));
  REQUIRE(drawing.ended);
  const auto count = [&](const char* layer) { return drawing.lines.at(layer).size(); };
  CHECK(count("PROFILE") == 1);
  CHECK(count("DWL") == 1);
  CHECK(count("WATERLINES") == 12);
  CHECK(count("BUTTOCKS") == 8);
  CHECK(count("STATIONS") == 21);
  constexpr double written = 1e-6;  // m: the decimals of the file
  double fore = -1e9, aft = 1e9, widest = 0.0, lowest = 1e9, highest = -1e9;
  for (const Vec3& p : drawing.lines.at("DWL").front()) {
    CHECK(std::abs(p.z()) < written);
    fore = std::max(fore, p.x()), aft = std::min(aft, p.x()), widest = std::max(widest, p.y());
  }
  CHECK(fore == Approx(0.0).margin(written));
  CHECK(aft == Approx(-bow.L).margin(written));
  CHECK(widest == Approx(bow.B / 2.0).margin(written));
  for (const Vec3& p : drawing.lines.at("PROFILE").front()) {
    CHECK(std::abs(p.y()) < written);
    lowest = std::min(lowest, p.z()), highest = std::max(highest, p.z());
  }
  CHECK(lowest == Approx(-bow.T).margin(written));
  CHECK(highest == Approx(bow.D - bow.T).margin(written));
  for (const auto& station : drawing.lines.at("STATIONS"))
    for (const Vec3& p : station) CHECK(p.x() == Approx(station.front().x()).margin(written));
}
