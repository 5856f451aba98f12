#include "solver/lattice/stability.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace icebow {
namespace {

// Far enough apart that one edge's correction (2 reach deep) does not see the other edge's.
constexpr int side = 4 * reach + 2;
constexpr int lanczos_steps = 60;

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

}  // namespace

double stable_time_step(const Stencil& stencil, const Material& material, double dx, double rho,
                        bool surface_correction) {
  const SmallSheet sheet(stencil, material, dx, rho, surface_correction);
  std::mt19937 random(1);  // any start that holds every mode
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  Eigen::VectorXd q =
      Eigen::VectorXd::NullaryExpr(sheet.size(), [&] { return uniform(random); }).normalized();
  Eigen::VectorXd previous = Eigen::VectorXd::Zero(sheet.size());
  Eigen::VectorXd diagonal(lanczos_steps), beside(lanczos_steps);
  double beta = 0.0;
  for (int step = 0; step < lanczos_steps; ++step) {
    Eigen::VectorXd w = sheet.stiffness(q) - beta * previous;
    diagonal[step] = q.dot(w);
    w -= diagonal[step] * q;
    beta = beside[step] = w.norm();
    previous = q;
    q = w / beta;
  }
  Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> tridiagonal;
  tridiagonal.computeFromTridiagonal(diagonal, beside.head(lanczos_steps - 1), Eigen::EigenvaluesOnly);
  return 2.0 / std::sqrt(tridiagonal.eigenvalues().maxCoeff());
}

double with_contact(double dt_limit, double stiffness, double mass) {
  return 2.0 / std::sqrt(4.0 / (dt_limit * dt_limit) + stiffness / mass);
}

}  // namespace icebow
