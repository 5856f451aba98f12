#include "solver/output/vtp.h"

#include <cstring>
#include <sstream>

#include "base/json.h"
#include "solver/output/interleaved.h"

namespace icebow {
namespace {

#if defined(__BYTE_ORDER__) && __BYTE_ORDER__ != __ORDER_LITTLE_ENDIAN__
#error "the files say byte_order=LittleEndian and hold the machine's bytes"
#endif

template <class T>
constexpr const char* vtk_type();
template <>
constexpr const char* vtk_type<float>() {
  return "Float32";
}
template <>
constexpr const char* vtk_type<std::int32_t>() {
  return "Int32";
}
template <>
constexpr const char* vtk_type<std::uint8_t>() {
  return "UInt8";
}

class PolyDataFile {
 public:
  void open(const std::string& element) { xml_ << "<" << element << ">\n"; }
  void close(const std::string& element) { xml_ << "</" << element << ">\n"; }

  template <class T>
  void array(const std::string& name, int components, const std::vector<T>& values) {
    xml_ << "<DataArray type=\"" << vtk_type<T>() << "\" Name=\"" << name << "\" NumberOfComponents=\""
         << components << "\" format=\"appended\" offset=\"" << data_.size() << "\"/>\n";
    const std::uint64_t bytes = values.size() * sizeof(T);
    append(&bytes, sizeof bytes);
    append(values.data(), bytes);
  }

  void write(const std::string& path, std::size_t points, std::size_t vertices, std::size_t polygons) const {
    std::ostringstream head;
    head << "<?xml version=\"1.0\"?>\n"
         << "<VTKFile type=\"PolyData\" version=\"1.0\" byte_order=\"LittleEndian\" header_type=\"UInt64\">\n"
         << "<PolyData>\n<Piece NumberOfPoints=\"" << points << "\" NumberOfVerts=\"" << vertices
         << "\" NumberOfLines=\"0\" NumberOfStrips=\"0\" NumberOfPolys=\"" << polygons << "\">\n";
    write_text_file(path, head.str() + xml_.str() +
                              "</Piece>\n</PolyData>\n<AppendedData encoding=\"raw\">\n_" + data_ +
                              "\n</AppendedData>\n</VTKFile>\n");
  }

 private:
  void append(const void* from, std::size_t bytes) { data_.append(static_cast<const char*>(from), bytes); }

  std::ostringstream xml_;
  std::string data_;
};

std::string escaped(const std::string& text) {
  std::string result;
  for (char c : text) {
    if (c == '&')
      result += "&amp;";
    else if (c == '<')
      result += "&lt;";
    else if (c == '"')
      result += "&quot;";
    else
      result += c;
  }
  return result;
}

}  // namespace

void write_ice_vtp(const std::string& path, const IceCloud& ice) {
  const std::size_t n = ice.x.size();
  std::vector<std::int32_t> connectivity(n), offsets(n);
  for (std::size_t i = 0; i < n; ++i) {
    connectivity[i] = static_cast<std::int32_t>(i);
    offsets[i] = static_cast<std::int32_t>(i) + 1;
  }
  PolyDataFile file;
  file.open("PointData");
  file.array("displacement", 3, interleaved(ice.ux, ice.uy, ice.uz));
  if (!ice.vx.empty()) file.array("velocity", 3, interleaved(ice.vx, ice.vy, ice.vz));
  file.array("damage", 1, ice.damage);
  file.array("piece", 1, ice.piece);
  file.close("PointData");
  file.open("Points");
  file.array("Points", 3, interleaved(ice.x, ice.y, ice.z));
  file.close("Points");
  file.open("Verts");
  file.array("connectivity", 1, connectivity);
  file.array("offsets", 1, offsets);
  file.close("Verts");
  file.write(path, n, n, 0);
}

void write_ice_pvtp(const std::string& path, const std::vector<std::string>& pieces) {
  std::ostringstream xml;
  xml << "<?xml version=\"1.0\"?>\n"
      << "<VTKFile type=\"PPolyData\" version=\"1.0\" byte_order=\"LittleEndian\" header_type=\"UInt64\">\n"
      << "<PPolyData GhostLevel=\"0\">\n<PPointData>\n";
  const auto array = [&](const char* type, const char* name, int components) {
    xml << "<PDataArray type=\"" << type << "\" Name=\"" << name << "\" NumberOfComponents=\"" << components
        << "\"/>\n";
  };
  array("Float32", "displacement", 3);
  array("Float32", "velocity", 3);
  array("Float32", "damage", 1);
  array("Int32", "piece", 1);
  xml << "</PPointData>\n<PPoints>\n";
  array("Float32", "Points", 3);
  xml << "</PPoints>\n";
  for (const std::string& piece : pieces) xml << "<Piece Source=\"" << escaped(piece) << "\"/>\n";
  xml << "</PPolyData>\n</VTKFile>\n";
  write_text_file(path, xml.str());
}

void write_hull_vtp(const std::string& path, const QuadMesh& hull, double hull_x) {
  std::vector<float> points;
  points.reserve(3 * hull.points.size());
  for (const Vec3& p : hull.points)
    points.insert(points.end(),
                  {static_cast<float>(p.x() + hull_x), static_cast<float>(p.y()), static_cast<float>(p.z())});
  std::vector<std::int32_t> connectivity, offsets;
  std::vector<std::uint8_t> patch;
  for (std::size_t q = 0; q < hull.quads.size(); ++q) {
    const auto& corners = hull.quads[q];
    connectivity.insert(connectivity.end(), corners.begin(), corners.end() - (hull.is_triangle(q) ? 1 : 0));
    offsets.push_back(static_cast<std::int32_t>(connectivity.size()));
    patch.push_back(static_cast<std::uint8_t>(hull.patch[q]));
  }
  PolyDataFile file;
  file.open("CellData");
  file.array("patch", 1, patch);
  file.close("CellData");
  file.open("Points");
  file.array("Points", 3, points);
  file.close("Points");
  file.open("Polys");
  file.array("connectivity", 1, connectivity);
  file.array("offsets", 1, offsets);
  file.close("Polys");
  file.write(path, hull.points.size(), 0, hull.quads.size());
}

void write_pvd(const std::string& path, const std::vector<std::pair<double, std::string>>& steps) {
  std::ostringstream xml;
  xml.precision(17);
  xml << "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"1.0\" "
         "byte_order=\"LittleEndian\">\n"
      << "<Collection>\n";
  for (const auto& [time, file] : steps)
    xml << "<DataSet timestep=\"" << time << "\" group=\"\" part=\"0\" file=\"" << escaped(file) << "\"/>\n";
  xml << "</Collection>\n</VTKFile>\n";
  write_text_file(path, xml.str());
}

}  // namespace icebow
