#include "solver/lattice/stability.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <random>
#include <utility>
#include <vector>

namespace icebow {
namespace {

// Far enough apart that one edge's correction (2 reach deep) does not see the other edge's.
constexpr int side = 4 * reach + 2;

// Linearised bond forces of a free side x side x nz sheet: acceleration = -K displacement, eq. (14).
class SmallSheet {
 public:
  SmallSheet(const Stencil& stencil, const Material& m, double dx, double rho, bool surface_correction) {
    const int nz = static_cast<int>(stencil.family.size());
    n_ = side * side * nz;
    const double V = dx * dx * dx;
    const auto id = [&](int i, int j, int k) { return (j * nz + k) * side + i; };
    const auto factors = [&](int i, int j, int k) {
      if (!surface_correction) return SurfaceFactors{{1.0, 1.0, 1.0}, {1.0, 1.0, 1.0}};
      const auto near = [](int distance) { return std::min(distance, reach); };
      return surface_factors({near(i), near(side - 1 - i), near(j), near(side - 1 - j), k}, stencil, m, dx);
    };
    std::vector<SurfaceFactors> g(n_);
    for (int j = 0; j < side; ++j)
      for (int k = 0; k < nz; ++k)
        for (int i = 0; i < side; ++i) g[id(i, j, k)] = factors(i, j, k);

    for (int j = 0; j < side; ++j) {
      for (int k = 0; k < nz; ++k) {
        for (int i = 0; i < side; ++i) {
          for (const Offset& o : stencil.family[k]) {
            const int i2 = i + o.di, j2 = j + o.dj;
            if (i2 < 0 || i2 >= side || j2 < 0 || j2 >= side) continue;
            Bond b;
            b.from = id(i, j, k);
            b.to = id(i2, j2, k + o.dk);
            const double G_d = bond_factor(g[b.from].dilatation, g[b.to].dilatation, o, dx);
            const double G_b = bond_factor(g[b.from].distortion, g[b.to].distortion, o, dx);
            const double w = V * o.volume_factor, L = o.length;
            b.normal = Eigen::Vector3d(o.di, o.dj, o.dk) * (dx / L);
            b.dilatation = m.d * m.delta * w * G_d / L;
            b.pressure = 2.0 * m.delta * m.d * m.a * G_d * w / (L * rho);
            b.distortion = 4.0 * m.delta * m.b * G_b * w / (L * rho);
            bonds_.push_back(b);
          }
        }
      }
    }
  }

  int size() const { return 3 * n_; }

  Eigen::VectorXd stiffness(const Eigen::VectorXd& u) const {
    Eigen::VectorXd theta = Eigen::VectorXd::Zero(n_), force = Eigen::VectorXd::Zero(3 * n_);
    for (const Bond& b : bonds_) theta[b.from] += b.dilatation * elongation(b, u);
    for (const Bond& b : bonds_) {
      const double f = b.pressure * (theta[b.from] + theta[b.to]) + b.distortion * elongation(b, u);
      force.segment<3>(3 * b.from) -= f * b.normal;
    }
    return force;
  }

 private:
  struct Bond {
    int from, to;
    Eigen::Vector3d normal;
    double dilatation, pressure, distortion;
  };

  static double elongation(const Bond& b, const Eigen::VectorXd& u) {
    return b.normal.dot(u.segment<3>(3 * b.to) - u.segment<3>(3 * b.from));
  }

  int n_ = 0;
  std::vector<Bond> bonds_;
};

// Largest eigenvalue of a symmetric operator, by Lanczos iterations. The estimate comes from below, and a
// limit from an estimate that is too low would be a step that is too large: so its residual is looked at.
class LargestEigenvalue {
 public:
  explicit LargestEigenvalue(const SmallSheet& sheet) : sheet_(sheet) {
    std::mt19937 random(1);  // any start that holds every mode
    std::uniform_real_distribution<double> uniform(-1.0, 1.0);
    q_ = Eigen::VectorXd::NullaryExpr(sheet.size(), [&] { return uniform(random); }).normalized();
    previous_ = Eigen::VectorXd::Zero(sheet.size());
  }

  // Some eigenvalue is nearer to the estimate than its residual |A x - estimate x|; the estimate's own error
  // is of the order of the residual squared. Where the residual stays large, it is added.
  double find() {
    while (true) {
      for (int n = 0; n < steps_at_once; ++n) step();
      const auto [estimate, residual] = largest_so_far();
      if (residual <= small_residual * estimate) return estimate;
      if (diagonal_.size() >= most_steps || beside_.back() == 0.0) return estimate + residual;
    }
  }

 private:
  static constexpr int steps_at_once = 60;
  static constexpr std::size_t most_steps = 600;
  static constexpr double small_residual =
      1e-2;  // an error of some 1e-4 of the eigenvalue, 5e-5 of the time step

  void step() {
    Eigen::VectorXd w = sheet_.stiffness(q_) - (beside_.empty() ? 0.0 : beside_.back()) * previous_;
    diagonal_.push_back(q_.dot(w));
    w -= diagonal_.back() * q_;
    beside_.push_back(w.norm());
    previous_ = q_;
    q_ = w / beside_.back();
  }

  // The tridiagonal matrix's largest eigenvalue, and what the last entry of its eigenvector leaves
  // over.
  std::pair<double, double> largest_so_far() const {
    const auto n = static_cast<Eigen::Index>(diagonal_.size());
    Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> tridiagonal;
    tridiagonal.computeFromTridiagonal(Eigen::Map<const Eigen::VectorXd>(diagonal_.data(), n),
                                       Eigen::Map<const Eigen::VectorXd>(beside_.data(), n - 1));
    return {tridiagonal.eigenvalues()[n - 1],
            beside_.back() * std::abs(tridiagonal.eigenvectors()(n - 1, n - 1))};
  }

  const SmallSheet& sheet_;
  Eigen::VectorXd q_, previous_;
  std::vector<double> diagonal_, beside_;
};

}  // namespace

double stable_time_step(const Stencil& stencil, const Material& material, double dx, double rho,
                        bool surface_correction) {
  const SmallSheet sheet(stencil, material, dx, rho, surface_correction);
  return 2.0 / std::sqrt(LargestEigenvalue(sheet).find());
}

double with_contact(double dt_limit, double stiffness, double mass) {
  return 2.0 / std::sqrt(4.0 / (dt_limit * dt_limit) + stiffness / mass);
}

}  // namespace icebow
