// Equation numbers are those of docs/formulas.md.
#include "formula/lindqvist.h"

#include <cmath>

#include "base/units.h"
#include "formula/guards.h"

namespace icebow {
namespace {

// The bows the formula is used for: sloping stems with a wedge-shaped waterline. Above the upper waterline
// angle lie the flat, spoon and Thyssen-Waas families, below the lower stem angle Thyssen-Waas again; above
// the upper stem angle ice is crushed, not bent. A judgement, wide enough for straight, White and Melville
// bows.
constexpr LindqvistRange usual = {radians(15.0), radians(45.0), radians(10.0), radians(45.0)};

double plate_slope(const LindqvistInputs& in) {
  return lindqvist_psi(in.stem, in.waterline);
}

// Denominator of (F2): zero where friction holds the ice on the stem.
double slip_margin(const LindqvistInputs& in) {
  return 1.0 - in.mu * std::sin(in.stem) / std::cos(plate_slope(in));
}

// Length-like factor of the frictional part of (F4) [m]: the hull area covered by ice, per beam.
double covered_length(const LindqvistInputs& in) {
  const double phi = in.stem, alpha = in.waterline, psi = plate_slope(in);
  const double slant = std::sqrt(1.0 / std::pow(std::sin(phi), 2) + 1.0 / std::pow(std::tan(alpha), 2));
  return 0.7 * in.L - in.T / std::tan(phi) - in.B / (4.0 * std::tan(alpha)) +
         in.T * std::cos(phi) * std::cos(psi) * slant;
}

std::string violated_range(const LindqvistInputs& in) {
  std::string words = not_positive({{"L", in.L},
                                    {"B", in.B},
                                    {"T", in.T},
                                    {"stem", in.stem},
                                    {"waterline", in.waterline},
                                    {"h", in.h},
                                    {"sigma_f", in.sigma_f},
                                    {"E", in.E},
                                    {"rho_w", in.rho_w},
                                    {"rho_i", in.rho_i},
                                    {"g", in.g}});
  if (words.empty()) words = negative({{"V", in.V}, {"mu", in.mu}, {"nu", in.nu}});
  if (!words.empty()) return words;
  if (in.stem >= pi / 2) return "stem is " + in_words(degrees(in.stem)) + " deg, must be below 90 deg";
  if (in.waterline > pi / 2)
    return "waterline is " + in_words(degrees(in.waterline)) + " deg, must be at most 90 deg";
  if (in.nu >= 0.5) return "nu is " + in_words(in.nu) + ", must be below 0.5";
  if (in.rho_i > in.rho_w)
    return "ice of " + in_words(in.rho_i) + " kg/m^3 sinks in water of " + in_words(in.rho_w) + " kg/m^3";
  return "";
}

std::string violated_guard(const LindqvistInputs& in) {
  const std::string words = violated_range(in);
  if (!words.empty()) return words;
  if (slip_margin(in) <= 0.0)
    return "ice does not slip on the stem: 1 - mu sin(stem)/cos(psi) = " + in_words(slip_margin(in)) +
           ", must be positive (smaller friction or stem angle, larger waterline angle)";
  if (covered_length(in) < 0.0)
    return "L is too short for the bow: the ice-covered length of the bottom is " +
           in_words(covered_length(in)) + " m";
  return "";
}

std::string caution_for(const LindqvistInputs& in) {
  const std::string stem = outside_degrees({"stem", in.stem}, usual.stem_lower, usual.stem_upper);
  const std::string waterline =
      outside_degrees({"waterline", in.waterline}, usual.waterline_lower, usual.waterline_upper);
  if (stem.empty() && waterline.empty()) return "";
  return stem + (stem.empty() || waterline.empty() ? "" : ", ") + waterline +
         ": the formula is meant for sloping stems and was not validated for flat or Thyssen-Waas bows";
}

// (F2)
double crushing(const LindqvistInputs& in) {
  const double friction = in.mu * std::cos(in.stem) / std::cos(plate_slope(in));
  return 0.5 * in.sigma_f * in.h * in.h * (std::tan(in.stem) + friction) / slip_margin(in);
}

// (F3)
double bending(const LindqvistInputs& in) {
  const double psi = plate_slope(in);
  const double foundation = std::sqrt(in.E / (12.0 * (1.0 - in.nu * in.nu) * in.g * in.rho_w));
  const double friction = in.mu * std::cos(in.stem) / (std::sin(in.waterline) * std::cos(psi));
  return 27.0 / 64.0 * in.sigma_f * in.B * std::pow(in.h, 1.5) / foundation * (std::tan(psi) + friction) *
         (1.0 + 1.0 / std::cos(psi));
}

// (F4)
double submersion(const LindqvistInputs& in) {
  const double potential = in.T * (in.B + in.T) / (in.B + 2.0 * in.T);
  return (in.rho_w - in.rho_i) * in.g * in.h * in.B * (potential + in.mu * covered_length(in));
}

}  // namespace

double lindqvist_psi(double stem, double waterline) {
  return std::atan(std::tan(stem) / std::sin(waterline));
}

LindqvistRange lindqvist_range() {
  return usual;
}

LindqvistResult lindqvist(const LindqvistInputs& in) {
  LindqvistResult result;
  result.reason = violated_guard(in);
  result.valid = result.reason.empty();
  if (!result.valid) return result;
  result.caution = caution_for(in);
  result.crushing = crushing(in);
  result.bending = bending(in);
  result.submersion = submersion(in);
  // (F5), (F6)
  result.breaking = (result.crushing + result.bending) * (1.0 + 1.4 * in.V / std::sqrt(in.g * in.h));
  result.total = result.breaking + result.submersion * (1.0 + 9.4 * in.V / std::sqrt(in.g * in.L));
  return result;
}

}  // namespace icebow
