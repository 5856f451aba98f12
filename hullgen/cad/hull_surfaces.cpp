#include "hullgen/cad/hull_surfaces.h"

#include <algorithm>
#include <cmath>

#include "base/units.h"
#include "hullgen/bow/bow_surface.h"
#include "hullgen/bow/family.h"

namespace icebow {
namespace {

constexpr int fairing_spans = 24, bilge_spans = 8;
// Knots where the surface, of degree 4, is once or twice continuously differentiable.
constexpr int once = spline_degree - 1, twice = spline_degree - 2;

// Parameters in which the surface is smooth up to its edges. The fairing stands vertical over eta at the
// side, so eta = side - length (1 - p)^2 with p = (u - start) / (2 length) there; the bilge does over z at
// the keel, so z follows the angle of its circle. Both run on from eta and z without a jump of their
// derivative.
class Parameters {
 public:
  explicit Parameters(const BowSurface& bow)
      : bilge_top_(bow.bilge - bow.T), bilge_(bow.bilge), side_(bow.half_beam()) {
    faired_ = bow.K > 0.0;
    fairing_ = faired_ ? bow.yq * (1.0 + bow.fairing_from) : side_;
  }
  double first_v() const { return bilge_top_ - bilge_ * pi / 2.0; }
  double bilge_top() const { return bilge_top_; }
  double fairing() const { return fairing_; }
  bool faired() const { return faired_; }
  double last_u() const { return fairing_ + (faired_ ? 2.0 * (side_ - fairing_) : 0.0); }

  double eta(double u) const {
    if (!faired_ || u <= fairing_) return u;
    const double left = 1.0 - (u - fairing_) / (2.0 * (side_ - fairing_));
    return side_ - (side_ - fairing_) * left * left;
  }
  double z(double v) const {
    return v >= bilge_top_ ? v
                           : bilge_top_ - bilge_ * std::sin(std::min((bilge_top_ - v) / bilge_, pi / 2.0));
  }

 private:
  double bilge_top_, bilge_, side_, fairing_ = 0.0;
  bool faired_ = false;
};

// Keel to deck: bilge, then the breaks of (6).
std::vector<double> vertical_knots(const BowSurface& bow, const Parameters& parameters) {
  const double deck = bow.D - bow.T, least = 1e-6 * bow.D;
  std::vector<Interval> pieces{{parameters.bilge_top(), bilge_spans, once}};
  for (double z : {-bow.belt_below - bow.fan_fade, -bow.belt_below, bow.belt_above,
                   bow.belt_above + bow.deck_fade, deck})
    if (std::isfinite(z) && z > pieces.back().end + least) pieces.push_back({z, 1, twice});
  return clamped_knots(parameters.first_v(), pieces);
}

// Strips of smooth surface from the stem to the side.
std::vector<std::vector<double>> strips(const BowSurface& bow, const Parameters& parameters) {
  std::vector<std::vector<double>> knots;
  const double least = 1e-6 * bow.half_beam();
  double start = 0.0;
  std::vector<Interval> pieces{{bow.yq, 1, once}};
  if (bow.J > 0.0) {
    const double crease = bow.yq * (1.0 + bow.chine);
    pieces.push_back({crease, 1, once});
    knots.push_back(clamped_knots(start, pieces));
    start = crease;
    pieces.clear();
  } else if (parameters.faired() && parameters.fairing() > bow.yq + least) {
    pieces.push_back({parameters.fairing(), 1, once});
  }
  pieces.push_back({parameters.last_u(), parameters.faired() ? fairing_spans : 1, once});
  knots.push_back(clamped_knots(start, pieces));
  return knots;
}

// Behind the reamers: as the mesh has it, the step faces aft at 45 degrees.
SplineCurve behind_reamer(const BowSurface& bow, SplineCurve side) {
  for (Vec3& pole : side.poles) pole -= Vec3(bow.reamer, bow.reamer, 0.0);
  return side;
}

SplineCurve at_transom(double L, SplineCurve side) {
  for (Vec3& pole : side.poles) pole.x() = -L;
  return side;
}

// A flat face from its ring to port, which runs from the centreline outwards and aft: both sides and their
// joint.
FlatFace symmetric_face(std::vector<SplineCurve> port, const std::vector<SplineCurve>& joint) {
  FlatFace face{port};
  face.ring.insert(face.ring.end(), joint.begin(), joint.end());
  for (auto curve = port.rbegin(); curve != port.rend(); ++curve) face.ring.push_back(mirrored(*curve));
  return face;
}

const Vec3& end_of(const SplineCurve& curve, bool last) {
  return last ? curve.poles.back() : curve.poles.front();
}

Vec3 mirrored(const Vec3& p) {
  return Vec3(p.x(), -p.y(), p.z());
}

}  // namespace

HullSurfaces hull_surfaces(const BowParameters& parameters) {
  const BowSurface bow = bow_surface(parameters);
  const Parameters smooth(bow);
  const std::vector<double> v_knots = vertical_knots(bow, smooth);
  const auto surface = [&](double u, double v) { return bow.point(smooth.eta(u), smooth.z(v)); };

  HullSurfaces hull;
  std::vector<SplineCurve> keel, deck;
  for (const std::vector<double>& u_knots : strips(bow, smooth)) {
    hull.port.push_back(fitted_surface(surface, u_knots, v_knots));
    keel.push_back(hull.port.back().edge_at_v(false));
    deck.push_back(hull.port.back().edge_at_v(true));
  }
  std::vector<SplineCurve> stations{hull.port.back().edge_at_u(true)};  // edges of the side, from the bow aft
  if (bow.reamer > 0.0) stations.push_back(behind_reamer(bow, stations.back()));
  stations.push_back(at_transom(parameters.L, stations.back()));
  for (std::size_t k = 1; k < stations.size(); ++k) {
    hull.port.push_back(ruled_surface(stations[k - 1], stations[k]));
    keel.push_back(straight_line(end_of(stations[k - 1], false), end_of(stations[k], false)));
    deck.push_back(straight_line(end_of(stations[k - 1], true), end_of(stations[k], true)));
  }
  const SplineCurve& aft = stations.back();
  const auto across = [&](bool last) {
    return straight_line(end_of(aft, last), mirrored(end_of(aft, last)));
  };
  hull.flat.push_back(symmetric_face(keel, {across(false)}));
  hull.flat.push_back(symmetric_face(deck, {across(true)}));
  hull.flat.push_back({{across(false), mirrored(aft), across(true), aft}});
  return hull;
}

}  // namespace icebow
