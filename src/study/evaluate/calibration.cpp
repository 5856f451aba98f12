#include "study/evaluate/calibration.h"

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <set>

#include "base/errors.h"
#include "base/sha256.h"
#include "base/text.h"
#include "base/units.h"
#include "solver/tank/virtual_tests.h"
#include "study/evaluate/evaluator_inputs.h"
#include "study/spec/spec_hints.h"

namespace icebow {
namespace {

namespace fs = std::filesystem;

// Six digits: the last ones hang on the vector width of the machine.
double to_six_digits(double value) {
  return std::strtod(text("%.5e", value).c_str(), nullptr);
}

LatticeNumbers measured(Scenario s) {
  s.ice.tensile_strength = 1e-3 * s.ice.E;  // any: strengths are in proportion to it
  s.ice.crushing_pressure = 0.0;
  const double modulus = virtual_plate_test(s);
  const BeamTest beam = virtual_beam_test(s);
  const CompressionTest prism = virtual_compression_test(s);
  const double stress = s.ice.tensile_strength;
  return {to_six_digits(modulus / s.ice.E), to_six_digits(beam.flexural_strength / stress),
          to_six_digits(prism.compressive_strength / stress)};
}

Json to_json(const LatticeNumbers& n, const std::string& text) {
  return {{"lattice", text},
          {"modulus_over_E", n.modulus},
          {"flexural_over_tensile", n.flexural},
          {"compressive_over_tensile", n.compressive}};
}

// Of bonds that break by stretch: the held beam's flexural strength over E times the critical stretch.
double measured_by_stretch(Scenario s) {
  s.ice.tensile_strength = s.ice.crushing_pressure = 0.0;
  s.ice.K_I = 0.0;
  s.ice.s0 = 1e-3;  // any: the strength is in proportion to it
  return to_six_digits(virtual_beam_test(s).flexural_strength / (s.ice.E * s.ice.s0));
}

LatticeNumbers numbers_from(const Json& json) {
  return {json.at("modulus_over_E").get<double>(), json.at("flexural_over_tensile").get<double>(),
          json.at("compressive_over_tensile").get<double>()};
}

// A file that is damaged, or of another lattice, is as good as none.
template <class Numbers, class Read>
bool recall(const std::string& file, const std::string& text, Numbers& numbers, const Read& read) {
  try {
    Json stored = read_json_file(file);
    const Json digest = stored.at("digest");
    stored.erase("digest");
    if (digest != sha256(stored.dump()) || stored.at("lattice") != text) return false;
    numbers = read(stored);
    return true;
  } catch (const std::exception&) {
    return false;
  }
}

void store(const fs::path& file, const Json& numbers) {
  try {
    fs::create_directories(file.parent_path());
    Json json = numbers;
    json["digest"] = sha256(json.dump());  // a flipped digit would be another ice
    write_text_file(file.string(), json.dump(2) + "\n");
  } catch (const std::exception&) {
    // Found again next time.
  }
}

fs::path cache_file(const std::string& directory, const std::string& text) {
  return fs::path(directory) / (sha256(text) + ".json");
}

Json found_on_root(const Scenario& s) {
  try {
    return to_json(lattice_numbers(s, calibration_directory()), "");
  } catch (const std::exception& error) {
    return {{"error", error.what()}};
  }
}

}  // namespace

std::string lattice_text(const Scenario& s) {
  return text("virtual_tests.version=%d\nlayers=%ld\nhorizon_ratio=%a\nnu=%a\nsurface_correction=%s\n",
              virtual_tests_version, std::lround(s.ice.h / s.numerics.dx), s.numerics.horizon_ratio, s.ice.nu,
              s.numerics.surface_correction ? "true" : "false");
}

std::string calibration_directory() {
  const char *cache = std::getenv("XDG_CACHE_HOME"), *home = std::getenv("HOME");
  const bool has_cache = cache && *cache, has_home = home && *home;
  if (!has_cache && !has_home) return "";
  return ((has_cache ? fs::path(cache) : fs::path(home) / ".cache") / "icebow" / "calibrations").string();
}

LatticeNumbers lattice_numbers(const Scenario& s, const std::string& directory) {
  const std::string text = lattice_text(s);
  const fs::path file = cache_file(directory, text);
  LatticeNumbers numbers;
  if (!directory.empty() && recall(file.string(), text, numbers, numbers_from)) return numbers;
  numbers = measured(s);
  if (!directory.empty()) store(file, to_json(numbers, text));
  return numbers;
}

double strength_by_stretch(const Scenario& s, const std::string& directory) {
  const long layers = std::lround(s.ice.h / s.numerics.dx);
  if (layers < 2 || layers > most_tested_layers) return std::nan("");
  const std::string text = lattice_text(s) + "bonds break by stretch\n";
  const char* const name = "flexural_over_E_stretch";
  const fs::path file = cache_file(directory, text);
  double ratio = 0.0;
  const auto read = [&](const Json& stored) { return stored.at(name).get<double>(); };
  if (directory.empty() || !recall(file.string(), text, ratio, read)) {
    ratio = measured_by_stretch(s);
    if (!directory.empty()) store(file, {{"lattice", text}, {name, ratio}});
  }
  return ratio * s.ice.E * critical_stretch(s);
}

void test_lattices(const std::vector<Case>& cases) {
  std::set<std::string> tested;
  for (const Case& c : cases) {
    const Scenario s = model_scenario(c);
    if (c.ice_model != IceModel::calibrated || !tested.insert(lattice_text(s)).second) continue;
    try {
      lattice_numbers(s, calibration_directory());
    } catch (const std::exception&) {
      // evaluate() meets it again.
    }
  }
}

IceMaterial calibrated_ice(const IceMaterial& ice, double flexural_strength, const LatticeNumbers& numbers) {
  constexpr double lowest = 1e-6, highest = 0.05;  // tensile strength over modulus
  IceMaterial found = ice;
  found.E = ice.E / numbers.modulus;
  found.tensile_strength = flexural_strength / numbers.flexural;
  found.s0 = found.K_I = 0.0;
  const double strain = found.tensile_strength / found.E,
               inner_strength = numbers.compressive * found.tensile_strength;
  const std::string of = "calibrated ice of flexural strength " + brief(flexural_strength) + " Pa";
  if (!(strain >= lowest && strain <= highest)) {
    throw InputError("/ice/flexural_strength: " + of + " and elastic modulus " + brief(ice.E) +
                     " Pa (simulated scale) breaks at a strain of " + brief(strain) + ", allowed " +
                     brief(lowest) + " to " + brief(highest) +
                     (strain < lowest ? "; raise the strength or lower /ice/elastic_modulus"
                                      : "; lower the strength or raise /ice/elastic_modulus"));
  }
  if (ice.crushing_pressure > inner_strength) {
    throw InputError("/ice/compressive_strength: " + brief(ice.crushing_pressure) + " Pa, but " + of +
                     " (simulated scale) splits at " + brief(inner_strength) +
                     " Pa on this lattice; lower the compressive strength or raise the flexural one");
  }
  return found;
}

Scenario simulated_scenario(const Communicator& comm, const Case& full) {
  Scenario s = model_scenario(full);
  if (full.ice_model != IceModel::calibrated) return s;
  const Json found = Json::parse(comm.broadcast(comm.is_root() ? found_on_root(s).dump() : std::string()));
  if (found.contains("error")) throw InputError(found.at("error").get<std::string>());
  const double flexural = to_model_scale(full.flexural_strength, full.lambda, scaling::stress);
  s.ice = calibrated_ice(s.ice, flexural, numbers_from(found));
  return s;
}

Json simulated_ice_json(const Communicator& comm, const Case& full, const Scenario& s) {
  const auto kilopascals = [](double pascals) { return brief(std::round(pascals / 1e3)) + " kPa"; };
  const double asked = full.flexural_strength;
  if (full.ice_model == IceModel::calibrated)
    return {{"model", "calibrated"},
            {"flexural_strength_Pa", asked},
            {"sentence", "ice: calibrated to a flexural strength of " + kilopascals(asked)}};
  double found = comm.is_root() ? strength_by_stretch(s, calibration_directory()) : 0.0;
  comm.broadcast(&found, sizeof found);
  const double full_scale = to_full_scale(found, full.lambda, scaling::stress);
  const std::string formula = kilopascals(asked) + " of the formula";
  if (!std::isfinite(found))
    return {{"model", "paper"},
            {"flexural_strength_Pa", nullptr},
            {"sentence", "ice: the published model, whose flexural strength is not known on a lattice of " +
                             std::to_string(std::lround(s.ice.h / s.numerics.dx)) +
                             " layers; do not take it for the " + formula}};
  return {
      {"model", "paper"},
      {"flexural_strength_Pa", full_scale},
      {"sentence",
       "ice: the published model; by the virtual beam test of this lattice it has a flexural strength of " +
           kilopascals(full_scale) + ", which is " + brief(std::round(10.0 * full_scale / asked) / 10.0) +
           " times the " + formula + ": the two loads are of unlike ice"}};
}

}  // namespace icebow
