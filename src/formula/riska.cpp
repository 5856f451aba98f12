// Equation numbers are those of docs/formulas.md.
#include "formula/riska.h"

#include <cmath>

#include "base/units.h"
#include "formula/guards.h"

namespace icebow {
namespace {

constexpr double newtons_per_kilonewton = 1000.0;

std::string violated_guard(const RiskaInputs& in) {
  std::string words = not_positive(
      {{"L", in.L}, {"B", in.B}, {"T", in.T}, {"L_bow", in.L_bow}, {"stem", in.stem}, {"h", in.h}});
  if (words.empty()) words = negative({{"L_par", in.L_par}, {"V", in.V}});
  if (!words.empty()) return words;
  if (in.stem > pi / 2) return "stem is " + in_words(degrees(in.stem)) + " deg, must be at most 90 deg";
  if (in.L_par + in.L_bow > in.L)
    return "L_par + L_bow is " + in_words(in.L_par + in.L_bow) + " m, more than L, " + in_words(in.L) + " m";
  return "";
}

// (F7); the fit is in kilonewtons, metres and degrees.
double at_rest(const RiskaInputs& in) {
  const double phi = degrees(in.stem);
  const double midbody = 0.23 * in.B * in.L_par * in.h / (2.0 * in.T / in.B + 1.0);
  const double bow =
      4.58 * in.B * in.h * in.h + 1.47 * in.L_bow * in.h * in.h + 0.29 * in.B * in.L_bow * in.h;
  return newtons_per_kilonewton * (midbody + (1.0 + 0.021 * phi) * bow);
}

// (F8)
double per_speed(const RiskaInputs& in) {
  const double phi = degrees(in.stem);
  const double bow = (1.0 + 0.063 * phi) * (18.9 * std::pow(in.h, 1.5) + 0.67 * in.B * in.h);
  const double hull = 1.55 * in.h * (1.0 + 1.2 * in.T / in.B) * in.B * in.B / std::sqrt(in.L);
  return newtons_per_kilonewton * (bow + hull);
}

}  // namespace

RiskaResult riska_1997(const RiskaInputs& in) {
  RiskaResult result;
  result.reason = violated_guard(in);
  result.valid = result.reason.empty();
  if (!result.valid) return result;
  result.C1 = at_rest(in);
  result.C2 = per_speed(in);
  result.total = result.C1 + result.C2 * in.V;
  return result;
}

}  // namespace icebow
