#include "hullgen/import/surface_normal.h"

#include <Eigen/Geometry>
#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "base/units.h"
#include "geometry/triangles.h"

namespace icebow {
namespace {

constexpr std::array<double, 5> knuckles = {25.0, 12.0, 6.0, 3.0, 1.5};  //!< [deg]
constexpr double fine_fit = 5e-4, fair_fit = 3e-3;  // of the neighbourhood's radius: fewer points, or a
                                                    // nearer knuckle, are tried only for worse
constexpr std::size_t most_points = 40, fewest_points = 11;
constexpr double least_facing = 0.15;  // of a unit normal: below it x over (y, z) is too steep to fit

// The facets around a place, and which of them share an edge.
struct Local {
  std::vector<std::array<int, 3>> facets;
  std::vector<Vec3> normals;
  std::map<std::pair<int, int>, std::vector<int>> at_edge;
};

bool near(const Vec3& at, const Vec3& a, const Vec3& b, const Vec3& c, double reach) {
  const Vec3 lower = a.cwiseMin(b).cwiseMin(c), upper = a.cwiseMax(b).cwiseMax(c);
  return (lower - at).cwiseMax(at - upper).cwiseMax(Vec3::Zero()).norm() <= reach;
}

double distance_to_facet(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 normal = (b - a).cross(c - a);
  const double size = normal.squaredNorm();
  if (size > 0.0) {
    const auto side = [&](const Vec3& u, const Vec3& v) { return (v - u).cross(p - u).dot(normal) >= 0.0; };
    if (side(a, b) && side(b, c) && side(c, a)) return std::abs((p - a).dot(normal)) / std::sqrt(size);
  }
  const auto to_edge = [&](const Vec3& u, const Vec3& v) {
    const double t = std::clamp((p - u).dot(v - u) / std::max((v - u).squaredNorm(), 1e-300), 0.0, 1.0);
    return (u + t * (v - u) - p).norm();
  };
  return std::min({to_edge(a, b), to_edge(b, c), to_edge(c, a)});
}

// Coordinates of the fit: height over two others.
struct Chart {
  int height, u, v;
};
Chart chart_for(const Vec3& normal) {
  if (std::abs(normal.x()) >= least_facing) return {0, 1, 2};
  if (std::abs(normal.y()) >= least_facing) return {1, 0, 2};
  return {2, 0, 1};
}

struct Fit {
  bool found = false;
  Vec3 normal = Vec3::Zero();
  double residual = 1e300;  // root mean square over the radius
  int points = 0, terms = 0;
};

class Fitter {
 public:
  Fitter(const QuadMesh& mesh, const ChordPoints& on_chords, const Local& local, const Neighbourhood& where,
         int seed)
      : mesh_(mesh),
        on_chords_(on_chords),
        local_(local),
        where_(where),
        seed_(seed),
        chart_(chart_for(local.normals[seed])) {}

  // The most points, of `most` down to the fewest a quadric needs, that it fits well; otherwise those it fits
  // best.
  Fit fit(double knuckle, std::size_t most) const {
    const std::vector<std::pair<double, int>> points = points_of(grown(knuckle));
    Fit best;
    for (std::size_t wanted = most; wanted >= fewest_points; wanted -= wanted > 14   ? 4
                                                                       : wanted > 10 ? 2
                                                                                     : 1) {
      const Fit fit = fitted(points, wanted);
      // A plane through two rows of points fits well and knows nothing: only where there is no quadric.
      if (fit.found && (fit.terms > 3) >= (best.terms > 3) &&
          ((fit.terms > 3) > (best.terms > 3) || fit.residual < best.residual))
        best = fit;
      if (best.terms > 3 && best.residual <= fine_fit) break;
    }
    return best;
  }

 private:
  Fit fitted(std::vector<std::pair<double, int>> points, std::size_t wanted) const {
    Fit result;
    if (points.size() < 3) return result;
    const std::size_t n = count(points, wanted);
    points.resize(n);
    const double radius = 1.15 * points.back().first;
    // A quadric through as many points as it has terms would fit anything.
    if (n >= 13) result = solved(points, radius, 7);
    if (!result.found && n >= 9) result = solved(points, radius, 6);
    if (!result.found) result = solved(points, radius, 3);
    if (n == 3) result = {true, local_.normals[seed_], 0.0, 3, 3};
    return result;
  }

  std::vector<int> grown(double knuckle) const {
    const double least_cos = std::cos(radians(knuckle));
    std::vector<int> region = {seed_};
    std::set<int> in = {seed_};
    for (std::size_t k = 0; k < region.size(); ++k) {
      const auto& t = local_.facets[region[k]];
      for (int c = 0; c < 3; ++c)
        for (const int other : local_.at_edge.at(std::minmax(t[c], t[(c + 1) % 3])))
          if (local_.normals[other].dot(local_.normals[region[k]]) >= least_cos && in.insert(other).second)
            region.push_back(other);
    }
    return region;
  }

  // By distance in the chart.
  std::vector<std::pair<double, int>> points_of(const std::vector<int>& region) const {
    std::set<int> points;
    for (const int f : region) points.insert(local_.facets[f].begin(), local_.facets[f].end());
    std::vector<std::pair<double, int>> sorted;
    for (const int k : points) {
      const Vec3 d = mesh_.points[k] - where_.at;
      if (mesh_.points[k].y() < where_.inboard || on_chords_.has(k)) continue;
      sorted.push_back({std::hypot(d[chart_.u], d[chart_.v]), k});
    }
    std::sort(sorted.begin(), sorted.end());
    return sorted;
  }

  // As many as are wanted, with those equally far; fewer where they are out of reach.
  std::size_t count(const std::vector<std::pair<double, int>>& points, std::size_t wanted) const {
    std::size_t n = std::min(points.size(), wanted);
    while (n < points.size() && points[n].first <= 1.0001 * points[n - 1].first) ++n;
    while (n < points.size() && !spread_out(points, n)) ++n;
    while (n > 3 && points[n - 1].first > where_.reach && spread_out(points, n - 1)) --n;
    return n;
  }

  // Points along a line say nothing of the slope across it.
  bool spread_out(const std::vector<std::pair<double, int>>& points, std::size_t n) const {
    Eigen::Vector2d mean = Eigen::Vector2d::Zero();
    const auto flat = [&](std::size_t k) {
      const Vec3& p = mesh_.points[points[k].second];
      return Eigen::Vector2d(p[chart_.u], p[chart_.v]);
    };
    for (std::size_t k = 0; k < n; ++k) mean += flat(k) / static_cast<double>(n);
    Eigen::Matrix2d scatter = Eigen::Matrix2d::Zero();
    for (std::size_t k = 0; k < n; ++k) scatter += (flat(k) - mean) * (flat(k) - mean).transpose();
    const double trace = scatter.trace(), determinant = scatter.determinant();
    return determinant > 1e-3 * trace * trace;  // about a twentieth of the length across
  }

  Fit solved(const std::vector<std::pair<double, int>>& points, double radius, int terms) const {
    const auto n = static_cast<Eigen::Index>(points.size());
    Eigen::MatrixXd a(n, terms);
    Eigen::VectorXd h(n), w(n);
    for (Eigen::Index k = 0; k < n; ++k) {
      const Vec3 d = (mesh_.points[points[static_cast<std::size_t>(k)].second] - where_.at) / radius;
      const double u = d[chart_.u], v = d[chart_.v];
      const double far = std::min(1.0, points[static_cast<std::size_t>(k)].first / radius);
      w[k] = terms == 3 ? 1.0 : 1.0 - far * far;
      a.row(k).head(3) << 1.0, u, v;
      if (terms >= 6) a.row(k).segment(3, 3) << u * u, u * v, v * v;
      // Where curvature jumps across y, that; else the change of curvature with height, above and below an
      // ice belt.
      if (terms == 7)
        a(k, 6) = where_.curvature_jumps ? (chart_.u == 1 ? u * std::abs(u) : v * std::abs(v)) : v * v * v;
      h[k] = d[chart_.height];
    }
    Eigen::ColPivHouseholderQR<Eigen::MatrixXd> least(w.asDiagonal() * a);
    least.setThreshold(0.015);
    Fit fit;
    if (least.rank() < terms) return fit;  // two rows of points say nothing of the curvature across them
    const Eigen::VectorXd c = least.solve(w.asDiagonal() * h);
    Vec3 normal = Vec3::Zero();
    normal[chart_.height] = 1.0;
    normal[chart_.u] = -c[1];
    normal[chart_.v] = -c[2];
    normal.normalize();
    if (normal.dot(local_.normals[seed_]) < 0.0) normal = -normal;
    fit = {true, normal,
           std::sqrt((w.asDiagonal() * (a * c - h)).squaredNorm() / w.squaredNorm() * static_cast<double>(n) /
                     static_cast<double>(std::max<Eigen::Index>(1, n - terms))) *
               std::abs(normal[chart_.height]),
           static_cast<int>(n), terms};
    return fit;
  }

  const QuadMesh& mesh_;
  const ChordPoints& on_chords_;
  const Local& local_;
  const Neighbourhood& where_;
  int seed_;
  Chart chart_;
};

double angle_between(const Vec3& a, const Vec3& b) {
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

}  // namespace

SurfaceNormals::SurfaceNormals(const QuadMesh& mesh, const std::vector<int>& on_chords)
    : mesh_(mesh), facets_(triangles(mesh)), on_chords_(mesh, on_chords) {}

SurfaceNormal SurfaceNormals::at(const Neighbourhood& where) const {
  const auto& p = mesh_.points;
  Local local;
  int seed = -1;
  double nearest = 1e300;
  for (const auto& t : facets_) {
    const Vec3 &a = p[t[0]], &b = p[t[1]], &c = p[t[2]];
    // Facets lie sloped: as far along the ship as the bow's angles stretch the reach across it.
    if (!near(where.at, a, b, c, 4.0 * where.reach)) continue;
    const Vec3 normal = (b - a).cross(c - a);
    if (!(normal.norm() > 0.0)) continue;
    const int own = static_cast<int>(local.facets.size());
    local.facets.push_back(t);
    local.normals.push_back(normal.normalized());
    for (int k = 0; k < 3; ++k) local.at_edge[std::minmax(t[k], t[(k + 1) % 3])].push_back(own);
    const double d = distance_to_facet(where.seed, a, b, c);
    if (d < nearest) nearest = d, seed = own;
  }
  SurfaceNormal result;
  if (seed < 0) return result;
  const Fitter fitter(mesh_, on_chords_, local, where, seed);
  Fit best;
  double knuckle = knuckles[0];
  for (const double limit : knuckles) {
    const Fit fit = fitter.fit(limit, most_points);
    if (!fit.found || fit.residual >= best.residual) continue;
    best = fit, knuckle = limit;
    if (fit.residual <= fair_fit) break;
  }
  if (!best.found) return result;
  result = {true, best.normal, best.points, 0.0};
  const Fit other =
      fitter.fit(knuckle, std::max<std::size_t>(fewest_points, static_cast<std::size_t>(0.75 * best.points)));
  if (other.found) result.spread = angle_between(best.normal, other.normal);
  if (best.points <= 4) {
    // A panel alone knows nothing of the surface between it and the next ones.
    const Fit all = fitter.fit(knuckles[0], most_points);
    if (all.found && best.residual > 1e-9)
      result.spread = std::max(result.spread, 0.5 * angle_between(best.normal, all.normal));
  }
  return result;
}

}  // namespace icebow
