#include "study/evaluate/process_json.h"

#include <algorithm>
#include <cmath>

#include "base/json_fields.h"
#include "base/units.h"

namespace icebow {
namespace {

constexpr std::size_t most_listed = 60;
constexpr int stations = 8;
constexpr double whole_thickness = 0.9;  // of a floe's columns, to count as broken through

// Mean, median, smallest and largest; nulls where there are none.
Json spread_json(std::vector<double> values) {
  if (values.empty()) return {{"mean", nullptr}, {"median", nullptr}, {"min", nullptr}, {"max", nullptr}};
  std::sort(values.begin(), values.end());
  double sum = 0.0;
  for (double v : values) sum += v;
  const std::size_t n = values.size();
  return {{"mean", finite_or_null(sum / double(n))},
          {"median", finite_or_null(0.5 * (values[(n - 1) / 2] + values[n / 2]))},
          {"min", finite_or_null(values.front())},
          {"max", finite_or_null(values.back())}};
}

// Which of a list of so many are the largest, in the list's own order.
template <class T, class Size>
std::vector<std::size_t> largest(const std::vector<T>& list, Size size) {
  std::vector<std::size_t> order(list.size());
  for (std::size_t n = 0; n < order.size(); ++n) order[n] = n;
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return size(list[a]) > size(list[b]); });
  order.resize(std::min(order.size(), most_listed));
  std::sort(order.begin(), order.end());
  return order;
}

Json cracks_json(const Cracks& cracks) {
  Json json = {{"isolated_columns", cracks.isolated}};
  for (int kind = 0; kind < crack_kinds; ++kind) {
    const auto count = std::count_if(cracks.list.begin(), cracks.list.end(),
                                     [&](const Crack& c) { return static_cast<int>(c.kind) == kind; });
    json[to_string(static_cast<CrackKind>(kind))] = {{"count", count}, {"columns", cracks.columns[kind]}};
  }
  json["list"] = Json::array();
  for (const std::size_t n : largest(cracks.list, [](const Crack& c) { return c.length; })) {
    const Crack& c = cracks.list[n];
    json["list"].push_back({{"order", n + 1},
                            {"kind", to_string(c.kind)},
                            {"opened_m", finite_or_null(c.opened)},
                            {"x_m", finite_or_null(c.x)},
                            {"y_m", finite_or_null(c.y)},
                            {"length_m", finite_or_null(c.length)},
                            {"direction_deg", finite_or_null(degrees(c.direction))},
                            {"from_hull_m", finite_or_null(c.from_hull)}});
  }
  return json;
}

Json breaking_length_json(const BreakingLength& b, double characteristic) {
  return {{"cracks", b.cracks},
          {"normal_m", finite_or_null(b.normal)},
          {"normal_std_m", finite_or_null(b.deviation)},
          {"normal_q10_m", finite_or_null(b.tenth)},
          {"normal_median_m", finite_or_null(b.median)},
          {"normal_q90_m", finite_or_null(b.nine_tenths)},
          {"along_course_m", finite_or_null(b.along)},
          {"normal_over_characteristic", finite_or_null(b.normal / characteristic)},
          {"along_course_over_characteristic", finite_or_null(b.along / characteristic)}};
}

Json detached_json(const DetachedIce& ice) {
  return {{"volume_m3", finite_or_null(ice.volume)},
          {"crushed_volume_m3", finite_or_null(ice.crushed())},
          {"in_floes_share", finite_or_null(ice.in_floes / ice.volume)},
          {"dust_share", finite_or_null(ice.dust / ice.volume)}};
}

Json floes_json(const std::vector<Floe>& floes) {
  std::vector<double> areas, lengths, widths;
  int whole = 0;
  for (const Floe& f : floes) {
    areas.push_back(f.area);
    lengths.push_back(f.length);
    widths.push_back(f.width);
    whole += f.through >= whole_thickness;
  }
  Json json = {{"count", floes.size()},          {"through_thickness", whole},
               {"area_m2", spread_json(areas)},  {"length_m", spread_json(lengths)},
               {"width_m", spread_json(widths)}, {"list", Json::array()}};
  for (const std::size_t n : largest(floes, [](const Floe& f) { return f.area; })) {
    const Floe& f = floes[n];
    json["list"].push_back({{"area_m2", finite_or_null(f.area)},
                            {"length_m", finite_or_null(f.length)},
                            {"width_m", finite_or_null(f.width)},
                            {"through", finite_or_null(f.through)},
                            {"x_m", finite_or_null(f.x)},
                            {"y_m", finite_or_null(f.y)}});
  }
  return json;
}

Json load_cycle_json(const LoadCycle& load, double characteristic) {
  return {{"cycles", load.clear ? "clear" : "overlapping"},
          {"period_s", finite_or_null(load.period)},
          {"advance_m", finite_or_null(load.advance)},
          {"advance_over_characteristic", finite_or_null(load.advance / characteristic)},
          {"autocorrelation", finite_or_null(load.height)},
          {"significant_above", finite_or_null(load.significant_above)},
          {"periods_in_record", finite_or_null(load.cycles)},
          {"peak_over_mean", finite_or_null(load.peak_over_mean)},
          {"std_over_mean", finite_or_null(load.deviation_over_mean)},
          {"without_contact_share", finite_or_null(load.without_contact)}};
}

// Equal parts of the channel, from the stem aft.
Json channel_json(const BreakingProcess& p) {
  const std::vector<ChannelStation>& channel = p.ice.channel;
  std::vector<double> widths;
  double square = 0.0;
  for (const ChannelStation& s : channel) widths.push_back(s.width);
  Json json = spread_json(widths);
  for (double w : widths) square += std::pow(w - json["mean"].get<double>(), 2);
  const double n = double(widths.size());
  Json result = {{"width_m", json},
                 {"width_std_m", n > 1 ? finite_or_null(std::sqrt(square / (n - 1.0))) : Json(nullptr)},
                 {"stations", Json::array()}};
  const std::size_t count = channel.size(), parts = std::min<std::size_t>(stations, count);
  for (std::size_t part = parts; part-- > 0;) {
    double width = 0.0, x = 0.0;
    const std::size_t first = part * count / parts, last = (part + 1) * count / parts;
    for (std::size_t i = first; i < last; ++i) {
      width += channel[i].width / double(last - first);
      x += channel[i].x / double(last - first);
    }
    result["stations"].push_back(
        {{"astern_m", finite_or_null(p.stem_x - x)}, {"width_m", finite_or_null(width)}});
  }
  return result;
}

Json energy_json(const EnergyShares& e) {
  return {{"hull_work_J", finite_or_null(e.hull_work)},
          {"fracture", finite_or_null(e.fracture)},
          {"elastic", finite_or_null(e.elastic)},
          {"kinetic", finite_or_null(e.kinetic)},
          {"potential", finite_or_null(e.potential)},
          {"contact_loss", finite_or_null(e.contact_loss)},
          {"water", finite_or_null(e.water)},
          {"floe_contact", finite_or_null(e.floe_contact)},
          {"absorbed", finite_or_null(e.absorbed)},
          {"left_astern", finite_or_null(e.left_astern)},
          {"unexplained", finite_or_null(e.unexplained)}};
}

}  // namespace

Json process_json(const BreakingProcess& p) {
  const double l = p.characteristic_length;
  return {{"thickness_m", finite_or_null(p.thickness)},
          {"characteristic_length_m", finite_or_null(l)},
          {"cracks", cracks_json(p.cracks)},
          {"breaking_length", breaking_length_json(p.breaking_length, l)},
          {"detached", detached_json(p.ice)},
          {"floes", floes_json(p.ice.floes)},
          {"load_cycle", load_cycle_json(p.load, l)},
          {"channel", channel_json(p)},
          {"energy", energy_json(p.energy)}};
}

}  // namespace icebow
