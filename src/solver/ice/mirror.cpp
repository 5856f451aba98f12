#include "solver/ice/mirror.h"

#include <algorithm>

namespace icebow {
namespace {

template <class Real>
void mirror(Field& field, const Layout& layout, Real sign) {
  for (int jl = 0; jl < reach; ++jl) {
    for (int k = 0; k < layout.nz; ++k) {
      const Real* const own = field.data<Real>() + layout.row(jl, k) - ghost_blocks * block;
      Real* const image = field.data<Real>() + layout.row(-1 - jl, k) - ghost_blocks * block;
      std::transform(own, own + layout.stride, image, [sign](Real value) { return sign * value; });
    }
  }
}

void mirror(const IceSheet& sheet, Field& field, int sign) {
  if (sheet.precision == Precision::fp64) {
    mirror<double>(field, sheet.layout, sign);
  } else {
    mirror<float>(field, sheet.layout, static_cast<float>(sign));
  }
}

}  // namespace

void mirror_displacements(IceSheet& sheet) {
  if (!sheet.at_symmetry_plane()) return;
  for (int c = 0; c < 3; ++c) mirror(sheet, sheet.u[c], c == 1 ? -1 : 1);
  mirror(sheet, sheet.extra_strength, 1);
}

void mirror_dilatations(IceSheet& sheet) {
  if (sheet.at_symmetry_plane()) mirror(sheet, sheet.theta, 1);
}

}  // namespace icebow
