#include "solver/watch/detached_ice.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "base/errors.h"
#include "base/whole_number.h"
#include "geometry/second_moments.h"

namespace icebow {
namespace {

constexpr std::size_t floe_values = 6, station_values = 2;

// Number of a particle: it stays the same however far the window moves.
std::int64_t key(const Lattice& lattice, int i, int j, int k) {
  return (std::int64_t(lattice.first + i) * lattice.ny + j) * lattice.nz + k;
}

template <class Visit>
void for_each_particle(const Lattice& lattice, int end, Visit visit) {
  for (int j = 0; j < lattice.ny; ++j) {
    for (int k = 0; k < lattice.nz; ++k) {
      for (int i = 0; i < end; ++i) visit(i, j, k);
    }
  }
}

// One floe while its particles are gone through.
struct Outline {
  std::int64_t particles = 0;
  std::set<std::pair<int, int>> columns;

  Floe floe(const Lattice& lattice) const {
    SecondMoments moments;
    for (const auto& [i, j] : columns) moments.add(lattice.x(i), lattice.y(j));
    const MainAxes axes = moments.axes(lattice.dx);
    const double in_columns = double(columns.size()) * lattice.nz;
    return {double(particles) * lattice.dx * lattice.dx / lattice.nz,
            axes.length,
            axes.width,
            double(particles) / in_columns,
            moments.x(),
            moments.y()};
  }
};

}  // namespace

bool DetachedIceCount::counted(const Lattice& lattice, int i, int j, int k) const {
  return !counted_.empty() && counted_.count(key(lattice, i, j, k)) > 0;
}

void DetachedIceCount::remember(const Lattice& lattice, int i, int j, int k) {
  counted_.insert(key(lattice, i, j, k));
}

void DetachedIceCount::add(const SheetState& state, int end, double x_from, double x_to) {
  add_volumes(state, end);
  add_floes(state, end);
  for (int i = 0; i < end; ++i) {
    const double x = state.lattice.x(i);
    if (x >= x_from && x <= x_to) total_.channel.push_back({x, channel_width(state, i)});
  }
}

// What is left of a floe after the window was cut through it is still a floe, however small.
void DetachedIceCount::add_volumes(const SheetState& state, int end) {
  const Lattice& lattice = state.lattice;
  std::int64_t detached = 0, in_floes = 0, dust = 0;
  for_each_particle(lattice, end, [&](int i, int j, int k) {
    const std::int64_t id = lattice.id(i, j, k);
    if (state.piece[id] == 0) return;
    ++detached;
    in_floes += state.piece[id] > 0 || counted(lattice, i, j, k);
    dust += state.damage[id] >= 1.0f;
  });
  total_.volume += detached * lattice.particle_volume();
  total_.in_floes += in_floes * lattice.particle_volume();
  total_.dust += dust * lattice.particle_volume();
}

void DetachedIceCount::add_floes(const SheetState& state, int end) {
  const Lattice& lattice = state.lattice;
  std::vector<char> reaches(state.floes + 1, 0), known(state.floes + 1, 0);
  for_each_particle(lattice, lattice.nx, [&](int i, int j, int k) {
    const std::int32_t piece = state.piece[lattice.id(i, j, k)];
    if (piece <= 0) return;
    if (i < end) reaches[piece] = 1;
    if (counted(lattice, i, j, k)) known[piece] = 1;
  });
  std::vector<Outline> outlines(state.floes + 1);
  for_each_particle(lattice, lattice.nx, [&](int i, int j, int k) {
    const std::int32_t piece = state.piece[lattice.id(i, j, k)];
    if (piece <= 0 || !reaches[piece]) return;
    ++outlines[piece].particles;
    outlines[piece].columns.insert({i, j});
    if (i >= end) remember(lattice, i, j, k);
  });
  for (std::int32_t piece = 1; piece <= state.floes; ++piece) {
    if (reaches[piece] && !known[piece]) total_.floes.push_back(outlines[piece].floe(lattice));
  }
}

std::vector<double> DetachedIceCount::record() const {
  std::vector<double> r = {total_.volume, total_.in_floes, total_.dust, double(total_.floes.size()),
                           double(total_.channel.size())};
  for (const Floe& f : total_.floes) r.insert(r.end(), {f.area, f.length, f.width, f.through, f.x, f.y});
  for (const ChannelStation& s : total_.channel) r.insert(r.end(), {s.x, s.width});
  for (const std::int64_t particle : counted_) r.push_back(double(particle));
  return r;
}

void DetachedIceCount::restore(const std::vector<double>& r) {
  const std::string trouble = "its count of broken ice is not whole";
  *this = {};
  if (r.size() < 5) throw RuntimeError(trouble);
  total_.volume = r[0];
  total_.in_floes = r[1];
  total_.dust = r[2];
  const auto floes = static_cast<std::size_t>(whole_number(r[3], 0.0, double(r.size()), trouble));
  const auto stations = static_cast<std::size_t>(whole_number(r[4], 0.0, double(r.size()), trouble));
  if (r.size() < 5 + floes * floe_values + stations * station_values) throw RuntimeError(trouble);
  const double* p = r.data() + 5;
  for (std::size_t n = 0; n < floes; ++n, p += floe_values)
    total_.floes.push_back({p[0], p[1], p[2], p[3], p[4], p[5]});
  for (std::size_t n = 0; n < stations; ++n, p += station_values) total_.channel.push_back({p[0], p[1]});
  for (; p != r.data() + r.size(); ++p) counted_.insert(whole_number(*p, 0.0, most_whole, trouble));
}

}  // namespace icebow
