#include "hullgen/mesh/mesh_formats.h"

#include <Eigen/Geometry>
#include <charconv>
#include <cstring>

#include "base/text.h"
#include "geometry/triangles.h"

namespace icebow {
namespace {

constexpr const char* frame =
    "lengths in metres; origin at the stem on the design waterline, x forward, y to port, z up";
constexpr const char* patch_legend = "patch: 0 bow, 1 side, 2 bottom, 3 transom, 4 deck, 5 reamer, 6 other";
constexpr const char* stl_frame =
    "icebow hull; metres; x forward, y to port, z up; origin: stem at waterline";
static_assert(std::char_traits<char>::length(stl_frame) <= 80, "an STL header has 80 bytes");

template <class Number>
void append(std::string& out, Number value) {
  char digits[32];
  out.append(digits, std::to_chars(digits, digits + sizeof digits, value).ptr);
}

void append_point(std::string& out, const Vec3& p) {
  for (int k = 0; k < 3; ++k) {
    if (k > 0) out += ' ';
    append(out, p[k] + 0.0);  // -0 becomes 0
  }
}

int corner_count(const QuadMesh& mesh, std::size_t quad) {
  return mesh.is_triangle(quad) ? 3 : 4;
}

void append_corners(std::string& out, const QuadMesh& mesh, std::size_t quad, int first) {
  for (int k = 0; k < corner_count(mesh, quad); ++k) {
    out += ' ';
    append(out, mesh.quads[quad][k] + first);
  }
}

template <class T>
void append_bytes(std::string& out, T value) {
  char bytes[sizeof value];
  std::memcpy(bytes, &value, sizeof value);  // little endian, as STL wants and all our machines are
  out.append(bytes, sizeof value);
}

void append_floats(std::string& out, const Vec3& v) {
  for (int k = 0; k < 3; ++k) append_bytes(out, static_cast<float>(v[k]));
}

}  // namespace

const char* patch_name(Patch patch) {
  static constexpr const char* names[] = {"bow", "side", "bottom", "transom", "deck", "reamer", "other"};
  return names[static_cast<int>(patch)];
}

std::string obj_text(const QuadMesh& mesh) {
  std::string out =
      text("# icebow hull: %zu points, %zu panels\n# %s\n", mesh.points.size(), mesh.quads.size(), frame);
  for (const Vec3& p : mesh.points) {
    out += "v ";
    append_point(out, p);
    out += '\n';
  }
  for (std::size_t q = 0; q < mesh.quads.size(); ++q) {
    if (q == 0 || mesh.patch[q] != mesh.patch[q - 1]) out += text("g %s\n", patch_name(mesh.patch[q]));
    out += 'f';
    append_corners(out, mesh, q, 1);
    out += '\n';
  }
  return out;
}

std::string ply_text(const QuadMesh& mesh) {
  std::string out = text(
      "ply\nformat ascii 1.0\ncomment icebow hull; %s\ncomment %s\nelement vertex %zu\nproperty double x\n"
      "property double y\nproperty double z\nelement face %zu\nproperty list uchar int vertex_indices\n"
      "property uchar patch\nend_header\n",
      frame, patch_legend, mesh.points.size(), mesh.quads.size());
  for (const Vec3& p : mesh.points) {
    append_point(out, p);
    out += '\n';
  }
  for (std::size_t q = 0; q < mesh.quads.size(); ++q) {
    append(out, corner_count(mesh, q));
    append_corners(out, mesh, q, 0);
    out += text(" %d\n", static_cast<int>(mesh.patch[q]));
  }
  return out;
}

std::string stl_bytes(const QuadMesh& mesh) {
  const auto facets = triangles(mesh);
  std::string out = stl_frame;
  out.resize(80, ' ');
  append_bytes(out, static_cast<std::uint32_t>(facets.size()));
  for (const auto& f : facets) {
    const Vec3 &a = mesh.points[f[0]], &b = mesh.points[f[1]], &c = mesh.points[f[2]];
    append_floats(out, (b - a).cross(c - a).normalized());
    for (const Vec3* corner : {&a, &b, &c}) append_floats(out, *corner);
    append_bytes(out, std::uint16_t{0});
  }
  return out;
}

std::string vtp_text(const QuadMesh& mesh) {
  const std::size_t n = mesh.quads.size();
  std::string out = text(
      "<?xml version=\"1.0\"?>\n<!-- icebow hull; %s; %s -->\n"
      "<VTKFile type=\"PolyData\" version=\"1.0\" byte_order=\"LittleEndian\">\n<PolyData>\n"
      "<Piece NumberOfPoints=\"%zu\" NumberOfVerts=\"0\" NumberOfLines=\"0\" NumberOfStrips=\"0\" "
      "NumberOfPolys=\"%zu\">\n<Points>\n"
      "<DataArray type=\"Float64\" NumberOfComponents=\"3\" format=\"ascii\">\n",
      frame, patch_legend, mesh.points.size(), n);
  for (const Vec3& p : mesh.points) {
    append_point(out, p);
    out += '\n';
  }
  out +=
      "</DataArray>\n</Points>\n<Polys>\n<DataArray type=\"Int64\" Name=\"connectivity\" format=\"ascii\">\n";
  for (std::size_t q = 0; q < n; ++q) {
    append_corners(out, mesh, q, 0);
    out += '\n';
  }
  out += "</DataArray>\n<DataArray type=\"Int64\" Name=\"offsets\" format=\"ascii\">\n";
  for (std::size_t q = 0, end = 0; q < n; ++q) out += text("%zu\n", end += corner_count(mesh, q));
  out +=
      "</DataArray>\n</Polys>\n<CellData Scalars=\"patch\">\n<DataArray type=\"UInt8\" Name=\"patch\" "
      "format=\"ascii\">\n";
  for (Patch patch : mesh.patch) out += text("%d\n", static_cast<int>(patch));
  return out + "</DataArray>\n</CellData>\n</Piece>\n</PolyData>\n</VTKFile>\n";
}

}  // namespace icebow
