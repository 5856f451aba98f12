#include "study/evaluate/cycle_run.h"

#include <algorithm>
#include <boost/math/distributions/chi_squared.hpp>
#include <chrono>
#include <cmath>

#include "base/units.h"
#include "formula/lindqvist.h"
#include "solver/model/load_cycle.h"
#include "study/evaluate/evaluator_inputs.h"
#include "study/evaluate/process_json.h"
#include "study/evaluate/result_json.h"

namespace icebow {
namespace {

using cycle::Piece;
using cycle::Record;
using cycle::VoyageResult;

constexpr int steps_per_sample = 5;        // of the record: 0.2 h with the usual step
constexpr std::size_t enough_voyages = 4;  // for their scatter to say more than the records do

struct Loads {
  std::vector<double> resistance, vertical;
  std::vector<Record> samples;
};

// Means over some steps, of the part counted unless `whole`.
Loads sampled(const VoyageResult& v, bool whole) {
  Loads loads;
  Record sum;
  int n = 0;
  for (const Record& r : v.records) {
    if (!whole && r.advance <= v.counted_from) continue;
    sum.force += r.force, sum.moment += r.moment;
    if (++n < steps_per_sample) continue;
    loads.samples.push_back({r.advance, sum.force / n, sum.moment / n});
    loads.resistance.push_back(-sum.force.x() / n);
    loads.vertical.push_back(sum.force.z() / n);
    sum = Record();
    n = 0;
  }
  return loads;
}

// Several voyages as one record: they are independent.
LoadStatistics pooled(const std::vector<LoadStatistics>& all, double add) {
  LoadStatistics sum;
  double square = 0.0, variance = 0.0;
  const double n = static_cast<double>(all.size());
  for (const LoadStatistics& s : all) {
    sum.mean += s.mean / n, sum.q95 += s.q95 / n;
    sum.max = &s == &all.front() ? s.max : std::max(sum.max, s.max);
    sum.samples += s.samples, sum.effective_samples += s.effective_samples;
    square += s.ci95 * s.ci95, variance += s.standard_deviation * s.standard_deviation / n;
  }
  sum.ci95 = std::sqrt(square) / n;
  sum.standard_deviation = std::sqrt(variance);
  sum.mean += add, sum.q95 += add, sum.max += add;
  return sum;
}

History history_of(const VoyageResult& v, double speed, double submersion) {
  History history;
  history.interval = v.step * steps_per_sample / speed;
  double work = 0.0, before = 0.0;
  for (const Record& r : sampled(v, true).samples) {
    HistoryRow row;
    row.advance = r.advance, row.t = r.advance / speed;
    for (int k = 0; k < 3; ++k) row.F[k] = r.force[k], row.M[k] = r.moment[k];
    row.F[0] -= submersion;
    work -= row.F[0] * (r.advance - before);
    before = r.advance;
    row.hull_work = work;
    row.contacts = r.force.norm() > 0.0 ? 1 : 0;
    history.rows.push_back(row);
  }
  return history;
}

// A piece's crack: parallel to its contact, the radius off, and round at its ends.
Crack crack_of(const Piece& p, double h) {
  Crack crack;
  crack.kind = CrackKind::circumferential;
  crack.opened = p.advance;
  crack.x = p.x - p.advance, crack.y = p.y;
  crack.length = p.width + pi * p.radius;
  crack.from_hull = p.radius, crack.along_course = p.radius;
  crack.direction = 0.5 * pi;
  crack.columns = std::max(1, static_cast<int>(std::lround(crack.length / h)));
  return crack;
}

Floe floe_of(const Piece& p) {
  Floe floe;
  floe.area = p.area, floe.x = p.x, floe.y = p.y, floe.through = 1.0;
  floe.width = p.radius, floe.length = p.area / p.radius;
  return floe;
}

// Shares of the ship's work.
EnergyShares energy_of(const CycleOutcome& o, double way) {
  EnergyShares e;
  e.hull_work = o.mean * way;
  e.elastic = o.bending / o.mean;
  e.contact_loss = (o.crushing + o.friction + o.under_hull.friction) / o.mean;
  e.potential = (o.submersion - o.under_hull.friction) / o.mean;
  e.water = o.water / o.mean;
  e.fracture = e.kinetic = e.floe_contact = e.absorbed = e.left_astern = 0.0;
  e.unexplained = 1.0 - e.elastic - e.contact_loss - e.potential - e.water;
  return e;
}

BreakingProcess process_of(const CycleOutcome& o, const Case& c) {
  const VoyageResult& v = o.first_voyage;
  BreakingProcess p;
  p.thickness = c.ice.h, p.characteristic_length = cycle_ice(c).characteristic_length();
  p.stem_x = v.counted_to;
  for (const Piece& piece : v.pieces) {
    if (piece.advance <= v.counted_from) continue;
    p.cracks.list.push_back(crack_of(piece, c.ice.h));
    p.cracks.columns[static_cast<int>(CrackKind::circumferential)] += p.cracks.list.back().columns;
    p.ice.floes.push_back(floe_of(piece));
    p.ice.in_floes += piece.area * c.ice.h;
  }
  p.ice.volume = p.ice.in_floes + v.crushed_volume, p.ice.dust = v.crushed_volume;
  const double astern = v.bow_length;
  for (std::size_t i = 0; i < v.channel.size(); ++i)
    p.ice.channel.push_back({v.counted_from - astern + static_cast<double>(i) * c.ice.h, v.channel[i]});
  p.breaking_length = breaking_length(p.cracks.list);
  p.load = load_cycle(o.run.history, v.counted_from);
  p.energy = energy_of(o, v.counted_to - v.counted_from);
  return p;
}

Metrics metrics_of(const CycleOutcome& o, const LoadStatistics& vertical, const Case& c) {
  Metrics m;
  m.vertical = vertical;
  m.steady_from = o.first_voyage.counted_from, m.steady_to = o.first_voyage.counted_to;
  m.channel_width = o.channel_width, m.channel_width_over_beam = o.channel_width / c.bow.B;
  m.crushed_volume = o.run.process.ice.dust, m.broken_volume = o.run.process.ice.volume;
  m.floes = static_cast<int>(o.run.process.ice.floes.size());
  return m;
}

// What the voyages have in common and what they say together.
class Voyages {
 public:
  Voyages(const Case& c, const QuadMesh& hull, const cycle::BreakingRule& rule)
      : c_(c), hull_(hull), rule_(rule), ice_(cycle_ice(c)) {}

  CycleOutcome run() {
    for (int n = 0; n < c_.cycle.voyages && o_.reason.empty(); ++n) sail(n);
    if (!o_.reason.empty()) return std::move(o_);
    submerge();
    average();
    return std::move(o_);
  }

 private:
  void sail(int n) {
    cycle::Voyage voyage = cycle_voyage(c_);
    voyage.seed = c_.cycle.seed + static_cast<std::uint64_t>(n);
    voyage.keep_shapes = n == 0;
    VoyageResult v = cycle::sail(hull_, ice_, rule_, voyage);
    o_.reason = v.reason;
    if (!v.reason.empty()) return;
    const Loads loads = sampled(v, false);
    resistance_.push_back(series_statistics(loads.resistance));
    vertical_.push_back(series_statistics(loads.vertical));
    means_.push_back(resistance_.back().mean);
    add(v.work);
    for (const Piece& p : v.pieces) length_ += p.radius, width_ += p.width, ++o_.pieces;
    for (double w : v.channel) channel_ += w, ++stations_;
    if (n == 0) o_.first_voyage = std::move(v);
  }
  void add(const cycle::Work& w) {
    work_.crushing += w.crushing, work_.bending += w.bending, work_.friction += w.friction,
        work_.total += w.total;
  }

  void submerge() {
    if (!c_.cycle.submersion) return;
    if (c_.cycle.submersion_by_hull) {
      o_.under_hull = cycle::submersion(hull_, ice_, c_.V, c_.bow.L);
      o_.submersion = o_.under_hull.potential + o_.under_hull.friction;
      o_.water = o_.under_hull.drag;
      return;
    }
    const LindqvistResult formula = lindqvist(lindqvist_inputs(c_));
    if (!formula.valid) o_.reason = "submersion by Lindqvist's formula: " + formula.reason;
    o_.submersion = formula.total - formula.breaking;
  }

  // A voyage may fall into a pattern of its own that its record does not know of: with few voyages their
  // scatter counts where the records' intervals make it unlikely, 1 in 20.
  bool scatter_counts() const {
    const double n = static_cast<double>(means_.size());
    if (means_.size() < 2 || means_.size() >= enough_voyages) return means_.size() >= enough_voyages;
    double mean = 0.0, square = 0.0;
    for (double m : means_) mean += m / n;
    for (double m : means_) square += (m - mean) * (m - mean);
    const double of_records = std::pow(o_.series * std::sqrt(n) / 1.96, 2);
    return square > of_records * boost::math::quantile(boost::math::chi_squared(n - 1.0), 0.95);
  }

  void average() {
    if (!o_.reason.empty()) return;
    const double under = o_.submersion + o_.water;
    LoadStatistics all = pooled(resistance_, under);
    o_.mean = all.mean, o_.series = all.ci95;
    o_.voyages = interval_of_repeats(means_);
    o_.ci95 = scatter_counts() ? std::max(o_.series, o_.voyages) : o_.series;
    all.ci95 = o_.ci95;
    const double breaking = o_.mean - under, total = work_.total > 0.0 ? work_.total : 1.0;
    o_.crushing = breaking * work_.crushing / total;
    o_.bending = breaking * work_.bending / total;
    o_.friction = breaking * work_.friction / total;
    const double nan = std::numeric_limits<double>::quiet_NaN();
    o_.breaking_length = o_.pieces > 0 ? length_ / o_.pieces : nan;
    o_.contact_width = o_.pieces > 0 ? width_ / o_.pieces : nan;
    o_.channel_width = stations_ > 0 ? channel_ / stations_ : nan;
    o_.run.status = RunStatus::ok;
    o_.run.history = history_of(o_.first_voyage, c_.V, under);
    o_.run.process = process_of(o_, c_);
    o_.run.metrics = metrics_of(o_, pooled(vertical_, 0.0), c_);
    o_.run.metrics.resistance = all;
  }

  const Case& c_;
  const QuadMesh& hull_;
  const cycle::BreakingRule& rule_;
  cycle::Ice ice_;
  CycleOutcome o_;
  std::vector<LoadStatistics> resistance_, vertical_;
  std::vector<double> means_;
  cycle::Work work_;
  double length_ = 0.0, width_ = 0.0, channel_ = 0.0;
  int stations_ = 0;
};

Json number(double value) {
  return std::isfinite(value) ? Json(value) : Json(nullptr);
}

const char* name_of(cycle::Breaking rule) {
  if (rule == cycle::Breaking::plate) return "plate";
  return rule == cycle::Breaking::calibrated ? "calibrated" : "literature";
}

}  // namespace

cycle::Ice cycle_ice(const Case& c) {
  cycle::Ice ice;
  ice.h = c.ice.h, ice.rho = c.ice.rho, ice.E = c.ice.E, ice.nu = c.ice.nu;
  ice.sigma_f = c.flexural_strength, ice.p_c = c.cycle.crushing_pressure;
  ice.friction = c.numerics.friction, ice.rho_w = c.water.rho;
  return ice;
}

cycle::Voyage cycle_voyage(const Case& c) {
  cycle::Voyage v;
  v.speed = c.V, v.length = c.cycle.voyage, v.scatter = c.cycle.scatter, v.seed = c.cycle.seed;
  v.symmetric = c.cycle.symmetric, v.step_h = c.cycle.step, v.raster_h = c.cycle.raster;
  return v;
}

CycleOutcome run_cycle(const Case& c, const QuadMesh& hull, const cycle::BreakingRule& rule) {
  const auto begin = std::chrono::steady_clock::now();
  CycleOutcome outcome = Voyages(c, hull, rule).run();
  outcome.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  return outcome;
}

namespace {

constexpr int short_voyages = 12;  // t is 2.2

// Mean resistance between two advances [N].
double mean_between(const VoyageResult& v, double from, double to) {
  double sum = 0.0;
  int n = 0;
  for (const Record& r : v.records) {
    if (r.advance <= from || r.advance > to) continue;
    sum -= r.force.x();
    ++n;
  }
  return n > 0 ? sum / n : std::numeric_limits<double>::quiet_NaN();
}

// Mean part of the hull's length that has ice under it. A window has none beyond its end.
double covered(const Case& c) {
  const double astern = c.sheet.window_ahead > 0.0 ? c.sheet.length - c.sheet.window_ahead : c.bow.L,
               longest = std::min(astern, c.bow.L);
  constexpr int parts = 100;
  double sum = 0.0;
  for (int n = 0; n < parts; ++n) {
    const double advance = c.steady_from + (n + 0.5) / parts * (c.advance - c.steady_from);
    sum += std::min(advance, longest) / c.bow.L / parts;
  }
  return sum;
}

}  // namespace

SameWay run_same_way(const Case& c, const QuadMesh& hull, const cycle::BreakingRule& rule,
                     double under_hull) {
  const double under = under_hull * covered(c);
  std::vector<double> means;
  for (int n = 0; n < short_voyages; ++n) {
    cycle::Voyage voyage = cycle_voyage(c);
    voyage.seed = c.cycle.seed + static_cast<std::uint64_t>(n);
    voyage.length = c.advance;  // and the bow's length: longer than the way
    means.push_back(under +
                    mean_between(cycle::sail(hull, cycle_ice(c), rule, voyage), c.steady_from, c.advance));
  }
  SameWay way{c.steady_from, c.advance, 0.0, interval_of_repeats(means)};
  for (double mean : means) way.mean += mean / short_voyages;
  return way;
}

Json same_way_json(const SameWay& way) {
  return {{"from_m", number(way.from)},
          {"to_m", number(way.to)},
          {"mean_load_N", number(way.mean)},
          {"ci95_N", number(way.ci95)}};
}

Json cycle_metrics_json(const CycleOutcome& outcome) {
  Json json = metrics_json(outcome.run, 1.0);
  for (const char* of_bonds : {"broken_bonds", "bonds", "mean_damage"}) json[of_bonds] = nullptr;
  json["resolution_bias"] = {
      {"known", true},
      {"relative", 0.0},
      {"ci95", 0.03},
      {"sentence", "step and raster of the breaking cycle: within 3 % (docs/cycle.md)"}};
  return json;
}

Json cycle_json(const CycleOutcome& o, const Case& c, const cycle::BreakingRule& rule) {
  Json json = {{"reason", o.reason}, {"breaking", name_of(rule.type)}};
  if (!o.reason.empty()) return json;
  const double l = cycle_ice(c).characteristic_length();
  json.update({{"mean_load_N", number(o.mean)},
               {"mean_load_ci95_N", number(o.ci95)},
               {"ci95_series_N", number(o.series)},
               {"ci95_voyages_N", number(o.voyages)},
               {"crushing_N", number(o.crushing)},
               {"bending_N", number(o.bending)},
               {"friction_N", number(o.friction)},
               {"submersion_N", number(o.submersion)},
               {"water_N", number(o.water)},
               {"breaking_length_m", number(o.breaking_length)},
               {"breaking_length_over_characteristic", number(o.breaking_length / l)},
               {"contact_width_m", number(o.contact_width)},
               {"channel_width_m", number(o.channel_width)},
               {"submersion_depth_m", number(o.under_hull.mean_depth)},
               {"under_bottom_share", number(o.under_hull.under_bottom)},
               {"voyages", c.cycle.voyages},
               {"voyage_m", number(c.cycle.voyage)},
               {"pieces", o.pieces},
               {"wall_s", number(o.seconds)}});
  return json;
}

}  // namespace icebow
