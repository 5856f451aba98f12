// Cracks: of a made-up list of columns, and of a sheet with a cut through its bonds.
#include "solver/watch/cracks.h"

#include <catch2/catch.hpp>
#include <cmath>

#include "base/units.h"
#include "tests/support/main.h"
#include "tests/support/tiny_hull.h"

using namespace icebow;

namespace {

// 80 x 40 columns of 0.1 m, whole or its port half. The hull is a wedge with its stem at the sheet's edge.
CrackedSheet made_up(bool half = false) {
  CrackedSheet sheet;
  sheet.lattice.nx = 80;
  sheet.lattice.ny = half ? 20 : 40;
  sheet.lattice.nz = 3;
  sheet.lattice.dx = 0.1;
  sheet.lattice.half = half;
  sheet.thickness = 0.3;
  sheet.characteristic_length = 1.5;
  return sheet;
}

const std::vector<Segment> wedge = {{{0.0, 0.0}, {-1.0, 1.0}},
                                    {{-1.0, 1.0}, {-9.0, 1.0}},
                                    {{-9.0, 1.0}, {-9.0, -1.0}},
                                    {{-9.0, -1.0}, {-1.0, -1.0}},
                                    {{-1.0, -1.0}, {0.0, 0.0}}};

// A column cracked at an advance, by a crack in this direction to the course.
CrackedColumn cracked_column(std::int64_t i, std::int64_t j, double opened, double direction) {
  CrackedColumn c{i, j, opened};
  c.cos2 = 0.6 * std::cos(2.0 * direction + M_PI);
  c.sin2 = 0.6 * std::sin(2.0 * direction + M_PI);
  return c;
}

// Two rows of columns ahead of the stem, which is at the advance's x.
void crack_ahead(CrackedSheet& sheet, int from, int to, double opened) {
  for (int i = from; i < to; ++i)
    for (int j : {19, 20}) sheet.columns.push_back(cracked_column(i, j, opened, 0.0));
}

}  // namespace

TEST_CASE("a crack along the ray from the hull is radial, one across it circumferential") {
  CrackedSheet sheet = made_up();
  crack_ahead(sheet, 2, 14, 0.0);
  for (int j = 12; j < 28; ++j)
    for (int i : {30, 31}) sheet.columns.push_back(cracked_column(i, j, 1.0, 0.5 * M_PI));
  const Cracks found = find_cracks(sheet, wedge);
  REQUIRE(found.list.size() == 2);
  const Crack &first = found.list[0], &second = found.list[1];
  // The same columns, one by one.
  const std::vector<CrackedPlace> places = cracked_places(sheet, wedge);
  REQUIRE(places.size() == std::size_t(first.columns + second.columns));
  for (const CrackedPlace& place : places)
    CHECK(place.kind == (place.x < 2.0 ? CrackKind::radial : CrackKind::circumferential));
  CHECK(first.kind == CrackKind::radial);
  CHECK(first.opened == 0.0);
  CHECK(first.x == Approx(0.25));
  CHECK(std::abs(first.y) == Approx(0.05));
  CHECK(first.length == Approx(1.2).epsilon(1e-6));    // whole spacings: rounding
  CHECK(first.direction == Approx(0.0).margin(1e-9));  // rounding
  CHECK(second.kind == CrackKind::circumferential);
  CHECK(second.x == Approx(2.05));                    // its column nearest to the hull, which has come 1 m
  CHECK(second.length == Approx(1.6).epsilon(1e-6));  // whole spacings: rounding
  CHECK(std::abs(second.direction) == Approx(0.5 * M_PI));
  CHECK(second.along_course > 2.1);
  CHECK(second.from_hull > 2.05);
  CHECK(second.from_hull < second.along_course);
  CHECK(found.isolated == 0);
  const BreakingLength length = breaking_length(found.list);
  CHECK(length.cracks == 1);
  CHECK(length.normal == Approx(second.from_hull));
}

TEST_CASE("the breaking length's distribution counts cracks by their columns") {
  std::vector<Crack> cracks(4);
  const double from_hull[4] = {3.0, 1.0, 8.0, 2.0};
  const int columns[4] = {4, 10, 2, 4};
  for (int n = 0; n < 4; ++n) {
    cracks[n].kind = CrackKind::circumferential;
    cracks[n].from_hull = from_hull[n];
    cracks[n].columns = columns[n];
  }
  cracks.push_back(cracks[0]);
  cracks.back().kind = CrackKind::radial;  // not counted
  cracks.back().columns = 100;
  const BreakingLength length = breaking_length(cracks);
  CHECK(length.cracks == 4);
  CHECK(length.normal == Approx(2.3));
  CHECK(length.tenth == 1.0);
  CHECK(length.median == 1.0);
  CHECK(length.nine_tenths == 3.0);
  CHECK(std::isnan(breaking_length({}).median));
}

TEST_CASE("beside the ship's flank the ray points sideways") {
  CrackedSheet sheet = made_up();
  // Parallel to the flank, 0.5 m off it, while the ship is 6 m in.
  for (int i = 20; i < 40; ++i) sheet.columns.push_back(cracked_column(i, 34, 6.0, 0.0));
  const Cracks found = find_cracks(sheet, wedge);
  REQUIRE(found.list.size() == 1);
  CHECK(found.list[0].kind == CrackKind::circumferential);
  CHECK(found.list[0].from_hull == Approx(0.45));
}

TEST_CASE("a radial crack that runs three characteristic lengths ahead splits the sheet") {
  CrackedSheet sheet = made_up();
  crack_ahead(sheet, 1, 60, 0.0);
  REQUIRE(find_cracks(sheet, wedge).list.size() == 1);
  CHECK(find_cracks(sheet, wedge).list[0].kind == CrackKind::splitting);
  sheet.characteristic_length = 2.1;
  CHECK(find_cracks(sheet, wedge).list[0].kind == CrackKind::radial);
}

TEST_CASE("ice is crushed where its bonds go at once, and secondary where the waterline has passed") {
  CrackedSheet sheet = made_up();
  for (int i = 1; i < 4; ++i) {
    sheet.columns.push_back(cracked_column(i, 20, 0.0, 0.0));
    sheet.columns.back().crushed = 0.2;
  }
  for (int i = 5; i < 15; ++i) sheet.columns.push_back(cracked_column(i, 22, 4.0, 0.0));
  const Cracks found = find_cracks(sheet, wedge);
  REQUIRE(found.list.size() == 2);
  CHECK(found.list[0].kind == CrackKind::crushed);
  CHECK(found.list[1].kind == CrackKind::secondary);
  CHECK(found.columns[static_cast<int>(CrackKind::crushed)] == 3);
  // Three quarters gone only after the ship had come on by more than a thickness: it cracked first.
  for (CrackedColumn& c : sheet.columns) c.crushed = c.opened + 0.4;
  CHECK(find_cracks(sheet, wedge).columns[static_cast<int>(CrackKind::crushed)] == 0);
}

TEST_CASE("cracks along a held side are told from those of the ship") {
  CrackedSheet sheet = made_up();
  for (int i = 20; i < 40; ++i) sheet.columns.push_back(cracked_column(i, 36, 6.0, 0.0));
  REQUIRE(find_cracks(sheet, wedge).list.size() == 1);
  CHECK(breaking_length(find_cracks(sheet, wedge).list).cracks == 1);
  sheet.held_beyond = 1.7;  // that column is at 1.65 m
  CHECK(find_cracks(sheet, wedge).list[0].kind == CrackKind::held_edge);
  CHECK(breaking_length(find_cracks(sheet, wedge).list).cracks == 0);
}

TEST_CASE("what opens later beside a crack is another one, and a short one is none") {
  CrackedSheet sheet = made_up();
  crack_ahead(sheet, 30, 45, 0.0);
  crack_ahead(sheet, 45, 60, 0.5);
  sheet.columns.push_back(cracked_column(70, 5, 0.0, 0.0));
  const Cracks found = find_cracks(sheet, wedge);
  CHECK(found.list.size() == 2);
  CHECK(found.isolated == 1);
}

TEST_CASE("a half model's cracks are those of both sides") {
  CrackedSheet half = made_up(true), whole = made_up();
  for (int j = 6; j < 16; ++j) {
    const double slant = 0.3;
    half.columns.push_back(cracked_column(30 + j / 4, j, 0.0, 0.5 * M_PI + slant));
    whole.columns.push_back(cracked_column(30 + j / 4, 20 + j, 0.0, 0.5 * M_PI + slant));
    whole.columns.push_back(cracked_column(30 + j / 4, 19 - j, 0.0, 0.5 * M_PI - slant));
  }
  const Cracks a = find_cracks(half, wedge), b = find_cracks(whole, wedge);
  REQUIRE(a.list.size() == 2);
  REQUIRE(b.list.size() == 2);
  for (int n = 0; n < 2; ++n) {
    CHECK(a.list[n].kind == b.list[n].kind);
    CHECK(a.list[n].length == Approx(b.list[n].length));
    CHECK(a.list[n].from_hull == Approx(b.list[n].from_hull));
  }
  CHECK(a.list[0].y == Approx(-a.list[1].y));
}

namespace {

// A sheet in which every bond across the line through its middle at an angle to the course is broken.
IceSheet cut_sheet(const Communicator& comm, const Scenario& s, double angle) {
  const Lattice lattice = make_lattice(s);
  IceSheet sheet(s, lattice, make_partition(lattice, comm.rank(), comm.size()),
                 make_material(s.ice, lattice.dx, s.numerics.horizon_ratio));
  const Layout& l = sheet.layout;
  const double x0 = lattice.x(lattice.nx / 2), y0 = 0.0037;
  const auto side = [&](int i, int j) {
    return (lattice.y(j) - y0) * std::cos(angle) - (lattice.x(i) - x0) * std::sin(angle) > 0.0;
  };
  for (int jl = -reach; jl < l.columns; ++jl)
    for (int k = 0; k < l.nz; ++k)
      for (int b = -1; b <= l.blocks; ++b)
        for (int slot = 0; slot < sheet.stencil.slots(k); ++slot)
          for (int lane = 0; lane < block; ++lane) {
            const Offset& o = sheet.stencil.half[k][slot];
            const int i = l.i0 + b * block + lane, j = l.j0 + jl;
            if (side(i, j) == side(i + o.di, j + o.dj)) continue;
            sheet.bits.row(jl, k)[std::ptrdiff_t(b) * sheet.bits.per_block() + slot] &=
                static_cast<std::uint16_t>(~(1u << lane));
          }
  return sheet;
}

}  // namespace

TEST_CASE("a cut through the bonds is found a column wide on either side, with its direction") {
  const Scenario s = tiny_run(1.28, 0.1);
  for (const double degrees_to_course : {0.0, 20.0, 45.0, 70.0, 90.0}) {
    const double angle = radians(degrees_to_course);
    const IceSheet sheet = cut_sheet(test_world(), s, angle);
    CrackWatch watch(s.numerics.dx, 0.006);
    CHECK_FALSE(watch.is_due(1));
    CHECK(watch.is_due(3));  // 0.018 m
    watch.look(test_world(), sheet, 0.3);
    const double length =
        std::min(1.28 / std::max(std::cos(angle), 1e-9), 0.56 / std::max(std::sin(angle), 1e-9));
    const double spacings = length / s.numerics.dx;
    INFO(degrees_to_course << " degrees: " << watch.columns().size() << " columns on " << spacings << " dx");
    CHECK(watch.columns().size() > 1.8 * spacings);
    CHECK(watch.columns().size() < 2.9 * spacings);
    double cos2 = 0.0, sin2 = 0.0;
    for (const CrackedColumn& c : watch.columns()) {
      CHECK(c.opened == 0.3);
      CHECK(std::isinf(c.crushed));
      cos2 += c.cos2;
      sin2 += c.sin2;
    }
    const double off = 0.5 * std::atan2(sin2, cos2) - (angle + 0.5 * M_PI);
    CHECK(std::abs(std::sin(off)) < std::sin(radians(5.0)));
    // Nothing new: nothing more.
    const std::size_t n = watch.columns().size();
    watch.look(test_world(), sheet, 0.4);
    CHECK(watch.columns().size() == n);
  }
}

TEST_CASE("the columns that cracked are the same on any number of ranks") {
  const Scenario s = tiny_run(1.28, 0.1);
  CrackWatch many(s.numerics.dx, 0.02), one(s.numerics.dx, 0.02);
  many.look(test_world(), cut_sheet(test_world(), s, 0.5), 0.1);
  one.look(Communicator::serial(), cut_sheet(Communicator::serial(), s, 0.5), 0.1);
  REQUIRE(many.columns().size() == one.columns().size());
  for (std::size_t n = 0; n < one.columns().size(); ++n) {
    const CrackedColumn &a = many.columns()[n], &b = one.columns()[n];
    CHECK((a.i == b.i && a.j == b.j && a.cos2 == b.cos2 && a.sin2 == b.sin2));
  }
}

TEST_CASE("ice without bonds is crushed") {
  const Scenario s = tiny_run(1.28, 0.1);
  IceSheet sheet = cut_sheet(Communicator::serial(), s, 0.0);
  const int j = sheet.layout.columns / 4;
  for (int dj = -reach; dj <= reach; ++dj)
    for (int w = 0; w < sheet.bits.per_block(); ++w)
      for (int b = 1; b < 3; ++b)
        sheet.bits.row(j + dj, 0)[std::ptrdiff_t(b) * sheet.bits.per_block() + w] = 0;
  CrackWatch watch(s.numerics.dx, 0.02);
  watch.look(Communicator::serial(), sheet, 0.1);
  int crushed = 0;
  for (const CrackedColumn& c : watch.columns()) crushed += std::isfinite(c.crushed);
  CHECK(crushed >= 32 - 2 * reach);
  CHECK(crushed <= 7 * 32);
}
