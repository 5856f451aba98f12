// The thin plate by elements against closed forms: what the corner, edge and strip cases lean on. See
// docs/verification.md.
#include "tests/support/plate_elements.h"

#include <catch2/catch.hpp>
#include <cmath>

#include "base/units.h"
#include "solver/model/plate_on_water.h"

using namespace icebow;

namespace {

// Of ice of 1 m and 1.3 GPa at a scale of 25.
ThinPlate ice_plate(double nu = 0.33) {
  return thin_plate(52e6, nu, 0.04, 826.6, 1000.0, 0.16);
}

struct Found {
  double stress = 0.0, at = 0.0;
};

// The largest along the lines x = y (`across` 1) or along the first line of y (0).
Found largest_upper(const PlateElements& plate, const Eigen::VectorXd& u, int across) {
  Found found;
  for (int n = 0; n < plate.nx(); ++n) {
    const double stress = plate.upper_face(u, n, across * n).largest();
    if (stress > found.stress) found = {stress, plate.mesh().x[n]};
  }
  return found;
}

}  // namespace

TEST_CASE("plate elements: a plate afloat goes down as the endless one, under the load and beside it") {
  const ThinPlate law = ice_plate();
  const double l = law.characteristic_length(), a = 0.5 * l;  // a quarter of the plate
  const std::vector<double> lines = graded_lines(0.1 * l, 2.0 * l, 7.0 * l);
  const PlateElements plate(
      law, {lines, lines, PlateEdge::mirror, PlateEdge::free, PlateEdge::mirror, PlateEdge::free});
  const Eigen::VectorXd u = plate.settle(0.25 * plate.pressed({0.0, a, 0.0, a}));
  // The disc with the square's second moment: a/sqrt(3) in each direction against r/2.
  const double radius = 2.0 * a / std::sqrt(3.0);
  const PlateOnWater theory{law.bending, 1e12, law.foundation};
  for (const int n : {0, 10, 20}) {
    const double found = -u[plate.unknown(n, 0)],
                 expected = deflection_under_disc(theory, radius, plate.mesh().x[n]);
    INFO("at " << plate.mesh().x[n] / l << " l: " << found / expected << " of the endless plate");
    CHECK(found == Approx(expected).epsilon(0.005));  // a square is no disc
  }
}

TEST_CASE("plate elements: a strip afloat bends as the half-endless beam on springs") {
  const double b = 0.12;
  const ThinPlate law = ice_plate(0.0);  // a beam has no sides to bend by
  const double l = law.characteristic_length(), lambda = std::sqrt(2.0) * l;
  const PlateElements plate(law, {graded_lines(0.02 * l, 3.0 * l, 8.0 * l), {0.0, 0.5 * b, b}});
  const Eigen::VectorXd u = plate.settle(plate.pressed({0.0, 0.01 * l, 0.0, b}));
  const Found found = largest_upper(plate, u, 0);
  // Hetenyi: w = 2 F / (lambda k b), M = F lambda exp(-pi/4) sin(pi/4) at pi/4 lambda; the load's middle is
  // at 0.005 l.
  const double moment = lambda * std::exp(-0.25 * pi) * std::sin(0.25 * pi);
  INFO("deflection " << -u[0] * lambda * law.foundation * b / 2.0 << ", stress "
                     << found.stress * b * law.h * law.h / (6.0 * moment) << ", place "
                     << found.at / (0.25 * pi * lambda) << " of the beam's");
  CHECK(-u[0] ==
        Approx(2.0 / (lambda * law.foundation * b)).epsilon(0.01));  // the load's middle is at 0.005 l
  CHECK(found.stress == Approx(6.0 * moment / (b * law.h * law.h)).epsilon(0.01));  // likewise: 0.7 %
  CHECK(found.at == Approx(0.25 * pi * lambda).epsilon(0.03));                      // lines are 0.02 l apart
}

TEST_CASE("plate elements: a pressed corner and a pressed edge bend as Westergaard says") {
  const ThinPlate law = ice_plate();
  const double l = law.characteristic_length();
  for (const double over_h : {0.85, 1.0, 1.2}) {
    const double a = over_h * law.h, a1 = a * std::sqrt(2.0), side = a * std::sqrt(pi);
    const std::vector<double> lines = graded_lines(0.25 * law.h, 1.5 * l, 6.0 * l);
    const PlateElements plate(law, {lines, lines});
    const Found found = largest_upper(plate, plate.settle(plate.pressed({0.0, side, 0.0, side})), 1);
    // From memory of pavement design, a disc that touches both edges; the formula is a fit.
    const double stress = 3.0 / (law.h * law.h) * (1.0 - std::pow(a1 / l, 0.6)), at = 2.0 * std::sqrt(a1 * l);
    INFO("corner, radius " << over_h << " h: stress " << found.stress / stress << ", place "
                           << found.at * std::sqrt(2.0) / at << " of Westergaard's");
    CHECK(found.stress == Approx(stress).epsilon(0.10));           // the formula is a fit
    CHECK(found.at * std::sqrt(2.0) == Approx(at).epsilon(0.15));  // the top is flat
  }
  const std::vector<double> x = graded_lines(0.125 * law.h, l, 6.0 * l);
  const PlateElements plate(law,
                            {x, x, PlateEdge::free, PlateEdge::free, PlateEdge::mirror, PlateEdge::free});
  const Eigen::VectorXd u = plate.settle(0.5 * plate.pressed({0.0, 0.125 * law.h, 0.0, 0.125 * law.h}));
  const double edge = (1.0 + 0.4 * law.nu) / std::sqrt(6.0 * law.bending * law.foundation);
  INFO("edge, deflection " << -u[0] / edge << " of Westergaard's");
  CHECK(-u[0] == Approx(edge).epsilon(0.02));  // (1 + 0.4 nu) is a fit
}

TEST_CASE("plate elements: halved, they say the same of a pressed edge") {
  const ThinPlate law = ice_plate();
  const double l = law.characteristic_length(), h = law.h;
  Found found[2];
  for (const int n : {0, 1}) {
    const std::vector<double> lines = graded_lines(n == 0 ? 0.5 * h : 0.25 * h, l, 5.0 * l);
    const PlateElements plate(
        law, {lines, lines, PlateEdge::free, PlateEdge::free, PlateEdge::mirror, PlateEdge::free});
    found[n] = largest_upper(plate, plate.settle(0.5 * plate.pressed({0.0, 0.5 * h, 0.0, h})), 0);
  }
  INFO("stress " << found[0].stress / found[1].stress << ", place " << found[0].at / found[1].at);
  CHECK(found[0].stress == Approx(found[1].stress).epsilon(1e-3));  // half the element size
  CHECK(found[0].at ==
        Approx(found[1].at).margin(0.5 * h));  // the lines of the coarser plate are 0.5 h apart
}
