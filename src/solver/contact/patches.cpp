#include "solver/contact/patches.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "solver/ice/near_cracks.h"

namespace icebow {
namespace {

constexpr int of_patch = 3;  // numbers before those of its particles: column, block, whether it is cracked
// Of what is not there: near to nothing, not even to itself.
constexpr float nowhere = std::numeric_limits<float>::infinity();

}  // namespace

Patches::Patches(const Communicator& comm, const IceSheet& sheet, double within) : layers_(sheet.layout.nz) {
  const std::vector<double> mine = own_numbers(comm, sheet);
  const std::vector<double> sizes = comm.gather_everywhere({double(own_)}),
                            all = comm.gather_everywhere(mine);
  first_ = particles() * static_cast<int>(std::accumulate(sizes.begin(), sizes.begin() + comm.rank(), 0.0));
  const std::size_t size = of_patch + std::size_t(3) * particles();
  places_.reserve(all.size());
  for (std::size_t n = 0; n + size <= all.size(); n += size) add(sheet.lattice, &all[n]);
  if (sheet.lattice.half) add_images(within);
}

// Of the own patches: of_patch numbers, and the particles' places as places() has them.
std::vector<double> Patches::own_numbers(const Communicator& comm, const IceSheet& sheet) {
  const Layout& layout = sheet.layout;
  const Lattice& lattice = sheet.lattice;
  const std::vector<Nearness> near = find_near_cracks(comm, sheet);
  std::vector<double> numbers;
  for (std::size_t n = 0; n < near.size(); ++n) {
    if (near[n] == far_from_cracks) continue;
    ++own_;
    const int jl = static_cast<int>(n) / layout.blocks, b = static_cast<int>(n) % layout.blocks;
    const int first = layout.i0 + b * block;
    numbers.insert(numbers.end(),
                   {double(layout.j0 + jl), double(first / block), double(near[n] == at_cracks)});
    for (int k = 0; k < layers_; ++k) {
      const std::size_t row = layout.row(jl, k) + std::size_t(b) * block;
      for (int l = 0; l < block; ++l) numbers.push_back(lattice.x(first + l) + sheet.u[0][row + l]);
      for (int l = 0; l < block; ++l) numbers.push_back(lattice.y(layout.j0 + jl) + sheet.u[1][row + l]);
      for (int l = 0; l < block; ++l) numbers.push_back(lattice.z(k) + sheet.u[2][row + l]);
    }
  }
  return numbers;
}

void Patches::add(const Lattice& lattice, const double* numbers) {
  Patch p{};
  p.j = static_cast<int>(numbers[0]);
  p.b = static_cast<int>(numbers[1]);
  p.cracked = numbers[2] != 0.0;
  p.number = static_cast<int>(patches_.size()) * particles();
  for (int n = 0; n < 3 * particles(); ++n) {
    const bool is_there = p.b * block + n % block < lattice.nx;
    places_.push_back(is_there ? static_cast<float>(numbers[of_patch + n]) : nowhere);
  }
  patches_.push_back(p);
  find_box(patches_.back());
}

void Patches::add_images(double within) {
  const std::size_t originals = patches_.size(), size = std::size_t(3) * particles();
  for (std::size_t n = 0; n < originals; ++n) {
    Patch image = patches_[n];
    if (!(image.lower[1] < within)) continue;
    image.j = -1 - image.j;
    image.image = true;
    places_.resize(places_.size() + size);
    float* const to = &places_[places_.size() - size];
    std::copy_n(&places_[n * size], size, to);
    for (int row = 0; row < layers_; ++row)
      for (float* y = to + (3 * row + 1) * block; y != to + (3 * row + 2) * block; ++y)
        if (*y != nowhere) *y = -*y;
    patches_.push_back(image);
    find_box(patches_.back());
  }
}

// Without what has been thrown to no number; empty without particles.
void Patches::find_box(Patch& patch) const {
  const float* const from = places(patch);
  for (int c = 0; c < 3; ++c) {
    float lower = std::numeric_limits<float>::max(), upper = -lower;
    for (int row = 0; row < layers_; ++row) {
      for (const float* x = from + (3 * row + c) * block; x != from + (3 * row + c + 1) * block; ++x) {
        if (*x == nowhere) continue;
        lower = std::min(lower, *x);
        upper = std::max(upper, *x);
      }
    }
    patch.lower[c] = lower;
    patch.upper[c] = upper;
  }
}

}  // namespace icebow
