#include "study/evaluate/patch_tests.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <limits>

#include "base/errors.h"
#include "base/json.h"
#include "base/sha256.h"
#include "base/units.h"
#include "solver/run/simulation.h"
#include "study/evaluate/calibration.h"
#include "study/evaluate/cycle_run.h"
#include "study/evaluate/evaluation_key.h"

namespace icebow {
namespace {

namespace fs = std::filesystem;

constexpr int patch_tests_version = 2;           // raise it when the same ice would give another table
constexpr double slope = radians(45.0);          // of the plate: it drives the edge down as fast as it comes
constexpr double ahead_l = 2.5, beside_l = 2.0;  // of the sheet beyond the plate, over l; held there
constexpr double way_h = 3.0;                    // of the plate, at most
constexpr double nan_value = std::numeric_limits<double>::quiet_NaN();

// A block whose front slopes, foremost at the top; its waterline is at x = 0.
QuadMesh plate(double width, double deep, double high, double length) {
  QuadMesh mesh;
  const double tan = std::tan(slope);
  const int across = 8, up = 8;
  const auto point = [&](double s, double t, bool front) {
    const double z = -deep + t * (deep + high);
    return Vec3(front ? z / tan : -length, width * (s - 0.5), z);
  };
  const auto add = [&](const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
    const int n = static_cast<int>(mesh.points.size());
    mesh.points.insert(mesh.points.end(), {a, b, c, d});
    mesh.quads.push_back({n, n + 1, n + 2, n + 3});
    mesh.patch.push_back(Patch::bow);
  };
  for (int i = 0; i < across; ++i) {
    const double s0 = double(i) / across, s1 = double(i + 1) / across;
    for (int j = 0; j < up; ++j) {
      const double t0 = double(j) / up, t1 = double(j + 1) / up;
      add(point(s0, t0, true), point(s1, t0, true), point(s1, t1, true), point(s0, t1, true));
      add(point(s0, t0, false), point(s0, t1, false), point(s1, t1, false), point(s1, t0, false));
    }
    add(point(s0, 0, false), point(s1, 0, false), point(s1, 0, true), point(s0, 0, true));
    add(point(s0, 1, true), point(s1, 1, true), point(s1, 1, false), point(s0, 1, false));
  }
  for (int j = 0; j < up; ++j) {
    const double t0 = double(j) / up, t1 = double(j + 1) / up;
    add(point(1, t0, true), point(1, t0, false), point(1, t1, false), point(1, t1, true));
    add(point(0, t0, true), point(0, t1, true), point(0, t1, false), point(0, t0, false));
  }
  return mesh;
}

// The case's ice and solver, its ship and sheet replaced by the test's.
Case test_case(const Case& c, double width_h, double edge_speed) {
  Case t = c;
  t.bow = BowParameters(), t.own = OwnHull();
  const double l = cycle_ice(c).characteristic_length(), h = c.ice.h;
  t.V = edge_speed / std::tan(slope);
  t.advance = way_h * h;
  t.steady_from = 0.0;
  t.stop_when_ci95_below = 0.0;
  t.sheet = Sheet();
  t.sheet.length = ahead_l * l + t.advance;
  t.sheet.width = width_h * h + 2.0 * beside_l * l;
  t.sheet.fixed = FixedEdges::sides_and_far;
  t.sheet.half_model = true;
  t.seed = 0, t.snapshots = 0, t.pictures = 0;
  return t;
}

// Cracks across the way out that are half as long as the contact, and two thicknesses: the edge breaks with
// the first, and along the longest of those that open while the plate comes on by half a thickness from
// there.
const Crack* breaking_crack(const RunResult& run, double width, double h) {
  std::vector<const Crack*> across;
  for (const Crack& crack : run.process.cracks.list)
    if (crack.kind == CrackKind::circumferential && crack.length >= std::max(0.5 * width, 2.0 * h))
      across.push_back(&crack);
  if (across.empty()) return nullptr;
  const auto earlier = [](const Crack* a, const Crack* b) { return a->opened < b->opened; };
  const double first = (*std::min_element(across.begin(), across.end(), earlier))->opened;
  const Crack* longest = nullptr;
  for (const Crack* crack : across)
    if (crack->opened <= first + 0.5 * h && (!longest || crack->length > longest->length)) longest = crack;
  return longest;
}

cycle::PatchTest judged(const RunResult& run, const Scenario& s, double width, double strength, double l) {
  cycle::PatchTest test;
  test.capacity = test.length_l = nan_value;
  const Crack* crack = breaking_crack(run, width, s.ice.h);
  if (!crack) return test;
  double peak = 0.0;
  for (const HistoryRow& row : run.history.rows)
    if (row.advance <= crack->opened + 0.1 * s.ice.h) peak = std::max(peak, row.F[2]);
  test.capacity = peak / (strength * s.ice.h * s.ice.h);
  test.length_l = crack->from_hull / l;
  return test;
}

std::string table_text(const Case& c, const PatchPlan& plan) {
  std::string text = "patch_tests.version=" + std::to_string(patch_tests_version) + "\n" +
                     evaluation_text(test_case(c, 1.0, 1.0), {false, true});
  char line[64];
  for (double w : plan.widths_h) std::snprintf(line, sizeof line, "width=%a\n", w), text += line;
  for (double v : plan.edge_speeds) std::snprintf(line, sizeof line, "speed=%a\n", v), text += line;
  return text;
}

Json number(double value) {
  return std::isfinite(value) ? Json(value) : Json(nullptr);
}

Json to_json(const std::vector<cycle::PatchTest>& tests, const std::string& text) {
  Json list = Json::array();
  for (const cycle::PatchTest& t : tests)
    list.push_back({t.width_h, t.edge_speed, number(t.capacity), number(t.length_l)});
  return {{"of", sha256(text)}, {"tests", list}};
}

double value_of(const Json& json) {
  return json.is_number() ? json.get<double>() : nan_value;
}

// A file that is damaged, or of other ice, is as good as none.
bool recall(const std::string& file, const std::string& text, std::vector<cycle::PatchTest>& tests) {
  try {
    const Json stored = read_json_file(file);
    if (stored.at("of") != sha256(text)) return false;
    for (const Json& t : stored.at("tests"))
      tests.push_back({t.at(0).get<double>(), t.at(1).get<double>(), value_of(t.at(2)), value_of(t.at(3))});
    return !tests.empty();
  } catch (const std::exception&) {
    return false;
  }
}

void store(const fs::path& file, const Json& json) {
  try {
    fs::create_directories(file.parent_path());
    write_text_file(file.string(), json.dump(1) + "\n");
  } catch (const std::exception&) {
    // Found again next time.
  }
}

// What did not break gets the numbers of the nearest width at its speed that did; without one, none are left.
void fill(PatchTable& table) {
  char words[120];
  std::vector<cycle::PatchTest> kept;
  for (cycle::PatchTest t : table.tests) {
    if (!std::isfinite(t.capacity)) {
      const cycle::PatchTest* nearest = nullptr;
      for (const cycle::PatchTest& o : table.tests) {
        if (o.edge_speed != t.edge_speed || !std::isfinite(o.capacity)) continue;
        if (!nearest || std::abs(o.width_h - t.width_h) < std::abs(nearest->width_h - t.width_h))
          nearest = &o;
      }
      std::snprintf(words, sizeof words, "an edge pressed over %g h at %.3g m/s did not break within %g h",
                    t.width_h, t.edge_speed, way_h);
      table.notes.push_back(words);
      if (!nearest) continue;
      t.capacity = nearest->capacity, t.length_l = nearest->length_l;
    }
    kept.push_back(t);
  }
  table.tests = std::move(kept);
}

}  // namespace

PatchPlan patch_plan(const Case& c) {
  PatchPlan plan;
  const double fastest = std::max(0.1, 0.6 * c.V);
  for (double part : {0.1, 0.33, 1.0}) plan.edge_speeds.push_back(part * fastest);
  return plan;
}

cycle::PatchTest patch_test(const Communicator& comm, const Case& c, double width_h, double edge_speed) {
  const Case t = test_case(c, width_h, edge_speed);
  const Scenario s = simulated_scenario(comm, t);
  const double h = s.ice.h, width = width_h * h;
  const RunResult run = simulate(comm, plate(width, 3.0 * h, 2.0 * h, 6.0 * h), s, {});
  if (run.status != RunStatus::ok) throw InputError("patch test of the ice's edge: " + run.reason);
  const double strength = to_model_scale(c.flexural_strength, c.lambda, scaling::stress);
  const double l = to_model_scale(cycle_ice(c).characteristic_length(), c.lambda, scaling::length);
  cycle::PatchTest test = judged(run, s, width, strength, l);
  test.width_h = width_h, test.edge_speed = edge_speed;
  return test;
}

PatchTable patch_table(const Communicator& comm, const Case& c, const PatchPlan& plan,
                       const std::string& directory,
                       const std::function<void(double width_h, double edge_speed)>& on_test) {
  PatchTable table;
  const std::string text = table_text(c, plan);
  const fs::path file = fs::path(directory) / ("patch-" + sha256(text) + ".json");
  bool known = comm.is_root() && !directory.empty() && recall(file.string(), text, table.tests);
  known = comm.any(known);
  if (known) {
    const Json all =
        Json::parse(comm.broadcast(comm.is_root() ? to_json(table.tests, text).dump() : std::string()));
    table.tests.clear();
    for (const Json& t : all.at("tests"))
      table.tests.push_back(
          {t.at(0).get<double>(), t.at(1).get<double>(), value_of(t.at(2)), value_of(t.at(3))});
    table.recalled = true;
  } else {
    for (double width : plan.widths_h) {
      for (double speed : plan.edge_speeds) {
        if (on_test && comm.is_root()) on_test(width, speed);
        table.tests.push_back(patch_test(comm, c, width, speed));
      }
    }
    if (comm.is_root() && !directory.empty()) store(file, to_json(table.tests, text));
  }
  fill(table);
  return table;
}

cycle::BreakingRule cycle_rule(const Communicator& comm, const Case& c) {
  cycle::BreakingRule rule = c.cycle.rule;
  if (rule.type != cycle::Breaking::calibrated) return rule;
  rule.table = patch_table(comm, c, patch_plan(c), calibration_directory()).tests;
  return rule;
}

}  // namespace icebow
