#include "solver/output/vtp.h"

#include <cstring>
#include <numeric>
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

// The rest of a file whose cells are these quads of the hull, with the corners that they use.
void write_quads(PolyDataFile& file, const std::string& path, const QuadMesh& hull,
                 const std::vector<std::int32_t>& quads) {
  std::vector<std::int32_t> number(hull.points.size(), -1), connectivity, offsets;
  std::vector<float> points;
  const auto number_of = [&](std::size_t point) {
    if (number[point] < 0) {
      number[point] = static_cast<std::int32_t>(points.size() / 3);
      for (int c = 0; c < 3; ++c) points.push_back(static_cast<float>(hull.points[point][c]));
    }
    return number[point];
  };
  if (quads.size() == hull.quads.size())  // the whole hull keeps its points' numbers
    for (std::size_t point = 0; point < hull.points.size(); ++point) number_of(point);
  for (const std::int32_t q : quads) {
    for (int corner = 0; corner < (hull.is_triangle(q) ? 3 : 4); ++corner)
      connectivity.push_back(number_of(hull.quads[q][corner]));
    offsets.push_back(static_cast<std::int32_t>(connectivity.size()));
  }
  file.open("Points");
  file.array("Points", 3, points);
  file.close("Points");
  file.open("Polys");
  file.array("connectivity", 1, connectivity);
  file.array("offsets", 1, offsets);
  file.close("Polys");
  file.write(path, points.size() / 3, 0, quads.size());
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
  file.array("displacement_m", 3, interleaved(ice.ux, ice.uy, ice.uz));
  if (!ice.vx.empty()) file.array("velocity_m_per_s", 3, interleaved(ice.vx, ice.vy, ice.vz));
  file.array("damage", 1, ice.damage);
  file.array("piece", 1, ice.piece);
  if (!ice.crack.empty()) file.array("crack", 1, ice.crack);
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

void write_ice_pvtp(const std::string& path, const std::vector<std::string>& pieces, bool cracks) {
  std::ostringstream xml;
  xml << "<?xml version=\"1.0\"?>\n"
      << "<VTKFile type=\"PPolyData\" version=\"1.0\" byte_order=\"LittleEndian\" header_type=\"UInt64\">\n"
      << "<PPolyData GhostLevel=\"0\">\n<PPointData>\n";
  const auto array = [&](const char* type, const char* name, int components) {
    xml << "<PDataArray type=\"" << type << "\" Name=\"" << name << "\" NumberOfComponents=\"" << components
        << "\"/>\n";
  };
  array("Float32", "displacement_m", 3);
  array("Float32", "velocity_m_per_s", 3);
  array("Float32", "damage", 1);
  array("Int32", "piece", 1);
  if (cracks) array("Int32", "crack", 1);
  xml << "</PPointData>\n<PPoints>\n";
  array("Float32", "Points", 3);
  xml << "</PPoints>\n";
  for (const std::string& piece : pieces) xml << "<Piece Source=\"" << escaped(piece) << "\"/>\n";
  xml << "</PPolyData>\n</VTKFile>\n";
  write_text_file(path, xml.str());
}

void write_hull_vtp(const std::string& path, const QuadMesh& hull) {
  std::vector<std::int32_t> all(hull.quads.size());
  std::iota(all.begin(), all.end(), 0);
  std::vector<std::uint8_t> patch;
  for (const Patch p : hull.patch) patch.push_back(static_cast<std::uint8_t>(p));
  PolyDataFile file;
  file.open("CellData");
  file.array("patch", 1, patch);
  file.close("CellData");
  write_quads(file, path, hull, all);
}

void write_pressure_vtp(const std::string& path, const QuadMesh& hull,
                        const std::vector<PressedQuad>& pressed) {
  std::vector<std::int32_t> quads;
  std::vector<float> pressure, traction;
  for (const PressedQuad& p : pressed) {
    quads.push_back(p.quad);
    pressure.push_back(static_cast<float>(p.pressure));
    for (int c = 0; c < 3; ++c) traction.push_back(static_cast<float>(p.traction[c]));
  }
  PolyDataFile file;
  file.open("CellData");
  file.array("quad", 1, quads);
  file.array("ice_pressure_Pa", 1, pressure);
  file.array("ice_traction_Pa", 3, traction);
  file.close("CellData");
  write_quads(file, path, hull, quads);
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
