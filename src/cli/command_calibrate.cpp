#include <chrono>
#include <cmath>
#include <iostream>
#include <optional>

#include "base/units.h"
#include "cli/calibrate_cycle.h"
#include "cli/commands.h"
#include "cli/study_choice.h"
#include "cli/text_table.h"
#include "solver/model/plate_on_water.h"
#include "solver/tank/virtual_tests.h"
#include "study/evaluate/calibration.h"
#include "study/spec/spec_hints.h"

namespace icebow {
namespace {

struct Properties {
  double elastic_modulus, flexural_strength, compressive_strength;  // [Pa]; 0 = none
};

struct InSitu {
  double strength_up, strength_down, modulus;  // [Pa]
};

// Tests of the sheet as it floats.
struct Afloat {
  double characteristic_length;  // with the plate's modulus [m]
  std::optional<InSitu> in_situ;
};

// What one ice is asked to be and what it measures, at the scale of the study's section "ice".
struct Comparison {
  Case description;
  Scenario simulated;  // at the scale that is simulated
  Properties requested, measured;
  double beam_modulus;  // of the held beam [Pa]
  Afloat afloat;
  int beam_breaks, prism_breaks;
  double seconds;
  std::string scale;  // "full", "model"
  double lambda;      // that scale / simulated scale
};

Afloat test_afloat(const Scenario& s, double modulus, double lambda, bool in_situ) {
  const auto pascals = [&](double value) { return to_full_scale(value, lambda, scaling::stress); };
  const double h = std::lround(s.ice.h / s.numerics.dx) * s.numerics.dx,
               ell = characteristic_length(plate_on_water(modulus, s.ice.nu, h, s.water.rho));
  Afloat found = {to_full_scale(ell, lambda, scaling::length), {}};
  if (in_situ) {
    found.in_situ =
        InSitu{pascals(virtual_in_situ_test(s, Push::up).flexural_strength),
               pascals(virtual_in_situ_test(s, Push::down).flexural_strength), pascals(in_situ_modulus(s))};
  }
  return found;
}

Comparison compare(const ChosenDesign& chosen, bool in_situ) {
  const auto begin = std::chrono::steady_clock::now();
  Comparison c;
  c.description = chosen.description;
  c.simulated = simulated_scenario(Communicator::serial(), c.description);
  c.scale = chosen.design.document.at("ice").value("scale", "full");
  c.lambda = c.scale == "model" ? 1.0 : c.description.lambda;
  const double modulus = virtual_plate_test(c.simulated);
  const BeamTest beam = virtual_beam_test(c.simulated);
  const CompressionTest prism = virtual_compression_test(c.simulated);
  const auto from_full = [&](double pascals) {
    return to_model_scale(pascals, c.description.lambda / c.lambda, scaling::stress);
  };
  const auto from_model = [&](double pascals) { return to_full_scale(pascals, c.lambda, scaling::stress); };
  c.requested = {from_full(c.description.ice.E), from_full(c.description.flexural_strength),
                 from_full(c.description.compressive_strength)};
  c.measured = {from_model(modulus), from_model(beam.flexural_strength),
                from_model(prism.compressive_strength)};
  c.beam_modulus = from_model(beam.elastic_modulus);
  c.afloat = test_afloat(c.simulated, modulus, c.lambda, in_situ);
  c.beam_breaks = beam.breaks;
  c.prism_breaks = prism.breaks;
  c.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  return c;
}

double input_modulus(const Comparison& c) {
  return to_full_scale(c.simulated.ice.E, c.lambda, scaling::stress);
}

// Strength of bonds that break by stress, at the scale of the study's section "ice".
double input_strength(const Comparison& c) {
  return to_full_scale(c.simulated.ice.tensile_strength, c.lambda, scaling::stress);
}

double input_crushing_pressure(const Comparison& c) {
  return to_full_scale(c.simulated.ice.crushing_pressure, c.lambda, scaling::stress);
}

bool breaks_by_stress(const Comparison& c) {
  return c.simulated.ice.tensile_strength > 0.0;
}

Json input_json(const Comparison& c) {
  Json json = {{"elastic_modulus_Pa", input_modulus(c)}};
  if (breaks_by_stress(c)) {
    json["tensile_strength_Pa"] = input_strength(c);
  } else {
    json["critical_stretch"] = critical_stretch(c.simulated);
  }
  if (c.simulated.ice.crushing_pressure > 0.0) json["crushing_pressure_Pa"] = input_crushing_pressure(c);
  return json;
}

long layers(const Comparison& c) {
  return std::lround(c.simulated.ice.h / c.simulated.numerics.dx);
}

double spacing(const Comparison& c) {
  return to_full_scale(c.simulated.numerics.dx, c.lambda, scaling::length);
}

double buoyancy(const Comparison& c) {
  const Scenario& s = c.simulated;
  return buoyancy_share(to_model_scale(c.beam_modulus, c.lambda, scaling::stress), layers(c) * s.numerics.dx,
                        s.water.rho);
}

const char* model_name(const Comparison& c) {
  return c.description.ice_model == IceModel::calibrated ? "calibrated" : "paper";
}

Json properties_json(const Properties& p) {
  Json json = {{"elastic_modulus_Pa", p.elastic_modulus}, {"flexural_strength_Pa", p.flexural_strength}};
  json["compressive_strength_Pa"] =
      p.compressive_strength > 0.0 ? Json(p.compressive_strength) : Json(nullptr);
  return json;
}

Json measured_json(const Comparison& c) {
  Json json = properties_json(c.measured);
  json["held_beam_modulus_Pa"] = c.beam_modulus;
  json["characteristic_length_m"] = c.afloat.characteristic_length;
  if (const auto& in_situ = c.afloat.in_situ) {
    json["in_situ_flexural_strength_up_Pa"] = in_situ->strength_up;
    json["in_situ_flexural_strength_down_Pa"] = in_situ->strength_down;
    json["in_situ_modulus_Pa"] = in_situ->modulus;
  }
  return json;
}

Json to_json(const Comparison& c, const std::string& design) {
  return {{"design", design},
          {"model", model_name(c)},
          {"scale", c.scale},
          {"requested", properties_json(c.requested)},
          {"measured", measured_json(c)},
          {"input", input_json(c)},
          {"spacing_m", spacing(c)},
          {"layers", layers(c)},
          {"buoyancy_share_left_out", buoyancy(c)},
          {"beam_breaks", c.beam_breaks},
          {"prism_breaks", c.prism_breaks},
          {"wall_s", c.seconds}};
}

std::string for_people(const Comparison& c, const std::string& design) {
  const auto row = [](const char* name, double requested, double measured) {
    const bool given = requested > 0.0;
    return std::vector<std::string>{name, given ? brief(requested / 1e3) : "-", brief(measured / 1e3),
                                    given ? decimals(measured / requested, 3) : "-"};
  };
  const Properties &r = c.requested, &m = c.measured;
  std::vector<std::vector<std::string>> rows = {
      {"kPa", "requested", "measured", "ratio"},
      row("elastic modulus", r.elastic_modulus, m.elastic_modulus),
      row("flexural strength", r.flexural_strength, m.flexural_strength),
      row("compressive strength", r.compressive_strength, m.compressive_strength),
      row("modulus, held beam", r.elastic_modulus, c.beam_modulus)};
  if (const auto& in_situ = c.afloat.in_situ) {
    rows.push_back(row("strength in situ, up", r.flexural_strength, in_situ->strength_up));
    rows.push_back(row("strength in situ, down", r.flexural_strength, in_situ->strength_down));
    rows.push_back(row("modulus in situ", r.elastic_modulus, in_situ->modulus));
  }
  std::string text = design + ": ice of the model " + model_name(c) + ", " + c.scale + " scale, " +
                     std::to_string(layers(c)) + " layers of " + brief(spacing(c)) + " m\n\n";
  text += text_table(rows);
  text += "\nsimulated with: modulus " + brief(input_modulus(c) / 1e3) + " kPa, " +
          (breaks_by_stress(c) ? "tensile strength of bonds " + brief(input_strength(c) / 1e3) + " kPa"
                               : "critical stretch " + brief(critical_stretch(c.simulated)));
  if (c.simulated.ice.crushing_pressure > 0.0)
    text += ", crushing pressure " + brief(input_crushing_pressure(c) / 1e3) + " kPa";
  text += "\n";
  text += "virtual tests: plate afloat under a load; cantilever 7 h x 2 h, " + std::to_string(c.beam_breaks) +
          " breaks; prism 4 h x 2 h, " + std::to_string(c.prism_breaks) + " breaks; " +
          decimals(c.seconds, 1) + " s\n";
  text += "Characteristic length of the sheet: " + brief(c.afloat.characteristic_length) + " m.\n";
  text += "The beam is dry; in water it would be stiffer by " + decimals(100.0 * buoyancy(c), 1) + " %.\n";
  if (c.afloat.in_situ)
    text +=
        "In situ the sheet gives way at the root, which the modulus takes for the beam's, and sides made by "
        "a cut are soft.\n";
  if (!breaks_by_stress(c))
    text += "Bonds that break by stretch have one strength: the others follow from it and cannot be set.\n";
  return text;
}

}  // namespace

int run_calibrate(const Communicator&, const Arguments& arguments) {
  const ChosenDesign chosen = choose_design(load_study(arguments), arguments);
  if (arguments.has("--cycle")) return calibrate_cycle(chosen, arguments.has("--json"));
  const Comparison c = compare(chosen, arguments.has("--in-situ"));
  if (arguments.has("--json")) {
    std::cout << json_text(to_json(c, chosen.design.name), 2) << "\n";
  } else {
    std::cout << for_people(c, chosen.design.name);
  }
  return exit_code::ok;
}

}  // namespace icebow
