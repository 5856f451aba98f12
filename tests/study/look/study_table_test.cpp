// A study's numbers for other programs.
#include "study/look/study_table.h"

#include <catch2/catch.hpp>
#include <cmath>

#include "base/parallel_file.h"
#include "tests/support/fake_study.h"

using namespace icebow;

TEST_CASE("a study's HDF5 file has a list for each number, by its pointer") {
  const TemporaryDirectory directory;
  RecordingObserver observer;
  const StudySpec spec = fake_study(
      R"({"method": {"type": "grid", "variables": {"/bow/stem_deg": {"values": [22, 40]}}}})");  // 40:
                                                                                                 // infeasible
  run_study(Communicator::serial(), spec, fake_settings(directory / "s"), observer);
  const Json table = study_table(directory / "s");
  write_study_hdf5(table, directory / "s.h5");
  ParallelFile file = ParallelFile::open(Communicator::serial(), directory / "s.h5");
  CHECK(file.read_texts("design") == std::vector<std::string>{"baseline", "d001", "d002"});
  CHECK(file.read_texts("status") == std::vector<std::string>{"ok", "ok", "infeasible"});
  CHECK(file.read_list<int>("rank") == std::vector<int>{2, 1, 0});
  CHECK(file.read_list<double>("parameters/bow/stem_deg") == std::vector<double>{25, 22, 40});
  const std::vector<double> loads = file.read_list<double>("results/metrics/full_scale/mean_load_N");
  REQUIRE(loads.size() == 3);
  CHECK(loads[1] == fake_load(22, 22));
  CHECK(std::isnan(loads[2]));
}

TEST_CASE("what is a number here and an object there has no column of HDF5, and CSV has both") {
  const auto row = [](const std::string& design, const Json& printed) {
    return Json{{"design", design},
                {"status", "ok"},
                {"reason", ""},
                {"rank", 1},
                {"parameters", Json::object()},
                {"result", {{"programs", printed}}}};
  };
  const Json table = {row("a", {{"yard", 1.5}}), row("b", {{"yard", {{"load_N", 2.0}}}})};
  const TemporaryDirectory directory;
  CHECK_THROWS_WITH(write_study_hdf5(table, directory / "s.h5"),
                    Catch::Contains("/programs/yard: is a number"));
  CHECK(study_csv(table) ==
        "design,status,reason,rank,result:/programs/yard,result:/programs/yard/load_N\r\na,ok,,1,1.5,\r\n"
        "b,ok,,1,,2.0\r\n");
  CHECK_THROWS_WITH(write_study_hdf5(Json::array(), directory / "no/such/s.h5"), Catch::Contains("s.h5"));
}
