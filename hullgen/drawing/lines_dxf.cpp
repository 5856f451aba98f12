#include "hullgen/drawing/lines_dxf.h"

#include "base/text.h"
#include "geometry/mesh_slice.h"

namespace icebow {
namespace {

void add_line(std::string& out, const Polyline& line, const char* layer) {
  out += text("0\nPOLYLINE\n8\n%s\n66\n1\n70\n8\n10\n0.0\n20\n0.0\n30\n0.0\n", layer);  // 8: in space
  for (const Vec3& p : line)
    out += text("0\nVERTEX\n8\n%s\n10\n%.6f\n20\n%.6f\n30\n%.6f\n70\n32\n", layer, p.x() + 0.0, p.y() + 0.0,
                p.z() + 0.0);
  out += text("0\nSEQEND\n8\n%s\n", layer);
}

void add_cut(std::string& out, const QuadMesh& mesh, int axis, double at, const char* layer) {
  for (const Polyline& line : slice(mesh, axis, at)) add_line(out, line, layer);
}

std::string layers() {
  const std::pair<const char*, int> all[] = {
      {"PROFILE", 7}, {"WATERLINES", 5}, {"BUTTOCKS", 3}, {"STATIONS", 1}, {"DWL", 4}};
  std::string out = "0\nTABLE\n2\nLAYER\n70\n5\n";
  for (const auto& [name, colour] : all)
    out += text("0\nLAYER\n2\n%s\n70\n0\n62\n%d\n6\nCONTINUOUS\n", name, colour);
  return out + "0\nENDTAB\n";
}

}  // namespace

std::string lines_dxf(const QuadMesh& mesh) {
  const Box box = bounding_box(mesh);
  const Vec3 size = box.upper - box.lower;
  std::string out = text(
      "0\nSECTION\n2\nHEADER\n9\n$ACADVER\n1\nAC1009\n9\n$EXTMIN\n10\n%.6f\n20\n%.6f\n30\n%.6f\n9\n$"
      "EXTMAX\n10\n%.6f\n20\n%.6f\n30\n"
      "%.6f\n0\nENDSEC\n0\nSECTION\n2\nTABLES\n",
      box.lower.x(), box.lower.y(), box.lower.z(), box.upper.x(), box.upper.y(), box.upper.z());
  out += layers() + "0\nENDSEC\n0\nSECTION\n2\nENTITIES\n";
  add_cut(out, mesh, 1, 0.0, "PROFILE");
  add_cut(out, mesh, 2, 0.0, "DWL");
  for (int k = 1; k <= 12; ++k) add_cut(out, mesh, 2, box.lower.z() + k / 13.0 * size.z(), "WATERLINES");
  for (int k = 1; k <= 4; ++k)
    for (const double side : {1.0, -1.0}) add_cut(out, mesh, 1, side * k / 5.0 * box.upper.y(), "BUTTOCKS");
  for (int k = 0; k < 21; ++k) add_cut(out, mesh, 0, box.lower.x() + (k + 0.5) / 21.0 * size.x(), "STATIONS");
  return out + "0\nENDSEC\n0\nEOF\n";
}

}  // namespace icebow
