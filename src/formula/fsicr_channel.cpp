// Equation numbers are those of docs/formulas.md.
#include "formula/fsicr_channel.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/units.h"
#include "formula/guards.h"

namespace icebow {
namespace {

// Of the rule: C3, C4 in kg/(m^2 s^2), C5 in kg/s.
constexpr double C3 = 845.0, C4 = 42.0, C5 = 825.0;

struct Range {
  const char* name;
  double value, lower, upper;
};

std::string violated_guard(const ChannelInputs& in) {
  std::string words = not_positive({{"L", in.L},
                                    {"B", in.B},
                                    {"T", in.T},
                                    {"L_bow", in.L_bow},
                                    {"A_wf", in.A_wf},
                                    {"waterline angle", in.waterline},
                                    {"stem angle", in.stem},
                                    {"buttock angle", in.buttock}});
  if (words.empty()) words = negative({{"L_par", in.L_par}});
  if (!words.empty()) return words;
  if (in.L_par + in.L_bow > in.L)
    return "L_par + L_bow is " + in_words(in.L_par + in.L_bow) + " m, more than L, " + in_words(in.L) + " m";
  if (in.waterline > pi / 2)
    return "waterline angle is " + in_words(degrees(in.waterline)) + ", must be at most 90 deg";
  if (in.stem > pi / 2) return "stem angle is " + in_words(degrees(in.stem)) + ", must be at most 90 deg";
  if (in.buttock >= pi / 2)
    return "buttock angle is " + in_words(degrees(in.buttock)) + ", must be below 90 deg";
  return "";
}

// The rule names these ranges of the ships it was validated on.
std::string outside_validated(const ChannelInputs& in) {
  std::string words;
  for (const Range& r :
       {Range{"waterline angle, deg", degrees(in.waterline), 15, 55},
        Range{"stem angle, deg", degrees(in.stem), 25, 90},
        Range{"buttock angle, deg", degrees(in.buttock), 10, 90}, Range{"L, m", in.L, 65, 250},
        Range{"B, m", in.B, 11, 40}, Range{"T, m", in.T, 4, 15},
        Range{"L_bow/L", in.L_bow / in.L, 0.15, 0.40}, Range{"L_par/L", in.L_par / in.L, 0.25, 0.75},
        Range{"A_wf/(L B)", in.A_wf / (in.L * in.B), 0.09, 0.27}}) {
    if (r.value >= r.lower && r.value <= r.upper) continue;
    words += (words.empty() ? "" : "; ") + std::string(r.name) + " is " + in_words(r.value) +
             ", the rule was validated from " + in_words(r.lower) + " to " + in_words(r.upper);
  }
  return words;
}

// (F11), (F12): of the frozen layer on the channel, which class IA Super alone has to break.
double frozen_layer(const ChannelInputs& in) {
  const double phi = degrees(in.stem);
  const double at_rest = 23.0 * in.B * in.L_par / (2.0 * in.T / in.B + 1.0) +
                         (1.0 + 0.021 * phi) * (45.8 * in.B + 14.7 * in.L_bow + 29.0 * in.B * in.L_bow);
  const double by_speed = (1.0 + 0.063 * phi) * (1530.0 + 170.0 * in.B) +
                          400.0 * (1.0 + 1.2 * in.T / in.B) * in.B * in.B / std::sqrt(in.L);
  return at_rest + by_speed;
}

// (F10) without the frozen layer.
double brash_ice(const ChannelInputs& in, double H_M) {
  const double psi = std::atan(std::tan(in.buttock) / std::sin(in.waterline));
  const double C_mu = std::max(0.45, 0.15 * std::cos(in.buttock) + std::sin(psi) * std::sin(in.waterline));
  const double C_psi = std::max(0.0, 0.047 * degrees(psi) - 2.115);  // 0 at 45 deg
  const double H_F = 0.26 + std::sqrt(H_M * in.B);
  const double slenderness = std::clamp(std::pow(in.L * in.T / (in.B * in.B), 3), 5.0, 20.0);
  return C3 * C_mu * (H_F + H_M) * (H_F + H_M) * (in.B + C_psi * H_F) + C4 * in.L_par * H_F * H_F +
         C5 * slenderness * in.A_wf / in.L;
}

}  // namespace

ChannelResult fsicr_channel(const ChannelInputs& in) {
  ChannelResult result;
  result.reason = violated_guard(in);
  result.valid = result.reason.empty();
  if (!result.valid) return result;
  result.caution = outside_validated(in);
  result.classes = {{"IA Super", 1.0, brash_ice(in, 1.0) + frozen_layer(in)},
                    {"IA", 1.0, brash_ice(in, 1.0)},
                    {"IB", 0.8, brash_ice(in, 0.8)},
                    {"IC", 0.6, brash_ice(in, 0.6)}};
  return result;
}

}  // namespace icebow
