// Ice given by an ice tank's tests.
#include "study/evaluate/calibration.h"

#include <unistd.h>

#include <catch2/catch.hpp>
#include <filesystem>

#include "base/sha256.h"
#include "solver/tank/virtual_tests.h"
#include "study/evaluate/evaluator_inputs.h"
#include "study/spec/spec_case.h"
#include "tests/support/fake_study.h"

using namespace icebow;

namespace {

namespace fs = std::filesystem;

Case calibrated_case(const std::string& solver = R"({"layers": 2})") {
  Json document = fake_document(R"({"ice": {"scale": "model", "thickness_m": 0.04, "model": "calibrated",
    "elastic_modulus_MPa": 35, "flexural_strength_kPa": 35}})");
  document["solver"] = Json::parse(solver);
  return read_case(document, "t.json");
}

class Scratch {
 public:
  Scratch() : path_(fs::temp_directory_path() / ("icebow_calibration_" + std::to_string(getpid()))) {}
  ~Scratch() { fs::remove_all(path_); }
  std::string str() const { return path_.string(); }

 private:
  fs::path path_;
};

}  // namespace

TEST_CASE("calibrated ice measures as it was asked to") {
  for (const int layers : {3, 4}) {
    const Scenario s = model_scenario(calibrated_case("{\"layers\": " + std::to_string(layers) + "}"));
    const LatticeNumbers numbers = lattice_numbers(s, "");
    for (const double strength : {20e3, 35e3, 80e3}) {
      if (layers > 3 && strength != 35e3) continue;  // as much in proportion as with three
      Scenario found = s;
      found.ice = calibrated_ice(s.ice, strength, numbers);
      const BeamTest beam = virtual_beam_test(found);
      INFO(layers << " layers, " << strength << " Pa: found E " << found.ice.E << " Pa, s0 " << found.ice.s0);
      CHECK(virtual_plate_test(found) == Approx(s.ice.E).epsilon(0.01));  // found 1.000; equilibrium, to 1e-6
      CHECK(beam.flexural_strength == Approx(strength).epsilon(0.01));    // likewise
      CHECK(found.ice.E > s.ice.E);                                       // few layers bend too easily
      if (layers > 3 || strength != 35e3) continue;
      for (const double compressive : {60e3, 105e3, 250e3}) {
        Scenario crushed = s;
        crushed.ice.crushing_pressure = compressive;
        crushed.ice = calibrated_ice(crushed.ice, strength, numbers);
        CHECK(virtual_compression_test(crushed).compressive_strength ==
              Approx(compressive).epsilon(0.1));  // particles of the faces are counted whole
      }
    }
  }
}

TEST_CASE("numbers of a lattice are stored, and found again where they were not spoilt") {
  const Scratch directory;
  Scenario s = model_scenario(calibrated_case());
  const LatticeNumbers numbers = lattice_numbers(s, directory.str());
  const fs::path file = fs::path(directory.str()) / (sha256(lattice_text(s)) + ".json");
  Json stored = read_json_file(file.string());
  CHECK(stored.at("modulus_over_E") == numbers.modulus);
  s.ice.E *= 2.0;  // the same lattice
  stored["modulus_over_E"] = 0.25;
  write_text_file(file.string(), stored.dump());  // a digit that a disk has changed
  CHECK(lattice_numbers(s, directory.str()).modulus == numbers.modulus);
  stored = read_json_file(file.string());
  stored["modulus_over_E"] = 0.25;
  stored.erase("digest");
  stored["digest"] = sha256(stored.dump());
  write_text_file(file.string(), stored.dump());
  CHECK(lattice_numbers(s, directory.str()).modulus == 0.25);
  write_text_file(file.string(), "half a fi");
  CHECK(lattice_numbers(s, directory.str()).flexural == Approx(numbers.flexural));
}

TEST_CASE("another lattice has other numbers") {
  const Scenario s = model_scenario(calibrated_case());
  Scenario nu = s, layers = s, horizon = s, bare = s, size = s;
  nu.ice.nu = 0.3;
  layers.numerics.dx *= 0.5;
  horizon.numerics.horizon_ratio = 2.5;
  bare.numerics.surface_correction = false;
  size.ice.h *= 3.0;
  size.numerics.dx *= 3.0;
  for (const Scenario& other : {nu, layers, horizon, bare}) CHECK(lattice_text(other) != lattice_text(s));
  CHECK(lattice_text(size) == lattice_text(s));
}

TEST_CASE("ice that would break at a strain out of all range is refused, saying what to change") {
  const IceMaterial ice = model_scenario(calibrated_case()).ice;
  const LatticeNumbers numbers = {0.7, 1.1, 12.0};
  CHECK_THROWS_WITH(calibrated_ice(ice, 10.0, numbers),
                    Catch::Contains("1e-06 to 0.05") && Catch::Contains("raise the strength"));
  CHECK_THROWS_WITH(calibrated_ice(ice, 1e9, numbers), Catch::Contains("lower the strength"));
}

TEST_CASE("ice that would split before its surface is crushed is refused, saying what to change") {
  IceMaterial ice = model_scenario(calibrated_case()).ice;
  const LatticeNumbers numbers = {0.7, 1.1, 12.0};
  ice.crushing_pressure = 11.0 * 35e3;
  CHECK_THROWS_WITH(calibrated_ice(ice, 35e3, numbers),
                    Catch::Contains("/ice/compressive_strength") && Catch::Contains("381818") &&
                        Catch::Contains("lower the compressive strength"));
  ice.crushing_pressure = 10.0 * 35e3;
  CHECK(calibrated_ice(ice, 35e3, numbers).tensile_strength == Approx(35e3 / 1.1));
}

TEST_CASE(
    "calibrated ice is crushed at its compressive strength, three times the flexural one if not given") {
  CHECK(calibrated_case().numerics.contact == ContactRule::crushing);
  CHECK(model_scenario(calibrated_case()).ice.crushing_pressure == Approx(3 * 35e3));
  const Case relocated = calibrated_case(R"({"layers": 2, "contact": "relocation"})");
  CHECK(relocated.ice.crushing_pressure == 0.0);
}

TEST_CASE("ice as given is simulated as given") {
  const Case paper = fake_study().baseline;
  const Scenario s = simulated_scenario(Communicator::serial(), paper);
  CHECK(s.ice.E == model_scenario(paper).ice.E);
  CHECK(s.ice.K_I == model_scenario(paper).ice.K_I);
}
