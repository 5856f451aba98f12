#include "solver/water/water_plane.h"

#include <fftw3.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace icebow {
namespace {

// The next number that has only the factors 2, 3 and 5.
int easy_to_transform(int n) {
  for (;; ++n) {
    int rest = n;
    for (const int factor : {2, 3, 5})
      while (rest % factor == 0) rest /= factor;
    if (rest == 1) return n;
  }
}

// Integral of 1/r over the rectangle between the origin and (x, y); odd in both.
double inverse_distance(double x, double y) {
  double sum = 0.0;
  if (x != 0.0) sum += x * std::asinh(y / std::abs(x));
  if (y != 0.0) sum += y * std::asinh(x / std::abs(y));
  return sum;
}

// Integral of 1/r over a unit square whose centre is (x, y) from the origin.
double inverse_distance_of_cell(double x, double y) {
  return inverse_distance(x + 0.5, y + 0.5) - inverse_distance(x - 0.5, y + 0.5) -
         inverse_distance(x + 0.5, y - 0.5) + inverse_distance(x - 0.5, y - 0.5);
}

struct FreeMemory {
  void operator()(float* p) const { fftwf_free(p); }
};
using Buffer = std::unique_ptr<float[], FreeMemory>;

Buffer buffer(std::size_t size) {
  return Buffer(fftwf_alloc_real(size));
}

using Plan = std::unique_ptr<std::remove_pointer_t<fftwf_plan>, decltype(&fftwf_destroy_plan)>;

double dot(const std::vector<float>& a, const std::vector<float>& b) {
  return std::inner_product(a.begin(), a.end(), b.begin(), 0.0);
}

}  // namespace

// Cells with as many empty ones beyond them, so that nothing comes round; of a mirrored plane both halves.
// The plans are estimates: they do not depend on timings, so are the same on every rank.
class WaterPlane::Transform {
 public:
  explicit Transform(const WaterGrid& grid)
      : grid_(grid),
        nx_(easy_to_transform(2 * grid.nx)),
        ny_(easy_to_transform(2 * grid.ny * (grid.mirrored ? 2 : 1))),
        cells_(buffer(std::size_t(nx_) * ny_)),
        waves_(buffer(2 * std::size_t(nx_) * waves_across())),
        forth_(fftwf_plan_dft_r2c_2d(nx_, ny_, cells_.get(), complex(), FFTW_ESTIMATE), &fftwf_destroy_plan),
        back_(fftwf_plan_dft_c2r_2d(nx_, ny_, complex(), cells_.get(), FFTW_ESTIMATE), &fftwf_destroy_plan) {}

  // Factor of each wave number that turns accelerations into forces, for transforms that are not normed.
  std::vector<float> inertia() {
    const double scale = grid_.density * std::pow(grid_.cell, 3) / (2.0 * M_PI);
    for (int i = 0; i < nx_; ++i) {
      for (int j = 0; j < ny_; ++j) {
        const double inverse = inverse_distance_of_cell(std::min(i, nx_ - i), std::min(j, ny_ - j));
        cells_[std::size_t(i) * ny_ + j] = static_cast<float>(scale * inverse);
      }
    }
    fftwf_execute(forth_.get());
    std::vector<float> factors(std::size_t(nx_) * waves_across());
    for (std::size_t n = 0; n < factors.size(); ++n) factors[n] = waves_[2 * n];  // it is even in x and y
    return factors;
  }
  double norm() const { return 1.0 / (double(nx_) * ny_); }

  void apply(const std::vector<float>& factors, const std::vector<float>& in, std::vector<float>& out) {
    std::fill_n(cells_.get(), std::size_t(nx_) * ny_, 0.0f);
    for (int i = 0; i < grid_.nx; ++i) {
      const float* const from = &in[std::size_t(i) * grid_.ny];
      if (grid_.mirrored) std::reverse_copy(from, from + grid_.ny, row(i) - grid_.ny);
      std::copy_n(from, grid_.ny, row(i));
    }
    fftwf_execute(forth_.get());
    for (std::size_t n = 0; n < factors.size(); ++n) {
      waves_[2 * n] *= factors[n];
      waves_[2 * n + 1] *= factors[n];
    }
    fftwf_execute(back_.get());
    for (int i = 0; i < grid_.nx; ++i) std::copy_n(row(i), grid_.ny, &out[std::size_t(i) * grid_.ny]);
  }

 private:
  int waves_across() const { return ny_ / 2 + 1; }
  fftwf_complex* complex() { return reinterpret_cast<fftwf_complex*>(waves_.get()); }
  float* row(int i) { return &cells_[std::size_t(i) * ny_ + (grid_.mirrored ? grid_.ny : 0)]; }

  WaterGrid grid_;
  int nx_, ny_;
  Buffer cells_, waves_;
  Plan forth_, back_;
};

WaterPlane::WaterPlane(const WaterGrid& grid, double mobility)
    : grid_(grid), mobility_(mobility), transform_(std::make_unique<Transform>(grid)) {
  inertia_ = transform_->inertia();
  const double norm = transform_->norm();
  for (float& factor : inertia_) {
    const double heavy = std::max(0.0, factor * mobility);
    resisted_.push_back(static_cast<float>(heavy / (1.0 + heavy) * norm));
    factor = static_cast<float>(factor * norm);
  }
}

WaterPlane::~WaterPlane() = default;

// With H the forces of accelerations and B the roots of the mobilities, the force P = H (a - B^2 P) is that
// of the accelerations B y, (1 + B H B) y = a / B: conjugate gradients, prepared by the solution for a plane
// that is equally mobile everywhere. In units in which the most mobile cell has the mobility 1.
std::vector<double> WaterPlane::resistance(const std::vector<double>& acceleration,
                                           const std::vector<double>& mobility) {
  constexpr double balanced = 1e-4;
  constexpr int most = 40;
  const std::size_t n = acceleration.size();
  std::vector<float> root(n), r(n), z(n), p(n), scaled(n), pushed(n), force(n, 0.0f);
  for (std::size_t c = 0; c < n; ++c) {
    root[c] = static_cast<float>(std::sqrt(mobility[c] / mobility_));
    r[c] = root[c] > 0.0f ? static_cast<float>(acceleration[c] / root[c]) : 0.0f;
  }
  const auto prepare = [&] {
    for (std::size_t c = 0; c < n; ++c) scaled[c] = root[c] * r[c];
    transform_->apply(resisted_, scaled, z);
    for (std::size_t c = 0; c < n; ++c) z[c] = r[c] - root[c] * z[c];
  };
  prepare();
  p = z;
  double rz = dot(r, z);
  const double enough = balanced * balanced * rz;
  for (iterations_ = 0; iterations_ < most && rz > enough; ++iterations_) {
    for (std::size_t c = 0; c < n; ++c) scaled[c] = root[c] * p[c];
    transform_->apply(inertia_, scaled, pushed);
    for (std::size_t c = 0; c < n; ++c)
      scaled[c] = p[c] + static_cast<float>(mobility_) * root[c] * pushed[c];
    const double step = rz / dot(p, scaled);
    for (std::size_t c = 0; c < n; ++c) {
      force[c] += static_cast<float>(step) * pushed[c];
      r[c] -= static_cast<float>(step) * scaled[c];
    }
    prepare();
    const double before = std::exchange(rz, dot(r, z));
    const auto kept = static_cast<float>(rz / before);
    for (std::size_t c = 0; c < n; ++c) p[c] = z[c] + kept * p[c];
  }
  return {force.begin(), force.end()};
}

}  // namespace icebow
