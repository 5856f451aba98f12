#include "paper_bows.h"

#include "base/units.h"

namespace icebow {
namespace {

BowAngles angles_deg(double stem, double waterline, double buttock, double flare) {
  return {radians(stem), radians(waterline), radians(buttock), radians(flare)};
}

}  // namespace

BowParameters conventional_bow() {
  BowParameters bow;
  bow.family = BowFamily::straight_parallel_buttocks;
  bow.angles = angles_deg(24.35, 22.0, 28.0, 33.0);
  bow.L = 147.2;
  bow.B = 23.0;
  bow.T = 8.0;
  bow.D = 13.5;
  bow.Lf = 32.5;
  return bow;
}

BowParameters thyssen_waas_bow() {
  BowParameters bow;
  bow.family = BowFamily::thyssen_waas;
  bow.angles = angles_deg(14.0, 39.0, 13.0, 77.0);
  bow.L = 100.0;
  bow.B = 20.0;
  bow.T = 7.0;
  bow.D = 12.0;
  bow.Lf = 10.0;
  return bow;
}

BowParameters random_bow(BowFamily family, std::mt19937& random) {
  const auto in = [&](double low, double high) {
    return std::uniform_real_distribution<>(low, high)(random);
  };
  const bool straight = family == BowFamily::straight_parallel_buttocks;
  BowParameters bow;
  bow.family = family;
  const double stem = straight ? in(20, 30) : in(10, 18), waterline = straight ? in(18, 30) : in(39, 90);
  const double buttock = straight ? in(20, 32) : in(10, 16), flare = straight ? in(25, 45) : in(70, 88);
  bow.angles = angles_deg(stem, waterline, buttock, flare);
  bow.L = in(80, 160);
  bow.B = in(15, 30);
  bow.T = in(5, 10);
  bow.D = bow.T + in(3, 6);
  bow.Lf = bow.B * (straight ? in(1.0, 1.6) : in(0.15, 0.6));
  return bow;
}

}  // namespace icebow
