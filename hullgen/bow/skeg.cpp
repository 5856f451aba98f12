#include "hullgen/bow/skeg.h"

#include <algorithm>

#include "hullgen/bow/bow_surface.h"

namespace icebow {

double Skeg::depth(double share, double eta) const {
  if (height == 0.0 || eta >= half_width) return 0.0;
  const double run = share * bottom, end = std::min(run, length - run) / cot(angle);
  return std::clamp(end, 0.0, height) * (1.0 - eta / half_width);
}

std::vector<double> Skeg::shares() const {
  if (height == 0.0) return {};
  const double end = height * cot(angle);
  return {end / bottom, (length - end) / bottom, length / bottom};
}

double Skeg::volume() const {
  if (height == 0.0) return 0.0;
  return share_of_eta * half_width * height * (length - height * cot(angle));
}

Skeg skeg_of(const BowParameters& bow) {
  if (bow.centre.skeg_height == 0.0) return {};
  const BowSurface b = bow_surface(bow);
  return {bow.centre.skeg_height, bow.centre.skeg_angle,  skeg_half_width(bow),
          bottom_share(bow),      bow.centre.skeg_length, bow.L - b.s(0.0, -bow.T) - b.reamer};
}

}  // namespace icebow
