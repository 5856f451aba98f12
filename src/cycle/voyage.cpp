#include "cycle/voyage.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <sstream>

#include "cycle/breaking.h"
#include "cycle/contact_zone.h"
#include "cycle/ice_strip.h"
#include "cycle/strips.h"

namespace icebow::cycle {
namespace {

constexpr double zone_gap_h = 0.3;       // edges nearer than this are pressed down together
constexpr double deepest_reach_h = 4.0;  // how far beyond the faces of the ice the hull is looked at, at most
constexpr double most_visits = 3e9;      // of strips, in a voyage: a minute
constexpr double settled_l = 2.0;  // after the bow has entered so many characteristic lengths are not counted

// The same numbers on every machine, which std::uniform_real_distribution does not promise.
double even(std::mt19937_64& random) {
  return static_cast<double>(random() >> 11) * 0x1.0p-53;
}

// An edge that breaks in a step, with the places where the hull pressed it: the next piece that breaks off in
// the same step may take away the ice there.
struct Broken {
  const Zone* zone;
  double radius;
  std::vector<Eigen::Vector2d> contact;
};

std::vector<double> front_at_rest(const HullFront& front) {
  std::vector<double> foremost(static_cast<std::size_t>(front.map.columns()), FrontMap::none);
  for (int i = 0; i < front.map.columns(); ++i) {
    for (int row = front.bottom_row; row <= front.bottom_row + HullFront::layers; ++row)
      foremost[static_cast<std::size_t>(i)] =
          std::max(foremost[static_cast<std::size_t>(i)], front.map.x(i, row));
  }
  return foremost;
}

class Sailing {
 public:
  Sailing(const QuadMesh& hull, const Ice& ice, const BreakingRule& rule, const Voyage& voyage)
      : ice_(ice),
        rule_(rule),
        voyage_(voyage),
        strips_(make_strips(hull, ice.bottom(), ice.top(), voyage.raster_h * ice.h,
                            (1.0 + voyage.scatter) * largest_radius(ice, rule) + ice.h, voyage.symmetric)),
        front_(hull, strips_, ice, reach()),
        sheet_(strips_.y.size()),
        deflection_(strips_.y.size(), 0.0),
        down_before_(strips_.y.size(), 0.0),
        bare_(strips_.y.size(), FrontMap::none),
        foremost_at_rest_(front_at_rest(front_)),
        zones_(ice_, front_, strips_, sheet_),
        random_(voyage.seed) {}

  VoyageResult run();

 private:
  double reach() const;
  std::string trouble() const;
  bool goes_through() const;
  long steps() const;
  void step(double X);
  std::vector<Touch> touches(double X) const;
  std::vector<Zone> touched(double X) const;
  bool joins(const Touch& before, const Touch& next) const;
  Press press(const Zone& zone) const;
  void carry(const Zone& zone, std::vector<double>& deflection, std::vector<double>& down) const;
  double down_before(const Zone& zone) const;
  double hold_to(Zone& zone, double load) const;
  void book(const Zone& zone, double X, double part, Record& record);
  double before(const Zone& zone, const Touch& t) const;
  void remember(const Zone& zone);
  std::vector<Eigen::Vector2d> contact(const Zone& zone) const;
  Piece break_off(const Broken& broken, double X);
  double cut(std::vector<Eigen::Vector2d> contact, double radius, Piece& piece);
  void clear_crushed();
  void measure_channel(double X);
  double edge(const Touch& t) const { return sheet_[at(t.strip)].intervals()[t.interval].from; }
  static std::size_t at(int i) { return static_cast<std::size_t>(i); }
  bool counted(double X) const { return X + foremost_ > result_.counted_from; }

  const Ice& ice_;
  const BreakingRule& rule_;
  const Voyage& voyage_;
  Strips strips_;
  HullFront front_;
  std::vector<IceStrip> sheet_;
  std::vector<double> deflection_;   // of each strip's edge, as the last step left it
  std::vector<double> down_before_;  // of each strip: its load down in the last step
  std::vector<double> bare_;         // of each strip: ice before it is crushed from face to face
  std::vector<double>
      foremost_at_rest_;  // of each strip's front, over the thickness of ice that is not pressed
  ZoneSolver zones_;
  std::mt19937_64 random_;
  VoyageResult result_;
  double foremost_ = 0.0;
  double next_station_ = 0.0;
};

// Of the widest edge pressed at the speed of this ship: how far above and below the ice the hull is looked
// at.
double Sailing::reach() const {
  const double width = 2.0 * (strips_.half_beam + strips_.length);
  const Capacity strongest = capacity(ice_, rule_, {width, 0.0, 10.0 * voyage_.speed});
  return std::clamp(1.05 * strongest.load / edge_stiffness(ice_), ice_.h, deepest_reach_h * ice_.h);
}

std::string Sailing::trouble() const {
  std::ostringstream text;
  if (strips_.count() == 0 || foremost_ == FrontMap::none) {
    text << "the hull does not reach the ice: it has no surface facing ahead between the faces of the ice, "
         << ice_.bottom() << " to " << ice_.top() << " m from the waterline";
  } else if (!goes_through()) {
    text << "the hull does not go through the ice: nowhere does it reach down to the lower face of the ice, "
         << ice_.bottom() << " m from the waterline; take a deeper draught or thinner ice";
  } else if (static_cast<double>(steps()) * strips_.count() > most_visits) {
    text << "the ice is too thin for this hull and voyage: " << steps() << " steps of " << strips_.count()
         << " strips; take thicker ice, a shorter voyage or a coarser raster";
  }
  return text.str();
}

bool Sailing::goes_through() const {
  for (int i = 0; i < strips_.count(); ++i)
    if (front_.map.reaches(i, front_.bottom_row)) return true;
  return false;
}

long Sailing::steps() const {
  const double entered = strips_.length + settled_l * ice_.characteristic_length();
  return static_cast<long>(std::ceil((entered + voyage_.length) / (voyage_.step_h * ice_.h)));
}

bool Sailing::joins(const Touch& before, const Touch& next) const {
  const double along = edge(next) - edge(before),
               across = strips_.y[at(next.strip)] - strips_.y[at(before.strip)];
  return std::hypot(along, across) <= (zone_gap_h + voyage_.raster_h) * ice_.h;
}

// Edges that the hull has come to, were they not pressed down.
std::vector<Touch> Sailing::touches(double X) const {
  std::vector<Touch> found;
  for (int i = 0; i < strips_.count(); ++i) {
    if (foremost_at_rest_[at(i)] == FrontMap::none) continue;
    const auto& intervals = sheet_[at(i)].intervals();
    const double reached = X + foremost_at_rest_[at(i)];
    for (std::size_t k = 0; k < intervals.size() && intervals[k].from < reached; ++k) {
      Touch& t = found.emplace_back();
      t.strip = i, t.interval = k, t.deflection_before = deflection_[at(i)];
    }
  }
  return found;
}

// In groups of neighbours.
std::vector<Zone> Sailing::touched(double X) const {
  const std::vector<Touch> all = touches(X);
  std::vector<std::size_t> group(all.size());
  const double gap = (zone_gap_h + voyage_.raster_h) * ice_.h;
  for (std::size_t i = 0; i < all.size(); ++i) {
    group[i] = i;
    for (std::size_t j = i; j-- > 0 && strips_.y[at(all[i].strip)] - strips_.y[at(all[j].strip)] <= gap;) {
      if (group[j] == group[i] || !joins(all[j], all[i])) continue;
      const std::size_t low = std::min(group[i], group[j]), high = std::max(group[i], group[j]);
      std::replace(group.begin(), group.begin() + static_cast<std::ptrdiff_t>(i) + 1, high, low);
    }
  }
  std::vector<Zone> zones;
  std::vector<std::size_t> place(all.size());
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (group[i] == i) place[i] = zones.size(), zones.emplace_back();
    Zone& zone = zones[place[group[i]]];
    zone.touches.push_back(all[i]);
    if (voyage_.symmetric && all[i].strip == 0) zone.factor = 2.0;
  }
  return zones;
}

Press Sailing::press(const Zone& zone) const {
  const double down = std::abs(zone.area.z()), ahead = zone.area.x();
  const double steepest = 10.0;  // a wall drives no edge down, however fast
  return {zone.width, voyage_.speed * ahead / zone.area.norm(),
          voyage_.speed * (down * steepest > ahead ? ahead / down : steepest)};
}

void Sailing::step(double X) {
  std::vector<Zone> zones = touched(X);
  std::vector<double> deflection(strips_.y.size(), 0.0), down = deflection;
  std::vector<Broken> broken;
  Record& record = result_.records.emplace_back();
  record.advance = X + foremost_;
  for (Zone& zone : zones) {
    zones_.settle(zone, X, front_.bottom_row * front_.map.dz(), result_.step);
    if (zone.area.x() <= 0.0) continue;
    const Capacity limit = capacity(ice_, rule_, press(zone));
    const bool breaks = std::abs(zone.down) >= limit.load;
    const double part = breaks ? hold_to(zone, limit.load) : 1.0;
    book(zone, X, part, record);
    if (breaks)
      broken.push_back(
          {&zone, limit.radius * (1.0 + voyage_.scatter * (2.0 * even(random_) - 1.0)), contact(zone)});
    else
      carry(zone, deflection, down);
    remember(zone);
  }
  deflection_ = std::move(deflection);
  down_before_ = std::move(down);
  for (const Broken& b : broken) result_.pieces.push_back(break_off(b, X));
  clear_crushed();
}

// What the next step has to know of a zone.
void Sailing::carry(const Zone& zone, std::vector<double>& deflection, std::vector<double>& down) const {
  for (const Touch& t : zone.touches) {
    deflection[at(t.strip)] = zone.deflection;
    if (t.presses)
      down[at(t.strip)] = t.normal_force * down_share(directions(t.area, ice_.friction), ice_.friction);
  }
}

// Vertical load of the zone's edges in the step before.
double Sailing::down_before(const Zone& zone) const {
  double sum = 0.0;
  for (const Touch& t : zone.touches) sum += zone.factor * down_before_[at(t.strip)];
  return sum;
}

// The edge broke at its capacity, within the step: returns which part of the step it bore load for.
double Sailing::hold_to(Zone& zone, double load) const {
  const double grown = std::abs(zone.down), had = std::abs(down_before(zone)), share = load / grown;
  for (Touch& t : zone.touches) t.normal_force *= share;
  zone.down *= share;
  zone.deflection *= share;
  return had < load ? (load - had) / (grown - had) : 0.0;
}

// Loads are means over the step, in whose part `part` the edge grew from its load before to the present one.
void Sailing::book(const Zone& zone, double X, double part, Record& record) {
  const double mu = ice_.friction, copies = voyage_.symmetric ? 2.0 : 1.0;
  const double grown = std::abs(zone.down),
               mean = grown > 0.0 ? 0.5 * (1.0 + std::min(1.0, std::abs(down_before(zone)) / grown)) : 1.0;
  for (const Touch& t : zone.touches) {
    if (!t.presses) continue;
    const Directions d = directions(t.area, mu);
    const double N = mean * t.normal_force;
    const Vec3 force = -copies * part * N * (d.normal + mu * d.friction);
    const Vec3 place(edge(t) + 0.5 * t.depth - X, strips_.y[at(t.strip)], 0.0);
    record.force += force;
    record.moment += place.cross(force);
    if (!counted(X)) continue;
    const double dX = part * result_.step, lower = zone.deflection - before(zone, t);
    const double crushing = copies * N * (d.normal.x() * dX + d.normal.z() * lower);
    result_.work.crushing += crushing;
    result_.work.bending += copies * N * down_share(d, mu) * lower;
    result_.work.friction += copies * mu * N * (d.friction.x() * dX + d.friction.z() * lower);
    result_.work.total -= force.x() * result_.step;
    result_.crushed_volume += crushing / ice_.p_c;
  }
  if (voyage_.symmetric) record.force.y() = record.moment.x() = record.moment.z() = 0.0;
}

// A strip that has just been touched had gone down with the edge beside it.
double Sailing::before(const Zone& zone, const Touch& t) const {
  if (t.deflection_before != 0.0) return t.deflection_before;
  double most = 0.0;
  for (const Touch& other : zone.touches)
    if (std::abs(other.deflection_before) > std::abs(most)) most = other.deflection_before;
  return most;
}

void Sailing::remember(const Zone& zone) {
  for (const Touch& t : zone.touches) {
    if (!t.presses) continue;
    Interval& interval = sheet_[at(t.strip)].intervals()[t.interval];
    interval.memory = std::max(interval.memory, t.depth);
    bare_[at(t.strip)] = std::max(bare_[at(t.strip)], t.bare);
  }
}

// Where the hull presses the zone's edges.
std::vector<Eigen::Vector2d> Sailing::contact(const Zone& zone) const {
  std::vector<Eigen::Vector2d> places;
  for (const Touch& t : zone.touches)
    if (t.presses) places.emplace_back(edge(t) + 0.5 * t.depth, strips_.y[at(t.strip)]);
  return places;
}

Piece Sailing::break_off(const Broken& broken, double X) {
  const Zone& zone = *broken.zone;
  const Press pressed = press(zone);
  Piece piece;
  piece.advance = X + foremost_;
  piece.width = zone.width, piece.radius = broken.radius, piece.load = std::abs(zone.down);
  piece.normal_speed = pressed.normal_speed, piece.edge_speed = pressed.edge_speed;
  piece.deflection = zone.deflection;
  if (counted(X))
    result_.elastic_released +=
        (voyage_.symmetric && zone.factor == 1.0 ? 1.0 : 0.5) * std::abs(zone.down * zone.deflection);
  piece.area = cut(broken.contact, broken.radius, piece);
  return piece;
}

// Takes out what lies within the radius of the contact, and what then hangs on nothing.
double Sailing::cut(std::vector<Eigen::Vector2d> contact, double radius, Piece& piece) {
  piece.x = piece.y = 0.0;
  for (const auto& c : contact) piece.x += c.x() / contact.size(), piece.y += c.y() / contact.size();
  if (voyage_.symmetric) {
    for (std::size_t i = contact.size(); i-- > 0;)
      if (contact[i].y() < radius) contact.emplace_back(contact[i].x(), -contact[i].y());
  }
  int first = strips_.count(), last = -1;
  double area = 0.0;
  for (int i = 0; i < strips_.count(); ++i) {
    double from = IceStrip::ahead, to = -IceStrip::ahead;
    for (const auto& c : contact) {
      const double across = strips_.y[at(i)] - c.y();
      if (std::abs(across) >= radius) continue;
      const double along = std::sqrt(radius * radius - across * across);
      from = std::min(from, c.x() - along), to = std::max(to, c.x() + along);
    }
    if (to <= from) continue;
    first = std::min(first, i), last = i;
    const double removed = sheet_[at(i)].cut(from, to);
    area += removed * strips_.width[at(i)];
    if (voyage_.keep_shapes && removed > 0.0)
      piece.shape.push_back({strips_.y[at(i)], strips_.width[at(i)], from, to});
  }
  if (last < first) return area;
  return area +
         drop_islands(sheet_, strips_.width, std::max(0, first - 1), std::min(strips_.count() - 1, last + 1));
}

// What the hull has gone through from face to face.
void Sailing::clear_crushed() {
  for (int i = 0; i < strips_.count(); ++i) {
    if (bare_[at(i)] > FrontMap::none) sheet_[at(i)].trim(bare_[at(i)]);
    bare_[at(i)] = FrontMap::none;
  }
}

void Sailing::measure_channel(double X) {
  const double station = X + foremost_ - strips_.length - 1.5 * largest_radius(ice_, rule_);
  if (station < next_station_) return;
  next_station_ = station + ice_.h;
  const int n = strips_.count();
  const int middle = voyage_.symmetric ? 0 : n / 2;
  const auto reach = [&](int way, int from) {
    double far = 0.0;
    for (int i = from; i >= 0 && i < n; i += way) {
      if (std::abs(strips_.y[at(i)]) > strips_.half_beam && sheet_[at(i)].holds(station)) break;
      far = std::abs(strips_.y[at(i)]) + 0.5 * strips_.width[at(i)];
    }
    return far;
  };
  const double port = reach(1, middle), starboard = voyage_.symmetric ? port : reach(-1, n / 2 - 1);
  if (counted(X)) result_.channel.push_back(port + starboard);
  for (IceStrip& strip : sheet_) strip.trim(station - ice_.h);
}

VoyageResult Sailing::run() {
  foremost_ = FrontMap::none;
  for (double x : foremost_at_rest_) foremost_ = std::max(foremost_, x);
  result_.reason = trouble();
  if (!result_.reason.empty()) return std::move(result_);
  result_.step = voyage_.step_h * ice_.h;
  result_.beam = 2.0 * strips_.half_beam, result_.bow_length = strips_.length;
  result_.counted_from = strips_.length + settled_l * ice_.characteristic_length();
  result_.records.reserve(static_cast<std::size_t>(steps()));
  for (long k = 1; k <= steps(); ++k) {
    const double X = static_cast<double>(k) * result_.step - foremost_;
    step(X);
    measure_channel(X);
  }
  result_.counted_to = static_cast<double>(steps()) * result_.step;
  return std::move(result_);
}

}  // namespace

VoyageResult sail(const QuadMesh& hull, const Ice& ice, const BreakingRule& rule, const Voyage& voyage) {
  VoyageResult result;
  result.reason = trouble_with(ice, voyage, rule);
  if (!result.reason.empty()) return result;
  return Sailing(hull, ice, rule, voyage).run();
}

}  // namespace icebow::cycle
