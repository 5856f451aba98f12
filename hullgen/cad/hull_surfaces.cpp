#include "hullgen/cad/hull_surfaces.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/units.h"
#include "hullgen/bow/bow_grid.h"
#include "hullgen/bow/bow_surface.h"
#include "hullgen/bow/family.h"
#include "hullgen/bow/skeg.h"

namespace icebow {
namespace {

constexpr int fairing_spans = 24, bilge_spans = 8, rounding_spans = 8, centre_spans = 4;
// Knots where the surface, of degree 4, is once or twice continuously differentiable.
constexpr int once = spline_degree - 1, twice = spline_degree - 2;
constexpr int creased = spline_degree;           // and where it has a crease
constexpr double rounding_turn = radians(70.0);  // of the stem's rounding from the centre plane to the side

// Parameters in which the surface is smooth up to its edges. The fairing stands vertical over eta at the
// side, so eta = side - length (1 - p)^2 with p = (u - start) / (2 length) there; the bilge does over z at
// the keel, so z follows the angle of its circle. Both run on from eta and z without a jump of their
// derivative. The rounding of the stem, a circle over eta, runs by its angle.
class Parameters {
 public:
  explicit Parameters(const BowSurface& bow)
      : bilge_top_(bow.bilge - bow.T),
        bilge_(bow.bilge),
        side_(bow.half_beam()),
        rounding_(bow.stem_half_width) {
    faired_ = bow.K > 0.0;
    fairing_ = faired_ ? bow.yq * (1.0 + bow.fairing_from) : side_;
  }
  double first_v() const { return bilge_top_ - bilge_ * pi / 2.0; }
  double bilge_top() const { return bilge_top_; }
  double fairing() const { return fairing_; }
  bool faired() const { return faired_; }
  double last_u() const { return fairing_ + (faired_ ? 2.0 * (side_ - fairing_) : 0.0); }

  double eta(double u) const {
    if (u < rounding_) return rounding_ * std::sin(rounding_turn * u / rounding_) / std::sin(rounding_turn);
    if (!faired_ || u <= fairing_) return u;
    const double left = 1.0 - (u - fairing_) / (2.0 * (side_ - fairing_));
    return side_ - (side_ - fairing_) * left * left;
  }
  double u(double eta) const {  // inboard of the fairing
    if (eta >= rounding_) return eta;
    return rounding_ / rounding_turn * std::asin(eta / rounding_ * std::sin(rounding_turn));
  }
  double v_in_bilge(double z) const { return bilge_top_ - bilge_ * std::asin((bilge_top_ - z) / bilge_); }
  double z(double v) const {
    return v >= bilge_top_ ? v
                           : bilge_top_ - bilge_ * std::sin(std::min((bilge_top_ - v) / bilge_, pi / 2.0));
  }

 private:
  double bilge_top_, bilge_, side_, rounding_, fairing_ = 0.0;
  bool faired_ = false;
};

// Keel to deck: bilge, then the breaks of (6).
std::vector<double> vertical_knots(const BowSurface& bow, const Parameters& parameters) {
  const double deck = bow.D - bow.T, least = 1e-6 * bow.D;
  const bool knife = bow.knife_half_width > 0.0, rounded = bow.stem_half_width > 0.0;
  std::vector<Interval> pieces;
  if (knife && bow.knife_top < parameters.bilge_top() - least)
    pieces.push_back({parameters.v_in_bilge(bow.knife_top), bilge_spans, creased});
  pieces.push_back({parameters.bilge_top(), bilge_spans, once});
  std::vector<std::pair<double, int>> breaks = {{-bow.belt_below - bow.fan_fade, twice},
                                                {-bow.belt_below, twice},
                                                {bow.belt_above, twice},
                                                {bow.belt_above + bow.deck_fade, twice},
                                                {deck, twice}};
  if (knife) breaks.emplace_back(bow.knife_top, creased);
  std::sort(breaks.begin(), breaks.end());
  for (const auto& [z, multiplicity] : breaks)
    if (std::isfinite(z) && z > pieces.back().end + least)
      pieces.push_back({z, rounded ? centre_spans : 1, multiplicity});
  return clamped_knots(parameters.first_v(), pieces);
}

// Strips of smooth surface from the stem to the side.
std::vector<std::vector<double>> strips(const BowSurface& bow, const Parameters& parameters, double skeg) {
  std::vector<std::vector<double>> knots;
  const double least = 1e-6 * bow.half_beam();
  double start = 0.0;
  for (const double eta : centre_lines(bow, {skeg})) {
    const double end = parameters.u(eta);
    knots.push_back(clamped_knots(start, {{end, eta <= bow.stem_half_width ? rounding_spans : 1, once}}));
    start = end;
  }
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

// The bottom's strip under the skeg, to port: from the bow's edge behind the reamers to the transom, piece by
// piece from crease to crease. u as on the bow's strips above.
std::vector<SplineSurface> skeg_pieces(const BowSurface& bow, const Skeg& skeg, double L,
                                       const Parameters& parameters, const std::vector<double>& u_knots) {
  const double drawn_in = 1.0 - bow.reamer / bow.half_breadth(-bow.T);
  const auto at = [&](double u, double share) {  // share below 0: on the reamer's step
    const double eta = parameters.eta(u), ahead = std::max(-share, 0.0);
    Vec3 p = bow.point(eta, -bow.T);
    p.y() *= drawn_in + ahead * (1.0 - drawn_in);
    p.x() -= (1.0 - ahead) * bow.reamer;
    const double aft = std::max(share, 0.0);
    p.x() += aft * (-L - p.x());
    p.z() -= skeg.depth(aft, eta);
    return p;
  };
  std::vector<double> ends = skeg.shares();
  ends.insert(ends.begin(), 0.0);
  if (ends.back() < 1.0 - 1e-9) ends.push_back(1.0);
  double from = bow.reamer > 0.0 ? -1.0 : 0.0;
  std::vector<SplineSurface> pieces;
  for (const double end : ends) {
    if (end - from < 1e-9) continue;
    pieces.push_back(fitted_surface(at, u_knots, clamped_knots(from, {{end, 1, once}})));
    from = end;
  }
  return pieces;
}

void append(std::vector<SplineCurve>& ring, const std::vector<SplineCurve>& more) {
  ring.insert(ring.end(), more.begin(), more.end());
}

// The bottom outside the skeg, either side, and the edge of the transom to port from the side to the
// centreline. `outer` runs from the skeg along the bow and the side to the transom.
std::vector<SplineCurve> bottom_around(const std::vector<std::vector<SplineSurface>>& skeg,
                                       const std::vector<SplineCurve>& outer, std::vector<FlatFace>& flat) {
  std::vector<SplineCurve> edge{
      straight_line(outer.back().poles.back(), end_of(skeg.back().back().edge_at_v(true), true))};
  FlatFace port{outer};
  append(port.ring, edge);
  for (auto piece = skeg.back().rbegin(); piece != skeg.back().rend(); ++piece)
    port.ring.push_back(piece->edge_at_u(true));
  FlatFace starboard;
  for (const SplineCurve& curve : port.ring) starboard.ring.push_back(mirrored(curve));
  flat.push_back(port);
  flat.push_back(starboard);
  for (auto strip = skeg.rbegin(); strip != skeg.rend(); ++strip)
    edge.push_back(strip->back().edge_at_v(true));
  return edge;
}

}  // namespace

HullSurfaces hull_surfaces(const BowParameters& parameters) {
  const BowSurface bow = bow_surface(parameters);
  const Parameters smooth(bow);
  const std::vector<double> v_knots = vertical_knots(bow, smooth);
  const auto surface = [&](double u, double v) { return bow.point(smooth.eta(u), smooth.z(v)); };

  const Skeg skeg = skeg_of(parameters);
  HullSurfaces hull;
  std::vector<SplineCurve> keel, deck;
  std::vector<std::vector<SplineSurface>> under;  // the skeg's, by strip
  for (const std::vector<double>& u_knots : strips(bow, smooth, skeg.half_width)) {
    hull.port.push_back(fitted_surface(surface, u_knots, v_knots));
    if (smooth.eta(u_knots.back()) <= skeg.half_width * (1.0 + 1e-9))
      under.push_back(skeg_pieces(bow, skeg, parameters.L, smooth, u_knots));
    else
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
  std::vector<SplineCurve> transom{across(false)};  // its lower edge, from port to starboard
  if (under.empty()) {
    hull.flat.push_back(symmetric_face(keel, transom));
  } else {
    transom = bottom_around(under, keel, hull.flat);
    for (std::size_t k = transom.size(); k > 0; --k) transom.push_back(mirrored(transom[k - 1]));
    for (const std::vector<SplineSurface>& strip : under)
      hull.port.insert(hull.port.end(), strip.begin(), strip.end());
  }
  hull.flat.push_back(symmetric_face(deck, {across(true)}));
  append(transom, {mirrored(aft), across(true), aft});
  hull.flat.push_back({transom});
  return hull;
}

}  // namespace icebow
