#include "solver/run/sheet_file.h"

#include <algorithm>
#include <type_traits>
#include <utility>

namespace icebow {
namespace {

using Sizes = std::vector<std::uint64_t>;

std::uint64_t size(int n) {
  return static_cast<std::uint64_t>(n);
}

// Where an array lies in the file and in memory.
struct Places {
  Slab file, memory;
};

Places fields_of(const IceSheet& sheet) {
  const Layout& l = sheet.layout;
  const Sizes count = {size(l.columns), size(l.nz), size(l.blocks * block)};
  return {{{size(sheet.lattice.ny), size(l.nz), size(sheet.lattice.blocks() * block)},
           {size(l.j0), 0, size(l.i0)},
           count},
          {{size(l.columns + 2 * reach), size(l.nz), size(static_cast<int>(l.stride))},
           {reach, 0, ghost_blocks * block},
           count}};
}

// Rows and blocks [first, last) of the bonds in memory, as numbers of the own columns and blocks.
struct Range {
  int row0, row1, block0, block1;
};

// Rows of the file below column 0: a half model's bonds across the symmetry plane, all of which start there.
int rows_below(const IceSheet& sheet) {
  return sheet.lattice.half ? reach : 0;
}

Range own(const IceSheet& sheet) {
  return {sheet.at_symmetry_plane() ? -reach : 0, sheet.layout.columns, 0, sheet.layout.blocks};
}

// With the copies of the neighbours' that exist.
Range followed(const IceSheet& sheet) {
  const Layout& l = sheet.layout;
  return {std::max(-reach, -l.j0 - rows_below(sheet)), l.columns, sheet.partition.block0 > 0 ? -1 : 0,
          l.blocks + (sheet.partition.block1 < sheet.lattice.blocks() ? 1 : 0)};
}

Places bonds_of(const IceSheet& sheet, const Range& r) {
  const Layout& l = sheet.layout;
  const Sizes count = {size(r.row1 - r.row0), size(r.block1 - r.block0), size(sheet.bits.per_block())};
  const int below = rows_below(sheet);
  return {{{size(below + sheet.lattice.ny), size(sheet.lattice.blocks()), size(sheet.bits.per_block())},
           {size(below + l.j0 + r.row0), size(sheet.partition.block0 + r.block0), 0},
           count},
          {{size(l.columns + reach), size(l.blocks + 2), size(sheet.bits.per_block())},
           {size(r.row0 + reach), size(r.block0 + 1), 0},
           count}};
}

Places states_of(const IceSheet& sheet, const Range& r) {
  const Layout& l = sheet.layout;
  const Sizes count = {size(r.row1 - r.row0), size(l.nz), size(r.block1 - r.block0)};
  const int below = rows_below(sheet);
  return {{{size(below + sheet.lattice.ny), size(l.nz), size(sheet.lattice.blocks())},
           {size(below + l.j0 + r.row0), 0, size(sheet.partition.block0 + r.block0)},
           count},
          {{size(l.columns + reach), size(l.nz), size(l.blocks + 2)},
           {size(r.row0 + reach), 0, size(r.block0 + 1)},
           count}};
}

const char* const components[] = {"_x", "_y", "_z"};

// visit(name, address) for each array that a step starts from.
template <class AnySheet, class Visit>
void for_each_field(AnySheet& sheet, Visit visit) {
  using FieldOfSheet = std::remove_reference_t<decltype((sheet.theta))>;  // const where the sheet is
  const std::pair<const char*, FieldOfSheet*> groups[] = {
      {"u", sheet.u}, {"v", sheet.v}, {"residual", sheet.residual}, {"acceleration", sheet.acceleration}};
  const auto visit_field = [&](const std::string& name, FieldOfSheet& field) {
    if (sheet.precision == Precision::fp64) {
      visit(name, field.template data<double>());
    } else {
      visit(name, field.template data<float>());
    }
  };
  for (const auto& [name, fields] : groups) {
    for (int c = 0; c < 3; ++c) visit_field(std::string(name) + components[c], fields[c]);
  }
  visit_field("extra_strength", sheet.extra_strength);
  visit_field("crushed_depth", sheet.crushed_depth);
  visit_field("touched_face", sheet.touched_face);
}

}  // namespace

void save_sheet(ParallelFile& file, const IceSheet& sheet) {
  const Places f = fields_of(sheet), b = bonds_of(sheet, own(sheet)), t = states_of(sheet, own(sheet));
  for_each_field(sheet,
                 [&](const std::string& name, const auto* p) { file.write(name, f.file, p, f.memory); });
  file.write("bonds", b.file, sheet.bits.row(-reach, 0) - sheet.bits.per_block(), b.memory);
  file.write("states", t.file, sheet.state(-reach, 0) - 1, t.memory);
}

void load_sheet(ParallelFile& file, IceSheet& sheet) {
  const Places f = fields_of(sheet), b = bonds_of(sheet, followed(sheet)),
               t = states_of(sheet, followed(sheet));
  for_each_field(sheet, [&](const std::string& name, auto* p) { file.read(name, f.file, p, f.memory); });
  file.read("bonds", b.file, sheet.bits.row(-reach, 0) - sheet.bits.per_block(), b.memory);
  file.read("states", t.file, sheet.state(-reach, 0) - 1, t.memory);
  sheet.find_cracks();
}

int precision_of(const IceSheet& sheet) {
  return static_cast<int>(sheet.theta.element_size());
}

}  // namespace icebow
