#include "hullgen/import/offsets.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>

#include "base/errors.h"
#include "base/text.h"
#include "hullgen/import/waterline.h"
#include "hullgen/mesh/mesh_bytes.h"
#include "hullgen/mesh/ring_triangles.h"

namespace icebow {
namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();
constexpr double inside = 1e-4;  // of the depth: the first and last waterline keep off keel and deck

// Largest y of a loop at x.
double half_breadth(const Polyline& loop, double x) {
  double y = none;
  for (std::size_t k = 0; k + 1 < loop.size(); ++k) {
    const Vec3 &p = loop[k], &q = loop[k + 1];
    if ((p.x() >= x) == (q.x() >= x)) continue;
    const double at = p.y() + (x - p.x()) / (q.x() - p.x()) * (q.y() - p.y());
    if (!(y >= at)) y = at;
  }
  return y;
}

// Half-breadth at an end of a loop: of its corners there.
double end_breadth(const Polyline& loop, double x, double near) {
  double y = 0.0;
  for (const Vec3& p : loop)
    if (std::abs(p.x() - x) <= near) y = std::max(y, p.y());
  return y;
}

void append(std::string& out, double value) {
  out += ',';
  if (std::isfinite(value)) out += text("%.5f", value + 0.0);
}

std::vector<std::string> cells_of(const std::string& line) {
  std::vector<std::string> cells(1);
  for (const char c : line) {
    if (c == ',' || c == ';' || c == '\t')
      cells.emplace_back();
    else
      cells.back() += c;
  }
  for (std::string& cell : cells) {
    const std::size_t from = cell.find_first_not_of(" \""), to = cell.find_last_not_of(" \"");
    cell = from == std::string::npos ? "" : cell.substr(from, to - from + 1);
  }
  return cells;
}

class OffsetsReader {
 public:
  explicit OffsetsReader(const std::string& path) : bytes_(path) {}

  Offsets read() {
    for (std::string line; bytes_.line(line);) {
      line = line.substr(0, line.find('#'));
      if (line.find_first_not_of(" \t,;") != std::string::npos) read_row(cells_of(line));
    }
    if (o_.z.size() < 2) bytes_.fail_file("has no head \"x_m, z, z, ...\" with two waterlines or more");
    if (o_.x.size() < 2) bytes_.fail_file("has fewer than two stations");
    add_ends();
    return std::move(o_);
  }

 private:
  double value(const std::string& cell) const { return cell.empty() ? none : bytes_.number(cell); }

  std::vector<double> values(const std::vector<std::string>& cells) const {
    if (cells.size() > o_.z.size() + 1)
      bytes_.fail(text("%zu half-breadths for %zu waterlines", cells.size() - 1, o_.z.size()));
    std::vector<double> row(o_.z.size(), none);
    for (std::size_t k = 1; k < cells.size(); ++k) row[k - 1] = value(cells[k]);
    return row;
  }

  void read_head(const std::vector<std::string>& cells) {
    for (std::size_t k = 1; k < cells.size(); ++k) {
      std::string cell = cells[k];
      if (cell.compare(0, 2, "z=") == 0) cell.erase(0, 2);
      o_.z.push_back(bytes_.number(cell));
      if (k > 1 && o_.z[k - 1] <= o_.z[k - 2])
        bytes_.fail("the heights of the waterlines must grow from left to right");
    }
  }

  void read_row(const std::vector<std::string>& cells) {
    if (o_.z.empty()) return read_head(cells);
    const std::string& name = cells[0];
    if (name == "fore end") {
      o_.fore_x = values(cells);
    } else if (name == "fore half-breadth") {
      o_.fore_y = values(cells);
    } else if (name == "aft end") {
      o_.aft_x = values(cells);
    } else if (name == "aft half-breadth") {
      o_.aft_y = values(cells);
    } else {
      const double x = bytes_.number(name);
      if (std::find(o_.x.begin(), o_.x.end(), x) != o_.x.end()) bytes_.fail("this station is there twice");
      const std::vector<double> row = values(cells);
      for (double y : row)
        if (y < 0.0) bytes_.fail("a half-breadth below 0");
      const auto at = std::find_if(o_.x.begin(), o_.x.end(), [&](double other) { return other < x; });
      o_.y.insert(o_.y.begin() + (at - o_.x.begin()), row);
      o_.x.insert(at, x);
    }
  }

  void add_ends() {
    const std::size_t n = o_.z.size();
    for (auto* ends : {&o_.fore_x, &o_.fore_y, &o_.aft_x, &o_.aft_y}) ends->resize(n, none);
    for (std::size_t j = 0; j < n; ++j) {
      int first = -1, last = -1;
      for (int i = 0; i < static_cast<int>(o_.x.size()); ++i)
        if (std::isfinite(o_.y[i][j])) first = first < 0 ? i : first, last = i;
      if (first < 0 && !std::isfinite(o_.fore_x[j]))
        bytes_.fail_file(text("the waterline at z = %g has no half-breadth", o_.z[j]));
      if (!std::isfinite(o_.fore_x[j])) o_.fore_x[j] = o_.x[first], o_.fore_y[j] = o_.y[first][j];
      if (!std::isfinite(o_.fore_y[j])) o_.fore_y[j] = 0.0;
      if (!std::isfinite(o_.aft_x[j])) o_.aft_x[j] = o_.x[last], o_.aft_y[j] = o_.y[last][j];
      if (!std::isfinite(o_.aft_y[j])) o_.aft_y[j] = 0.0;
    }
  }

  MeshBytes bytes_;
  Offsets o_;
};

// Points of one waterline, from the centre plane in front to the centre plane aft.
std::vector<int> waterline_points(const Offsets& o, std::size_t j, QuadMesh& mesh) {
  std::vector<int> line;
  const auto add = [&](double x, double y) {
    const Vec3 p(x, y, o.z[j]);
    if (!line.empty() && (mesh.points[line.back()] - p).norm() < 1e-9) return;
    line.push_back(static_cast<int>(mesh.points.size()));
    mesh.points.push_back(p);
  };
  add(o.fore_x[j], 0.0);
  add(o.fore_x[j], o.fore_y[j]);
  for (std::size_t i = 0; i < o.x.size(); ++i)
    if (std::isfinite(o.y[i][j]) && o.x[i] < o.fore_x[j] && o.x[i] > o.aft_x[j]) add(o.x[i], o.y[i][j]);
  add(o.aft_x[j], o.aft_y[j]);
  add(o.aft_x[j], 0.0);
  return line;
}

void add_triangle(QuadMesh& mesh, int a, int b, int c) {
  mesh.quads.push_back({a, b, c, c});
  mesh.patch.push_back(Patch::other);
}

// Panels between two waterlines: the one whose next point lies farther forward goes first.
void join(QuadMesh& mesh, const std::vector<int>& low, const std::vector<int>& high) {
  std::size_t a = 0, b = 0;
  const auto share = [&](const std::vector<int>& line, std::size_t k) {
    const double fore = mesh.points[line.front()].x(), aft = mesh.points[line.back()].x();
    // The ends' corners lie at one x: their number breaks the tie.
    return (fore - mesh.points[line[k]].x()) / std::max(fore - aft, 1e-12) +
           1e-9 * static_cast<double>(k) / static_cast<double>(line.size());
  };
  while (a + 1 < low.size() || b + 1 < high.size()) {
    const bool lower =
        b + 1 == high.size() || (a + 1 < low.size() && share(low, a + 1) <= share(high, b + 1));
    if (lower) {
      add_triangle(mesh, low[a], high[b], low[a + 1]);
      ++a;
    } else {
      add_triangle(mesh, low[a], high[b], high[b + 1]);
      ++b;
    }
  }
}

}  // namespace

Offsets offsets_of(const QuadMesh& mesh, int waterlines, int stations) {
  Offsets o;
  const Box box = bounding_box(mesh);
  const double depth = box.upper.z() - box.lower.z(), length = box.upper.x() - box.lower.x();
  std::vector<Polyline> loops;
  for (int j = 0; j < waterlines; ++j) {
    const double share = std::clamp(static_cast<double>(j) / (waterlines - 1), inside, 1.0 - inside);
    o.z.push_back(box.lower.z() + share * depth);
    loops.push_back(waterline_at(mesh, o.z.back()).loop);
    double fore = -1e300, aft = 1e300;
    for (const Vec3& p : loops.back()) fore = std::max(fore, p.x()), aft = std::min(aft, p.x());
    o.fore_x.push_back(fore), o.aft_x.push_back(aft);
    o.fore_y.push_back(end_breadth(loops.back(), fore, 1e-6 * length));
    o.aft_y.push_back(end_breadth(loops.back(), aft, 1e-6 * length));
  }
  for (int i = 0; i < stations; ++i) {
    o.x.push_back(box.upper.x() - length * i / (stations - 1));
    if (4 * i < stations && i + 1 < stations)
      o.x.push_back(box.upper.x() - length * (i + 0.5) / (stations - 1));
  }
  for (const double x : o.x) {
    o.y.emplace_back();
    for (const Polyline& loop : loops) o.y.back().push_back(half_breadth(loop, x));
  }
  return o;
}

std::string offsets_csv(const Offsets& o) {
  std::string out =
      "# Icebow offsets: half-breadths in metres by station (rows, x forward from the stem) and waterline "
      "(columns, z up from the "
      "design waterline); both sides alike\nx_m";
  for (const double z : o.z) append(out, z);
  const auto row = [&](const char* name, const std::vector<double>& values) {
    out += std::string("\n") + name;
    for (const double v : values) append(out, v);
  };
  row("fore end", o.fore_x);
  row("fore half-breadth", o.fore_y);
  row("aft end", o.aft_x);
  row("aft half-breadth", o.aft_y);
  for (std::size_t i = 0; i < o.x.size(); ++i) row(text("%.5f", o.x[i]).c_str(), o.y[i]);
  return out + "\n";
}

Offsets read_offsets(const std::string& path) {
  return OffsetsReader(path).read();
}

QuadMesh lofted_half(const Offsets& o) {
  QuadMesh mesh;
  std::vector<std::vector<int>> lines;
  for (std::size_t j = 0; j < o.z.size(); ++j) lines.push_back(waterline_points(o, j, mesh));
  for (std::size_t j = 0; j + 1 < lines.size(); ++j) join(mesh, lines[j], lines[j + 1]);
  for (const auto* lid : {&lines.front(), &lines.back()})
    for (const auto& t : ring_triangles(mesh.points, *lid)) add_triangle(mesh, t[0], t[1], t[2]);
  return mesh;
}

}  // namespace icebow
