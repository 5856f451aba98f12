#include "cycle/ice_strip.h"

#include <catch2/catch.hpp>

using namespace icebow::cycle;

TEST_CASE("Ice strip: cut and trimmed") {
  IceStrip strip;
  CHECK(strip.cut(-1.0, 2.0) == 2.0);
  CHECK(strip.cut(5.0, 7.0) == 2.0);
  CHECK(strip.cut(5.5, 6.5) == 0.0);  // gone already
  REQUIRE(strip.intervals().size() == 2);
  CHECK(strip.intervals()[0].from == 2.0);
  CHECK(strip.intervals()[0].to == 5.0);
  CHECK(strip.holds(3.0));
  CHECK_FALSE(strip.holds(6.0));
  strip.trim(3.0);
  CHECK(strip.intervals()[0].from == 3.0);
  strip.trim(6.0);
  REQUIRE(strip.intervals().size() == 1);
  CHECK(strip.intervals()[0].from == 7.0);
}

TEST_CASE("Ice strip: the edge that is left remembers, the new one does not") {
  IceStrip strip;
  strip.intervals()[0].memory = 0.4;
  strip.cut(2.0, 3.0);
  CHECK(strip.intervals()[0].memory == 0.4);
  CHECK(strip.intervals()[1].memory == 0.0);
}

TEST_CASE("Ice strips: islands go, what hangs on the sheet stays") {
  std::vector<IceStrip> ice(5);
  const std::vector<double> width(5, 0.5);
  for (IceStrip& strip : ice) strip.cut(-1.0, 0.0);
  for (int i : {1, 2}) ice[static_cast<std::size_t>(i)].cut(4.0, 6.0);  // [0, 4] hangs on strip 0
  CHECK(drop_islands(ice, width, 0, 4) == 0.0);
  ice[0].cut(-1.0, 5.0);
  ice[3].cut(-1.0, 5.0);  // now [0, 4] of strips 1 and 2 is alone
  CHECK(drop_islands(ice, width, 0, 4) == 2 * 4.0 * 0.5);
  CHECK(ice[1].intervals().size() == 1);
}
