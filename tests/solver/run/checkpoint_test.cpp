// A run in two parts is the same run: whatever the number of ranks of either part.
#include "solver/run/checkpoint.h"

#include <catch2/catch.hpp>
#include <cstring>
#include <filesystem>

#include "base/errors.h"
#include "base/json.h"
#include "base/parallel_file.h"
#include "solver/contact/floe_contact.h"
#include "solver/run/case_text.h"
#include "solver/run/sheet_file.h"
#include "tests/support/checkpoint_case.h"
#include "tests/support/main.h"
#include "tests/support/same_record.h"

using namespace icebow;

namespace {

namespace fs = std::filesystem;

// A run by hand, to look into the sheet.
struct Run {
  Run(const Communicator& c, const Scenario& scenario)
      : comm(c),
        s(scenario),
        size(run_size(hull, s)),
        lattice(make_lattice(s)),
        stepper(comm, hull, s, lattice, size.dt, first_touch_x(hull, lattice)),
        recorder(comm, stepper, s),
        snapshots(comm, hull, s, options),
        process(comm, hull, s, stepper, recorder.steps_per_sample()) {}

  void samples(int n) {
    std::string reason;
    for (std::int64_t step = 0; step < n * recorder.steps_per_sample(); ++step) {
      stepper.step();
      if (stepper.steps() % recorder.steps_per_sample() != 0) continue;
      REQUIRE(recorder.sample(stepper, reason));
      process.sample(stepper);
    }
  }
  RunState state() { return {stepper, recorder, snapshots, process}; }
  std::string text() const { return case_text(hull, s, options); }

  const Communicator& comm;
  QuadMesh hull = tiny_hull();
  Scenario s;
  RunOptions options;
  RunSize size;
  Lattice lattice;
  Stepper stepper;
  Recorder recorder;
  Snapshots snapshots;
  ProcessWatch process;
};

// Groups of 1, 2, .. ranks out of the world's; the others do nothing.
template <class Body>
void with_ranks(int n, const Body& body) {
  const Communicator part = test_world().split(test_world().rank() < n ? 0 : 1);
  if (test_world().rank() < n) body(part);
  test_world().barrier();
}

// This rank's part of one against the whole of the other.
void check_same(const IceSheet& part, const IceSheet& whole) {
  const Layout &l = part.layout, &w = whole.layout;
  int different = 0;
  for (int jl = 0; jl < l.columns; ++jl) {
    for (int k = 0; k < l.nz; ++k) {
      const std::size_t a = l.row(jl, k), b = w.row(jl + l.j0, k) + l.i0;
      const auto differs = [&](const auto& x, const auto& y) {
        const std::size_t size = x.element_size();
        return std::memcmp(x.bytes() + a * size, y.bytes() + b * size, l.blocks * block * size) != 0;
      };
      for (int c = 0; c < 3; ++c) {
        different += differs(part.u[c], whole.u[c]) + differs(part.v[c], whole.v[c]);
        different += differs(part.residual[c], whole.residual[c]);
      }
    }
    const std::size_t per_block = part.bits.per_block();
    different += std::memcmp(part.bits.row(jl, 0), whole.bits.row(jl + l.j0, 0) + l.i0 / block * per_block,
                             l.blocks * per_block * sizeof(std::uint16_t)) != 0;
  }
  CHECK(different == 0);
}

void check_second_part(const Communicator& comm, const std::string& file, const Run& straight,
                       const Scenario& s) {
  Run run(comm, s);
  REQUIRE(why_not_resumable(comm, file, run.text(), precision_of(run.stepper.sheet()), 1000000).empty());
  RunState state = run.state();
  load_checkpoint(comm, file, state);
  CHECK(state.wall_seconds == 12.5);
  run.samples(10);
  std::int64_t broken = run.stepper.broken_bonds();
  comm.sum(&broken, 1);
  CHECK(broken == straight.stepper.broken_bonds());
  CHECK(run.stepper.steps() == straight.stepper.steps());
  check_same_record(run.recorder.history(), straight.recorder.history());
  check_same(run.stepper.sheet(), straight.stepper.sheet());
  CHECK(run.process.crack_record() == straight.process.crack_record());
  if (comm.is_root()) CHECK(run.process.ice_record() == straight.process.ice_record());
}

void check_two_parts(Scenario s) {
  const Communicator& world = test_world();
  const TestFolder folder(world, "checkpoint");
  const std::string file = folder.file("c.h5");
  const Communicator alone = Communicator::serial();
  Run straight(alone, s);
  straight.samples(34);
  REQUIRE(straight.stepper.broken_bonds() > 1000);
  REQUIRE_FALSE(straight.process.crack_record().empty());

  Run first(world, s);
  first.samples(24);
  RunState state = first.state();
  state.wall_seconds = 12.5;
  save_checkpoint(world, file, first.text(), state);
  CHECK(fs::exists(file));
  CHECK_FALSE(fs::exists(file + ".tmp"));
  s.numerics.ranks_along_x = 0;
  for (int n = 1; n <= world.size(); ++n) {
    with_ranks(n, [&](const Communicator& comm) { check_second_part(comm, file, straight, s); });
  }
  if (world.size() % 2 == 0) {
    s.numerics.ranks_along_x = 2;
    check_second_part(world, file, straight, s);
  }
}

}  // namespace

TEST_CASE("a run goes on from its checkpoint bit for bit on any number of ranks") {
  check_two_parts(breaking_ice());
}

TEST_CASE("a checkpoint of ranks along the course is read by any other grid") {
  if (test_world().size() % 2 != 0) return;
  Scenario s = breaking_ice();
  s.numerics.ranks_along_x = 2;
  check_two_parts(s);
}

TEST_CASE("a run in a moving window goes on from its checkpoint") {
  Scenario s = breaking_ice();
  s.V = 1.0;
  s.sheet.window_ahead = s.sheet.length - 0.1;  // moves before the cut
  check_two_parts(s);
}

TEST_CASE("a run in ice that breaks by stress and is crushed goes on from its checkpoint") {
  Scenario s = breaking_ice();
  s.ice.K_I = 0.0;
  s.ice.tensile_strength = 60e3;
  s.ice.crushing_pressure = 200e3;
  s.numerics.contact = ContactRule::crushing;
  check_two_parts(s);
}

TEST_CASE("a half model goes on from its checkpoint, in a moving window too") {
  Scenario s = breaking_ice();
  s.sheet.half_model = true;
  check_two_parts(s);
  s.V = 1.0;
  s.sheet.window_ahead = s.sheet.length - 0.1;
  check_two_parts(s);
}

namespace {

struct Files {
  explicit Files(const Communicator& comm) : folder(comm, "checkpoint_run") {
    options.directory = folder.path();
    options.checkpoint_file = folder.file("checkpoint.h5");
    options.snapshots = 3;
    options.pictures = 8;
    options.on_resume = [this](std::int64_t step) { resumed_at = step; };
  }
  // Stops when the first picture is there, or as soon as it can.
  RunResult interrupted(const Scenario& s, bool at_once = true) {
    RunOptions until = options;
    until.checkpoint_every_s = at_once ? 0.0 : 0.05;
    until.stop = [&] { return at_once || fs::exists(folder.file("ice_000.png")); };
    return simulate(test_world(), tiny_hull(), s, until);
  }
  TestFolder folder;
  RunOptions options;
  std::int64_t resumed_at = -1;
};

Scenario slow() {
  Scenario s = breaking_ice();
  s.advance = 0.25;
  s.numerics.dt_fraction = 0.5;
  return s;
}

// A short way that still takes long enough to be interrupted, which is asked for every quarter of a second.
Scenario slow_and_short() {
  Scenario s = slow();
  s.advance = 0.06;
  s.numerics.dt_fraction = 0.05;
  return s;
}

}  // namespace

TEST_CASE("an interrupted run continues when it is started again, its files too") {
  const Communicator& world = test_world();
  Files files(world);
  const Scenario s = slow();
  const RunResult first = files.interrupted(s, false);
  REQUIRE(first.status == RunStatus::interrupted);
  CHECK(fs::exists(files.options.checkpoint_file));

  const RunResult second = simulate(world, tiny_hull(), s, files.options);
  REQUIRE(second.status == RunStatus::ok);
  if (world.is_root()) CHECK(files.resumed_at == first.steps);
  CHECK(second.wall_seconds > first.wall_seconds);
  CHECK_FALSE(fs::exists(files.options.checkpoint_file));
  check_same_record(second.history, simulate(world, tiny_hull(), s, {}).history);
  REQUIRE(second.pictures.size() == 8);
  CHECK(second.pictures[0] == "ice_000.png");
  CHECK(second.picture_advance[0] < 0.2 * s.advance);
  const std::string pvd = read_text_file(files.folder.file("ice.pvd"));
  for (const char* step : {"ice_0000", "ice_0001", "ice_0002"}) CHECK(pvd.find(step) != std::string::npos);
}

TEST_CASE("a run with water, ice against ice and damped edges goes on as if it had not stopped") {
  const Communicator& world = test_world();
  Files files(world);
  Scenario s = slow();
  s.water.added_mass = 0.1;
  s.water.drag = 1.2;
  s.sheet.absorbing = 0.1;
  s.numerics.floe_contact = true;
  REQUIRE(files.interrupted(s, false).status == RunStatus::interrupted);
  const RunResult second = simulate(world, tiny_hull(), s, files.options);
  REQUIRE(second.status == RunStatus::ok);
  const History whole = simulate(world, tiny_hull(), s, {}).history;
  check_same_record(second.history, whole);
  CHECK(whole.rows.back().water_loss > 0.0);
  CHECK(whole.rows.back().edge_loss > 0.0);
}

TEST_CASE("a run that is stopped between two samples goes on as if it had not stopped") {
  const Communicator& world = test_world();
  Scenario s = slow();
  s.numerics.dt_fraction = 0.25;  // more than a hundred steps between two samples
  s.advance = 0.04;
  s.V = 1.0;
  s.sheet.window_ahead = s.sheet.length - 0.1;
  s.water.added_mass = 0.1;
  for (const bool floes : {false, true}) {
    s.numerics.floe_contact = floes;
    const History whole = simulate(world, tiny_hull(), s, {}).history;
    REQUIRE(whole.rows.size() > 4);
    for (const int looks : {1, 2}) {
      CAPTURE(floes, looks);
      Files files(world);
      RunOptions until = files.options;
      int asked = 0;
      until.stop = [&] { return ++asked == looks; };
      const RunResult first = simulate(world, tiny_hull(), s, until);
      REQUIRE(first.status == RunStatus::interrupted);
      CHECK(first.steps == looks * (floes ? pairs_every : 1));
      const RunResult second = simulate(world, tiny_hull(), s, files.options);
      if (world.is_root()) CHECK(files.resumed_at == first.steps);
      check_same_record(second.history, whole);
    }
  }
}

TEST_CASE("a checkpoint is written when it is asked for, and the run goes on") {
  const Communicator& world = test_world();
  Files files(world);
  files.options.checkpoint_every_s = 0.0;
  std::int64_t asked = 0;
  files.options.checkpoint_now = [&] { return ++asked == 2; };
  files.options.stop = [&] { return fs::exists(files.options.checkpoint_file); };
  const RunResult r = simulate(world, tiny_hull(), slow(), files.options);
  CHECK(r.status == RunStatus::interrupted);
  CHECK(r.steps > 2);
}

TEST_CASE("a voyage that is sailed on is the same as one that was long from the start") {
  const Communicator& world = test_world();
  Files files(world);
  Scenario s = slow();
  s.V = 1.0;
  s.sheet.window_ahead = s.sheet.length - 0.1;
  s.water.added_mass = 0.1;
  s.numerics.floe_contact = true;
  const double far = s.advance;
  files.options.to_be_sailed_on = true;
  s.advance = 0.6 * far;
  REQUIRE(simulate(world, tiny_hull(), s, files.options).status == RunStatus::ok);
  CHECK(fs::exists(files.options.checkpoint_file));
  CHECK(files.resumed_at == -1);

  s.advance = far;
  const RunResult longer = simulate(world, tiny_hull(), s, files.options);
  REQUIRE(longer.status == RunStatus::ok);
  if (world.is_root()) CHECK(files.resumed_at > longer.steps / 2);
  const RunResult straight = simulate(world, tiny_hull(), s, {});
  check_same_record(longer.history, straight.history);
  CHECK(longer.metrics.resistance.mean == straight.metrics.resistance.mean);
  CHECK(longer.metrics.resistance.ci95 == straight.metrics.resistance.ci95);
  CHECK(longer.linear_share == straight.linear_share);
  REQUIRE(longer.pictures.size() == 8);  // the last one of the longer voyage's end
  CHECK(longer.picture_advance.back() ==
        Approx(far).epsilon(0.01));  // the last step ends within a step's way of it
  CHECK(longer.picture_advance[7] > longer.picture_advance[6]);

  s.advance = 0.6 * far;
  CHECK_THROWS_WITH(simulate(world, tiny_hull(), s, files.options), Catch::Contains("of a longer voyage"));
}

TEST_CASE("a checkpoint of another run is refused in words, or passed over where that is asked for") {
  const Communicator& world = test_world();
  Files files(world);
  Scenario s = slow();
  REQUIRE(files.interrupted(s).status == RunStatus::interrupted);
  s.V = 0.75;
  s.advance = 0.06;
  CHECK_THROWS_AS(simulate(world, tiny_hull(), s, files.options), RuntimeError);
  CHECK_THROWS_WITH(simulate(world, tiny_hull(), s, files.options),
                    Catch::Contains(files.options.checkpoint_file) &&
                        Catch::Contains("V = 0.5 there, 0.75 here") && Catch::Contains("remove that file"));
  s.V = 0.5;
  CHECK_THROWS_WITH(simulate(world, sloping_box(0.46, 0.2, 0.08, 0.15, 1.2), slow(), files.options),
                    Catch::Contains("hull = "));
  CHECK(fs::exists(files.options.checkpoint_file));
  for (Resume resume : {Resume::if_usable, Resume::never}) {
    files.options.resume = resume;
    CHECK(simulate(world, tiny_hull(), s, files.options).status == RunStatus::ok);
  }
  CHECK(files.resumed_at == -1);
}

TEST_CASE("a file that is cut short is refused and stays as it is") {
  const Communicator& world = test_world();
  Files files(world);
  const std::string& path = files.options.checkpoint_file;
  REQUIRE(files.interrupted(slow()).status == RunStatus::interrupted);
  const auto size = fs::file_size(path);
  for (std::uintmax_t left : {size - 1000, size / 2, std::uintmax_t(100), std::uintmax_t(0)}) {
    world.barrier();
    if (world.is_root()) fs::resize_file(path, left);
    world.barrier();
    CHECK_THROWS_WITH(simulate(world, tiny_hull(), slow(), files.options),
                      Catch::Contains(path) && Catch::Contains("not a whole checkpoint"));
    CHECK(fs::file_size(path) == left);
  }
}

namespace {

void replace_file(const std::string& path, const std::string& content) {
  test_world().barrier();
  if (test_world().is_root()) write_text_file(path, content);
  test_world().barrier();
}

}  // namespace

TEST_CASE("a bit flipped or a block zeroed anywhere in a checkpoint is told, or changes nothing") {
  const Communicator& world = test_world();
  Files files(world);
  const Scenario s = slow_and_short();
  files.options.snapshots = files.options.pictures = 0;
  const std::string& path = files.options.checkpoint_file;
  REQUIRE(files.interrupted(s).status == RunStatus::interrupted);
  const std::string whole = read_text_file(path);
  const History expected = simulate(world, tiny_hull(), s, {}).history;
  int told = 0;
  for (int k = 0; k < 12; ++k) {
    std::string content = whole;
    const std::size_t at = (whole.size() * static_cast<std::size_t>(k) + 41) / 12;
    if (k % 3 == 0) {
      content.replace(at, 512, std::string(std::min<std::size_t>(512, content.size() - at), '\0'));
    } else {
      content[at] = static_cast<char>(content[at] ^ (1 << (k % 8)));
    }
    replace_file(path, content);
    try {
      check_same_record(simulate(world, tiny_hull(), s, files.options).history, expected);
    } catch (const RuntimeError& error) {
      ++told;
      CHECK_THAT(error.what(), Catch::Contains(path));
    }
  }
  CHECK(told > 6);  // the others fell where nothing is kept
}

TEST_CASE("a damaged checkpoint is set aside with a word where the run may start anew") {
  const Communicator& world = test_world();
  Files files(world);
  const Scenario s = slow_and_short();
  const std::string& path = files.options.checkpoint_file;
  REQUIRE(files.interrupted(s).status == RunStatus::interrupted);
  const std::string whole = read_text_file(path);
  const History expected = simulate(world, tiny_hull(), s, {}).history;
  files.options.resume = Resume::if_usable;
  std::string note;
  files.options.on_note = [&](const std::string& words) { note = words; };
  // Cut off, and in the middle of the ice, which is met when a part has been read.
  for (const std::size_t at : {std::size_t{0}, whole.size() / 2, whole.size() / 3}) {
    std::string content = whole;
    content.replace(at, 4096, std::string(4096, 'x'));
    replace_file(path, content);
    note.clear();
    const RunResult result = simulate(world, tiny_hull(), s, files.options);
    CHECK(result.status == RunStatus::ok);
    check_same_record(result.history, expected);
    if (world.is_root()) {
      CHECK_THAT(note, Catch::Contains("damaged") && Catch::Contains(path + ".damaged"));
      CHECK(read_text_file(path + ".damaged") == content);
    }
  }
}

TEST_CASE("a count in a checkpoint that is no count is damage") {
  const Communicator& world = test_world();
  const TestFolder folder(world, "counts");
  const std::string path = folder.file("checkpoint.h5");
  for (const char* steps : {"1e300", "-3", "2.5", "18446744073709551615", "\"7\"", "null"}) {
    ParallelFile file = ParallelFile::create(world, path);
    file.write_text("run", std::string(R"({"format":6,"precision_bytes":4,"steps":)") + steps + "}");
    file.write_text("case", "V = 1");
    file.close();
    bool damaged = false;
    INFO(steps);
    CHECK_THAT(why_not_resumable(world, path, "V = 1", 4, 100, &damaged),
               Catch::Contains("steps is no count"));
    CHECK(damaged);
    world.barrier();
  }
}

TEST_CASE("a checkpoint of another version, or without its counts, is told in words wherever it is read") {
  const Communicator& world = test_world();
  const TestFolder folder(world, "versions");
  const std::string path = folder.file("checkpoint.h5");
  const auto written = [&](const std::string& run) {
    ParallelFile file = ParallelFile::create(world, path);
    file.write_text("run", run);
    file.write_text("case", "V = 1");
    for (const char* list : {"history", "touches", "cracked_columns", "dropped_ice"})
      file.write_list(list, std::vector<double>());
    file.write_list("history_counts", std::vector<std::int64_t>());
    file.close();
  };
  Run run(world, slow());
  RunState state = run.state();
  for (const char* format : {"5", "null", "\"6\"", "{}"}) {
    INFO(format);
    written(std::string(R"({"format":)") + format + "}");
    const std::string words = std::string("of another version of the program (its format is ") + format +
                              ", that of this program 6)";
    CHECK_THAT(why_not_resumable(world, path, "V = 1", 4, 100), Catch::Contains("is " + words));
    CHECK_THROWS_WITH(load_checkpoint(world, path, state),
                      Catch::Contains(path) && Catch::Contains(words) && Catch::Contains("remove it"));
  }
  written(R"({"format":6,"precision_bytes":4})");
  CHECK(why_not_resumable(world, path, "V = 1", 4, 100) ==
        "is not a whole checkpoint (key 'steps' not found)");
}

TEST_CASE("the share of linear ice is that of the whole run, on any ranks and after an interruption") {
  const Communicator& world = test_world();
  Files files(world);
  files.options.snapshots = files.options.pictures = 0;
  const Scenario s = slow();
  const double expected = simulate(Communicator::serial(), tiny_hull(), s, {}).linear_share;
  CHECK(simulate(world, tiny_hull(), s, {}).linear_share == expected);
  RunOptions until = files.options;
  until.checkpoint_every_s = 0.02;
  int asked = 0;
  until.stop = [&] { return ++asked > 1; };
  if (simulate(world, tiny_hull(), s, until).status != RunStatus::interrupted) return;  // a fast machine
  CHECK(simulate(world, tiny_hull(), s, files.options).linear_share == expected);
  CHECK(expected > 0.0);
  CHECK(expected < 1.0);
}
