#include "hullgen/import/hull_measurement.h"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

#include "base/errors.h"
#include "base/text.h"
#include "base/units.h"
#include "geometry/mesh_slice.h"
#include "hullgen/import/surface_normal.h"
#include "hullgen/import/waterline.h"

namespace icebow {
namespace {

constexpr double window_share = 1.0 / 40.0;  // of the beam
// A share of the beam. Corners of a cut that are nearer to each other count as one: where a diagonal crosses
// the cut close to an edge, the slope between the two is noise.
constexpr double same_share = 1.0 / 200.0;
constexpr double reach_share =
    1.0 / 4.0;  // of the beam: how far points may be that say what the surface does
// A share of that again. A cut crosses panels this near to a point of the mesh practically on the surface:
// points that were moved a little, to close a gap, make a row as before.
constexpr double practically = 0.05;
constexpr int y_axis = 1, z_axis = 2;
constexpr double none = std::numeric_limits<double>::quiet_NaN();
constexpr double knuckle = radians(20.0), slight_knuckle = radians(1.0);

// One corner of a cut: s against the coordinate along the cut. A corner that is a point of the mesh lies on
// the hull; any other is where the cut crosses a panel's edge, and lies a little inside a hollow, or outside.
struct Sample {
  double along, s;
  bool point;
};
using Row = std::vector<Sample>;

// A cut on both sides of the place where it passes `at`: `before` has the smaller coordinates.
struct Cut {
  bool found = false;
  Vec3 place = Vec3::Zero();
  Row before, after;
};

// A plane cut and the mesh's points in it, without those on chords.
class PlaneCut {
 public:
  PlaneCut(const QuadMesh& mesh, const ChordPoints& on_chords, int axis, double at, double same)
      : same_(same) {
    for (const Polyline& loop : slice(mesh, axis, at)) loops_.push_back(on_chords.without(loop));
    for (std::size_t k = 0; k < mesh.points.size(); ++k)
      if (std::abs(mesh.points[k][axis] - at) <= practically * same && !on_chords.has(static_cast<int>(k)))
        points_.push_back(mesh.points[k]);
    std::sort(points_.begin(), points_.end(), [](const Vec3& p, const Vec3& q) { return p.x() < q.x(); });
  }

  // Where its lines pass `at` farthest forward, or nearest to `x` where that is given.
  Cut crossing(int along, double at, double x = none) const;

 private:
  bool is_point(const Vec3& p) const {
    const double near = practically * same_;
    auto k = std::lower_bound(points_.begin(), points_.end(), p.x() - near,
                              [](const Vec3& q, double value) { return q.x() < value; });
    for (; k != points_.end() && k->x() <= p.x() + near; ++k)
      if ((*k - p).norm() <= near) return true;
    return false;
  }
  Row walk(const Polyline& loop, std::size_t from, int step, int along, double at) const;

  std::vector<Polyline> loops_;
  std::vector<Vec3> points_;
  double same_;
};

// From a corner of a closed line on, as long as the coordinate moves away from `at` and the line has no
// knuckle.
Row PlaneCut::walk(const Polyline& loop, std::size_t from, int step, int along, double at) const {
  const std::size_t n = loop.size() - 1;  // the last point is the first again
  Row row;
  double reached = -1.0, side = 0.0;  // below or above `at`
  for (std::size_t k = 0, i = from; k < n; ++k, i = (i + n + step) % n) {
    const double off = loop[i][along] - at, away = std::abs(off);
    if (away < reached - same_ || (away > same_ && off * side < 0.0)) break;
    if (away > same_) side = off;
    if (away > reached + same_ ||
        (away > reached && !row.empty() && !row.back().point && is_point(loop[i]))) {
      if (away <= reached + same_) row.pop_back();  // a point of the mesh beside a crossing says more
      row.push_back({loop[i][along], -loop[i].x(), is_point(loop[i])});
      reached = away;
    }
  }
  return row;
}

Cut PlaneCut::crossing(int along, double at, double x) const {
  const Polyline* best = nullptr;
  std::size_t corner = 0;
  Cut cut;
  for (const Polyline& loop : loops_)
    for (std::size_t k = 0; k + 1 < loop.size(); ++k) {
      const Vec3 &p = loop[k], &q = loop[k + 1];
      if ((p[along] >= at) == (q[along] >= at)) continue;
      const Vec3 place = p + (at - p[along]) / (q[along] - p[along]) * (q - p);
      const bool better =
          best == nullptr ||
          (std::isnan(x) ? place.x() > cut.place.x() : std::abs(place.x() - x) < std::abs(cut.place.x() - x));
      if (!better) continue;
      best = &loop;
      corner = k;
      cut.place = place;
    }
  if (best == nullptr) return cut;
  cut.found = true;
  const std::size_t n = best->size() - 1;
  cut.before = walk(*best, corner, -1, along, at);
  cut.after = walk(*best, (corner + 1) % n, +1, along, at);
  if ((*best)[corner][along] >= at) std::swap(cut.before, cut.after);
  // The place itself belongs to both sides, unless a corner is there already.
  for (Row* row : {&cut.before, &cut.after})
    if (row->empty() || std::abs(row->front().along - at) > same_)
      row->insert(row->begin(), {at, -cut.place.x(), is_point(cut.place)});
  return cut;
}

// Up to the first knuckle: a turn of 20 deg, or of more than 1 deg and four times what the line turns beside
// it.
Row up_to_knuckle(const Row& row) {
  std::vector<double> turn(row.size(), 0.0);
  for (std::size_t k = 1; k + 1 < row.size(); ++k) {
    const auto heading = [&](std::size_t i) {
      return std::atan2(row[i + 1].s - row[i].s, std::abs(row[i + 1].along - row[i].along));
    };
    turn[k] = std::abs(heading(k) - heading(k - 1));
  }
  for (std::size_t k = 1; k + 1 < row.size(); ++k) {
    const double beside = std::max(k > 1 ? turn[k - 1] : 0.0, k + 2 < row.size() ? turn[k + 1] : 0.0);
    if (turn[k] > knuckle || (turn[k] > slight_knuckle && turn[k] > 4.0 * beside))
      return {row.begin(), row.begin() + static_cast<std::ptrdiff_t>(k) + 1};
  }
  return row;
}

// The corners that are points of the mesh, up to the first knuckle; the others where those are fewer than
// three.
Row trusted(const Row& all) {
  const Row row = up_to_knuckle(all);
  Row points;
  std::copy_if(row.begin(), row.end(), std::back_inserter(points), [](const Sample& s) { return s.point; });
  return points.size() >= 3 ? points : row;
}
bool on_points(const Row& row) {
  return row.size() >= 3 &&
         std::all_of(row.begin(), row.begin() + 3, [](const Sample& s) { return s.point; });
}

Row both(const Row& before, const Row& after, double same) {
  Row row = before;
  for (const Sample& s : after)
    if (row.empty() || std::abs(s.along - row.front().along) > same) row.push_back(s);
  return row;
}

Row sorted_by_distance(Row row, double at) {
  std::sort(row.begin(), row.end(), [at](const Sample& a, const Sample& b) {
    return std::abs(a.along - at) < std::abs(b.along - at);
  });
  return row;
}

// Slope of the panel across `at`, or of the first one beside it. Rows are sorted by distance.
double chord(const Row& row, double at) {
  const auto below = std::find_if(row.begin(), row.end(), [&](const Sample& s) { return s.along < at; });
  const auto above = std::find_if(row.begin(), row.end(), [&](const Sample& s) { return s.along > at; });
  const bool across = below != row.end() && above != row.end();
  const Sample &p = across ? *below : row[0], &q = across ? *above : row[1];
  return (q.s - p.s) / (q.along - p.along);
}

// Whether a parabola through the n nearest samples would run on beyond them to `at`, though there are samples
// on its other side: `at` lies in a long panel, which CAD programs make where the line is nearly straight.
bool extrapolates(const Row& row, double at, std::size_t n) {
  const auto below = [at](const Sample& s) { return s.along < at; };
  const auto above = [at](const Sample& s) { return s.along > at; };
  const auto end = row.begin() + static_cast<std::ptrdiff_t>(n);
  return (std::all_of(row.begin(), end, below) && std::any_of(end, row.end(), above)) ||
         (std::all_of(row.begin(), end, above) && std::any_of(end, row.end(), below));
}

// Slope at `at` of the least-squares parabola through the samples within the window, at least three; where
// there are only two, or all lie on one side of it and there are others, of the panel there.
double slope(Row row, double at, double window) {
  row = sorted_by_distance(std::move(row), at);
  std::size_t n = 0;
  while (n < row.size() && (n < 3 || std::abs(row[n].along - at) <= window)) ++n;
  if (n < 2) return none;
  if (n == 2 || extrapolates(row, at, n)) return chord(row, at);
  Eigen::MatrixX3d powers(n, 3);
  Eigen::VectorXd s(n);
  for (std::size_t k = 0; k < n; ++k) {
    const double d = (row[k].along - at) / window;
    powers.row(k) << 1.0, d, d * d;
    s[k] = row[k].s - row[0].s;
  }
  const Eigen::Vector3d parabola = powers.colPivHouseholderQr().solve(s);
  return parabola[1] / window;
}

// The same by the cubic through the four nearest samples: how far it is off the parabola's says how coarse
// the samples are. NaN where the window has more than three, or there are no four.
double coarse_slope(Row row, double at, double window) {
  row = sorted_by_distance(std::move(row), at);
  if (row.size() < 4 || std::abs(row[3].along - at) <= window) return none;
  Eigen::Matrix4d powers;
  Eigen::Vector4d s;
  for (std::size_t k = 0; k < 4; ++k) {
    const double d = (row[k].along - at) / window;
    powers.row(static_cast<Eigen::Index>(k)) << 1.0, d, d * d, d * d * d;
    s[static_cast<Eigen::Index>(k)] = row[k].s - row[0].s;
  }
  return powers.colPivHouseholderQr().solve(s)[1] / window;
}

void require(bool holds, const char* what, const QuadMesh& mesh) {
  if (holds) return;
  const Box box = bounding_box(mesh);
  throw InputError(text(
      "%s: the hull reaches from z = %g to %g m and y = %g to %g m, z counted from the waterline: is the "
      "height of the waterline right, the unit, the axes?",
      what, box.lower.z(), box.upper.z(), box.lower.y(), box.upper.y()));
}

// Cotangents at P0 and P1, each where it can be read.
struct Slopes {
  double stem = none, waterline = none, buttock = none, quarter = none;
};

// From the surface's normal: d s / d y and -d s / d z.
double along_y(const Vec3& n) {
  return n.y() / n.x();
}
double along_z(const Vec3& n) {
  return -n.z() / n.x();
}

class Measuring {
 public:
  Measuring(const QuadMesh& mesh, const SurfaceNormals& normals) : mesh_(mesh), normals_(normals) {}

  HullMeasurement measured();

 private:
  void read_stem(const Cut& profile);
  void read_entrance(const Cut& entrance);
  void read_quarter(const Cut& waterline, const Cut& buttock);
  void take_quarter_spread(double coarse_quarter, double waterline, double flare);
  SurfaceNormal normal(const Vec3& at, const Vec3& seed, double inboard, bool curvature_jumps) const {
    return normals_.at({at, seed, inboard, reach_share * result_.beam, curvature_jumps});
  }
  // The waterline a little outboard of a place on it.
  Vec3 outboard_of(double y) const;
  void take_spread(double& of, double angle, double other) const {
    if (std::isfinite(other)) of = std::max(of, std::abs(angle - other));
  }

  const QuadMesh& mesh_;
  const SurfaceNormals& normals_;
  HullMeasurement result_;
  Polyline side_;
  StemBar bar_;
  double window_ = 0.0, same_ = 0.0;
  Slopes slopes_;
};

Vec3 Measuring::outboard_of(double y) const {
  for (std::size_t k = 0; k + 1 < side_.size(); ++k) {
    const Vec3 &p = side_[k], &q = side_[k + 1];
    if (q.y() <= y) continue;
    return y <= p.y() ? Vec3(0.5 * (p + q)) : Vec3(p + (y - p.y()) / (q.y() - p.y()) * (q - p));
  }
  return side_.empty() ? Vec3::Zero() : side_.back();
}

void Measuring::read_stem(const Cut& profile) {
  const Row before = trusted(profile.before), after = trusted(profile.after);
  const Row row = both(before, after, same_);
  const auto near = std::count_if(row.begin(), row.end(),
                                  [&](const Sample& s) { return std::abs(s.along) <= 2.5 * window_; });
  // CAD programs put few points on what is nearly straight: then the panel across the waterline is the
  // profile.
  slopes_.stem =
      -(near >= 3 || row.size() < 3 ? slope(row, 0.0, window_) : chord(sorted_by_distance(row, 0.0), 0.0));
  const double angle = std::atan2(1.0, slopes_.stem);
  take_spread(result_.spread.stem, angle, std::atan2(1.0, -slope(row, 0.0, 2.0 * window_)));
  if (row.size() < 3) return;
  // Half a turn of the line beside: what a long panel may hide.
  const Row close = sorted_by_distance(row, 0.0);
  const double beside = std::atan2(1.0, -(close[1].s - close[0].s) / (close[1].along - close[0].along));
  if (extrapolates(close, 0.0, 3)) take_spread(result_.spread.stem, angle, 0.5 * (angle + beside));
}

void Measuring::read_entrance(const Cut& entrance) {
  Row row = entrance.after;
  row.erase(
      std::remove_if(row.begin(), row.end(), [&](const Sample& s) { return s.along < bar_.half_width; }),
      row.end());
  row = trusted(row);
  const Vec3 seed = outboard_of(std::max(bar_.half_width, 1e-3 * result_.beam));
  const SurfaceNormal fit = normal({seed.x(), 0.0, 0.0}, seed, bar_.half_width * (1.0 - 1e-6), false);
  const double from_fit = fit.found ? std::atan2(fit.normal.x(), fit.normal.y()) : none;
  const double from_cut = std::atan2(1.0, slope(row, 0.0, window_));
  // A single panel says less than the line across it and the next.
  const bool cut = on_points(row) || !fit.found || (fit.points <= 4 && row.size() >= 3);
  const double angle = cut ? from_cut : from_fit;
  slopes_.waterline = 1.0 / std::tan(angle);
  if (angle == std::atan2(1.0, 0.0)) slopes_.waterline = 0.0;
  result_.spread.waterline = fit.found && !cut ? fit.spread : 0.0;
  take_spread(result_.spread.waterline, angle, cut ? from_fit : none);
  if (cut) take_spread(result_.spread.waterline, angle, std::atan2(1.0, coarse_slope(row, 0.0, window_)));
}

// From the waterline's slope by coarser samples.
void Measuring::take_quarter_spread(double coarse_quarter, double waterline, double flare) {
  take_spread(result_.spread_at_quarter_beam, waterline, std::atan2(1.0, coarse_quarter));
  take_spread(result_.spread.flare, flare, std::atan2(slopes_.buttock + 0.0, coarse_quarter + 0.0));
}

void Measuring::read_quarter(const Cut& waterline, const Cut& buttock) {
  const double yq = result_.beam / 4.0;
  const Row fore = trusted(waterline.before), aft = trusted(waterline.after);
  const Row up = trusted(buttock.before), down = trusted(buttock.after);
  const Row run = both(up, down, same_);
  const SurfaceNormal fit = normal(waterline.place, waterline.place, -1e300, true);
  const double from_fore = slope(fore, yq, window_), from_aft = slope(aft, yq, window_);
  const double mean = 0.5 * (from_fore + from_aft);
  // A side of which a knuckle leaves one chord says less than one with a curve.
  const bool fore_alone = fore.size() >= 3 && aft.size() < 3, aft_alone = aft.size() >= 3 && fore.size() < 3;
  const double quarter = fore_alone ? from_fore : aft_alone ? from_aft : mean;
  const double cot_buttock = -slope(run, 0.0, window_);
  const bool lines = fore.size() >= 2 && aft.size() >= 2 && run.size() >= 3;
  const bool rows = (on_points(fore) && (on_points(aft) || fore_alone)) || (on_points(aft) && aft_alone);
  const bool cut = (rows && lines && on_points(run)) || !fit.found || (fit.points <= 4 && lines);
  slopes_.quarter = cut || std::abs(fit.normal.x()) < 1e-9 ? quarter : along_y(fit.normal);
  slopes_.buttock = cut || std::abs(fit.normal.x()) < 1e-9 ? cot_buttock : along_z(fit.normal);
  const double a = std::atan2(1.0, slopes_.quarter), g = std::atan2(1.0, slopes_.buttock),
               b = std::atan2(slopes_.buttock + 0.0, slopes_.quarter + 0.0);
  if (cut) take_quarter_spread(mean, a, b);
  if (cut)
    take_quarter_spread(0.5 * (coarse_slope(fore, yq, window_) + coarse_slope(aft, yq, window_)), a, b);
  const Vec3 n = fit.normal;
  if (fit.found && cut) {
    take_spread(result_.spread_at_quarter_beam, a, std::atan2(n.x(), n.y()));
    take_spread(result_.spread.buttock, g, std::atan2(n.x(), -n.z()));
    take_spread(result_.spread.flare, b, std::atan2(-n.z(), n.y()));
  } else if (fit.found) {
    result_.spread_at_quarter_beam = result_.spread.buttock = result_.spread.flare = fit.spread;
  }
}

HullMeasurement Measuring::measured() {
  const Waterline waterline = waterline_at(mesh_, 0.0);
  result_.beam = waterline.port - waterline.starboard;
  require(result_.beam > 0.0, "the waterline does not cut the hull", mesh_);
  const double yq = result_.beam / 4.0;
  window_ = window_share * result_.beam;
  same_ = same_share * result_.beam;
  const ChordPoints& on_chords = normals_.on_chords();
  side_ = on_chords.without(port_side_from_stem(waterline));
  require(!side_.empty(), "the waterline does not meet the centre plane", mesh_);
  bar_ = stem_bar(side_, result_.beam);
  result_.stem_radius = bar_.radius;
  const PlaneCut level(mesh_, on_chords, z_axis, 0.0, same_);
  const Cut entrance = level.crossing(y_axis, 0.0, side_.front().x());
  const Cut profile = PlaneCut(mesh_, on_chords, y_axis, 0.0, same_).crossing(z_axis, 0.0, side_.front().x());
  const Cut quarter = level.crossing(y_axis, yq, outboard_of(yq).x());
  const Cut buttock = PlaneCut(mesh_, on_chords, y_axis, yq, same_).crossing(z_axis, 0.0, quarter.place.x());
  require(profile.found && entrance.found && buttock.found && quarter.found,
          "the waterline does not meet the centre plane or the plane at B/4", mesh_);
  result_.P0 = entrance.place;
  result_.P1 = quarter.place;
  read_stem(profile);
  read_entrance(entrance);
  read_quarter(quarter, buttock);
  // +0 for -0: a vertical front has no slope either way, and its flare is 0.
  result_.angles = {std::atan2(1.0, slopes_.stem), std::atan2(1.0, slopes_.waterline),
                    std::atan2(1.0, slopes_.buttock),
                    std::atan2(slopes_.buttock + 0.0, slopes_.quarter + 0.0)};
  result_.waterline_at_quarter_beam = std::atan2(1.0, slopes_.quarter);
  result_.flare_at_stem = std::atan2(slopes_.stem + 0.0, slopes_.waterline + 0.0);  // (2)
  return result_;
}

HullMeasurement measured_port(const QuadMesh& mesh, const std::vector<int>& on_chords) {
  const SurfaceNormals normals(mesh, on_chords);
  return Measuring(mesh, normals).measured();
}

QuadMesh mirror_image(QuadMesh mesh) {
  for (Vec3& p : mesh.points) p.y() = -p.y();
  for (std::size_t k = 0; k < mesh.quads.size(); ++k) {
    auto& q = mesh.quads[k];
    q = mesh.is_triangle(k) ? std::array<int, 4>{q[0], q[2], q[1], q[1]}
                            : std::array<int, 4>{q[0], q[3], q[2], q[1]};
  }
  return mesh;
}

}  // namespace

HullMeasurement measure_hull(const QuadMesh& mesh, const std::vector<int>& on_chords) {
  return measured_port(mesh, on_chords);
}

HullMeasurement measure_both_sides(const QuadMesh& mesh, const std::vector<int>& on_chords) {
  HullMeasurement port = measured_port(mesh, on_chords);
  port.starboard = measured_port(mirror_image(mesh), on_chords).angles;
  const auto widen = [](double& spread, double a, double b) {
    if (std::isfinite(a) && std::isfinite(b)) spread = std::max(spread, 0.5 * std::abs(a - b));
  };
  widen(port.spread.stem, port.angles.stem, port.starboard.stem);
  widen(port.spread.waterline, port.angles.waterline, port.starboard.waterline);
  widen(port.spread.buttock, port.angles.buttock, port.starboard.buttock);
  widen(port.spread.flare, port.angles.flare, port.starboard.flare);
  return port;
}

}  // namespace icebow
