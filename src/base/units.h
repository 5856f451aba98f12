// Unit factors to SI and the Froude-Cauchy model laws.
#pragma once

#include <cmath>

namespace icebow {

constexpr double pi = 3.14159265358979323846;
constexpr double gravity = 9.81;  //!< [m/s^2]
constexpr double metres_per_second_per_knot = 1852.0 / 3600.0;

constexpr double radians(double degrees) {
  return degrees * (pi / 180.0);
}
constexpr double degrees(double radians) {
  return radians * (180.0 / pi);
}

// Froude-Cauchy scaling: full-scale value = model value * lambda^exponent, densities, angles, strains and
// friction unchanged (ITTC; shared by towing-tank practice). Speeds and times scale with sqrt(lambda).
namespace scaling {
constexpr double length = 1.0, stress = 1.0, speed = 0.5, time = 0.5, force = 3.0, moment = 4.0, volume = 3.0,
                 mass = 3.0, toughness = 1.5, energy_release_rate = 2.0, energy = 4.0, power = 3.5;
}
inline double to_full_scale(double model, double lambda, double exponent) {
  return model * std::pow(lambda, exponent);
}
inline double to_model_scale(double full, double lambda, double exponent) {
  return full / std::pow(lambda, exponent);
}

}  // namespace icebow
