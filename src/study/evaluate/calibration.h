// Ice given by what an ice tank measures: the modulus and the tensile strength with which the virtual tests
// of solver/tank/virtual_tests.h return the elastic modulus and the flexural strength asked for.
//
// The tests are linear between one broken bond and the next, so what they measure is E or the tensile
// strength times a number of the lattice alone (docs/theory.md, "Ice by its tests"). The numbers are stored
// under the SHA-256 of all they depend on and serve every ice and every design on that lattice.
#pragma once

#include <string>
#include <vector>

#include "base/communicator.h"
#include "study/spec/study_spec.h"

namespace icebow {

// Raise it when the same lattice would give other numbers.
constexpr int virtual_tests_version = 3;

// What the tests of a lattice measure, over the input of its bonds.
struct LatticeNumbers {
  double modulus = 0.0;      // that of the plate's deflection / E
  double flexural = 0.0;     // the held beam's flexural strength / tensile strength
  double compressive = 0.0;  // at which the ice itself, not its surface, fails / tensile strength
};

// Text of all the numbers depend on: layers, horizon ratio, Poisson's ratio, surface correction.
std::string lattice_text(const Scenario& scenario);

// $XDG_CACHE_HOME/icebow/calibrations, or that below ~/.cache; empty where neither is set.
std::string calibration_directory();

// Read from the directory, or found by the tests (seconds to minutes) and stored there. A directory that is
// empty or cannot be written only means that the next call takes as long.
LatticeNumbers lattice_numbers(const Scenario& scenario, const std::string& directory);

// Finds and stores the numbers of every lattice on which these cases simulate calibrated ice. A study does so
// before its first design, lest designs that run side by side each do the same tests. A test that fails is
// not reported here: the design that needs it fails with the reason.
void test_lattices(const std::vector<Case>& cases);

// The ice with the modulus and tensile strength that measure as `ice.E` and `flexural_strength` [Pa]. Throws
// InputError where it would break at a strain that the solver does not take, or fail within before its
// surface is crushed.
IceMaterial calibrated_ice(const IceMaterial& ice, double flexural_strength, const LatticeNumbers& numbers);

// Flexural strength that ice of the published model, whose bonds break by stretch, has in the virtual beam
// test of its lattice [Pa]; NaN for lattices of other than 2 to most_tested_layers layers. Read or found and
// stored likewise.
double strength_by_stretch(const Scenario& scenario, const std::string& directory);

// Of the ice that a case simulates, full scale: "model", "flexural_strength_Pa" by the virtual beam test
// (null where that is not known) and a "sentence" for people. Collective; the root alone tests and reads.
Json simulated_ice_json(const Communicator& comm, const Case& full, const Scenario& scenario);

// What is simulated for a case: model scale, calibrated ice with what was found. Collective; the root alone
// tests and reads. Throws InputError on every rank.
Scenario simulated_scenario(const Communicator& comm, const Case& full);

}  // namespace icebow
