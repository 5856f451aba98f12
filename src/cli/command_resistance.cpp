#include <cmath>
#include <iostream>
#include <limits>

#include "base/units.h"
#include "cli/commands.h"
#include "cli/study_choice.h"
#include "cli/text_table.h"
#include "formula/fsicr_channel.h"
#include "formula/lindqvist.h"
#include "formula/riska.h"
#include "geometry/mesh_slice.h"
#include "study/evaluate/cycle_run.h"
#include "study/evaluate/evaluator_inputs.h"
#include "study/evaluate/patch_tests.h"
#include "study/evaluate/result_json.h"
#include "study/spec/case_hull.h"
#include "study/spec/spec_hints.h"

namespace icebow {
namespace {

struct Answers {
  LindqvistInputs inputs;
  LindqvistResult lindqvist;
  RiskaInputs riska_inputs;
  RiskaResult riska;
  ChannelInputs channel_inputs;
  ChannelResult channel;
  CycleOutcome cycle;
};

// Of the waterline. The midbody is parallel where the hull has at least 99.5 % of its largest beam.
struct WaterlineForm {
  double parallel = 0.0;   //!< length of the parallel midbody [m]
  double foreship = 0.0;   //!< length ahead of it [m]
  double fore_area = 0.0;  //!< ahead of it [m^2]
};

// Between a line and the chord of its ends [m^2].
double enclosed(const Polyline& line) {
  double twice = 0.0;
  for (std::size_t k = 0; k < line.size(); ++k) {
    const Vec3 &p = line[k], &q = line[(k + 1) % line.size()];
    twice += p.x() * q.y() - q.x() * p.y();
  }
  return std::abs(twice) / 2.0;
}

WaterlineForm waterline_form(const QuadMesh& hull) {
  double widest = 0.0, stem = -std::numeric_limits<double>::infinity(), first = stem, last = -stem;
  const auto lines = slice(hull, 2, 0.0);
  for (const Polyline& line : lines)
    for (const Vec3& p : line) widest = std::max(widest, std::abs(p.y())), stem = std::max(stem, p.x());
  for (const Polyline& line : lines) {
    for (const Vec3& p : line) {
      if (std::abs(p.y()) < 0.995 * widest) continue;
      first = std::max(first, p.x()), last = std::min(last, p.x());
    }
  }
  WaterlineForm form;
  if (!(first > last)) return form;
  form.parallel = first - last, form.foreship = stem - first;
  for (const Polyline& line : lines)
    for (const Polyline& part : clipped(line, 0, first)) form.fore_area += enclosed(part);
  return form;
}

RiskaInputs riska_inputs(const Case& c, const WaterlineForm& form) {
  RiskaInputs in;
  in.L = c.bow.L, in.B = c.bow.B, in.T = c.bow.T, in.L_bow = c.bow.Lf, in.stem = c.bow.angles.stem;
  in.L_par = form.parallel;
  in.h = c.ice.h, in.V = c.V;
  return in;
}

ChannelInputs channel_inputs(const Case& c, const WaterlineForm& form) {
  ChannelInputs in;
  in.L = c.bow.L, in.B = c.bow.B, in.T = c.bow.T;
  in.L_bow = form.foreship, in.L_par = form.parallel, in.A_wf = form.fore_area;
  in.waterline = c.bow.angles.waterline, in.stem = c.bow.angles.stem, in.buttock = c.bow.angles.buttock;
  return in;
}

Answers answers(const Case& c) {
  Answers a;
  a.inputs = lindqvist_inputs(c);
  a.lindqvist = lindqvist(a.inputs);
  const Hull hull = make_hull(c);
  const WaterlineForm form = hull.status == HullStatus::ok ? waterline_form(hull.mesh) : WaterlineForm{};
  a.riska_inputs = riska_inputs(c, form);
  a.riska = riska_1997(a.riska_inputs);
  a.channel_inputs = channel_inputs(c, form);
  a.channel = fsicr_channel(a.channel_inputs);
  if (hull.status == HullStatus::ok) {
    a.cycle = run_cycle(c, hull.mesh, cycle_rule(Communicator::serial(), c));
  } else {
    a.cycle.reason = "there is no hull: " + hull.reason;
  }
  return a;
}

Json riska_json(const Answers& a) {
  const auto force = [&](double value) { return a.riska.valid ? Json(value) : Json(nullptr); };
  return {{"at_rest_N", force(a.riska.C1)},
          {"total_N", force(a.riska.total)},
          {"parallel_length_m", a.riska_inputs.L_par},
          {"bow_length_m", a.riska_inputs.L_bow},
          {"valid", a.riska.valid},
          {"reason", a.riska.reason}};
}

Json channel_json(const Answers& a) {
  const ChannelInputs& in = a.channel_inputs;
  Json classes = Json::object();
  for (const ChannelClass& k : a.channel.classes)
    classes[k.name] = {{"brash_ice_m", k.thickness}, {"resistance_N", k.resistance}};
  return {{"classes", classes},
          {"foreship_m", in.L_bow},
          {"parallel_length_m", in.L_par},
          {"foreship_waterline_area_m2", in.A_wf},
          {"valid", a.channel.valid},
          {"reason", a.channel.reason},
          {"caution", a.channel.caution}};
}

std::string channel_for_people(const ChannelResult& channel) {
  std::string text = "\nAnother thing: a channel of brash ice at 5 kn (Finnish-Swedish ice class rules), kN:";
  for (const ChannelClass& k : channel.classes)
    text += (&k == &channel.classes.front() ? " " : ", ") + k.name + " " + decimals(k.resistance / 1e3, 1);
  text += channel.valid ? "\n" : " -\nchannel: " + channel.reason + "\n";
  if (!channel.caution.empty()) text += "caution: " + channel.caution + "\n";
  return text;
}

std::string for_people(const std::string& design, const Answers& a) {
  const auto kilonewtons = [](double newtons) { return decimals(newtons / 1e3, 1); };
  const LindqvistInputs& in = a.inputs;
  const LindqvistResult& r = a.lindqvist;
  const CycleOutcome& o = a.cycle;
  const bool sails = o.reason.empty();
  const auto formula = [&](double value) { return r.valid ? kilonewtons(value) : std::string("-"); };
  const auto cycle = [&](double value) { return sails ? kilonewtons(value) : std::string("-"); };
  std::string text = design + ": full scale, ice " + brief(in.h) + " m, " + brief(in.V) + " m/s (" +
                     brief(in.V / metres_per_second_per_knot) + " kn), flexural strength " +
                     brief(in.sigma_f / 1e3) + " kPa, friction " + brief(in.mu) + "\n\n";
  const double breaking = o.mean - o.submersion - o.water;
  text += text_table({{"kN", "Lindqvist 1989", "Riska 1997", "cycle"},
                      {"crushing", formula(r.crushing), "", cycle(o.crushing)},
                      {"bending", formula(r.bending), "", cycle(o.bending)},
                      {"friction", "", "", cycle(o.friction)},
                      {"submersion", formula(r.submersion), "", cycle(o.submersion)},
                      {"water", "", "", cycle(o.water)},
                      {"breaking at speed", formula(r.breaking), "", cycle(breaking)},
                      {"total at speed", formula(r.total), a.riska.valid ? kilonewtons(a.riska.total) : "-",
                       sails ? kilonewtons(o.mean) + " \u00b1 " + kilonewtons(o.ci95) : "-"}});
  text +=
      "Lindqvist's parts are at rest, friction in them; the cycle's are at speed. Riska's line knows no "
      "strength.\n";
  if (!r.caution.empty()) text += "caution: " + r.caution + "\n";
  if (!a.riska.valid) text += "Riska: " + a.riska.reason + "\n";
  if (!sails) text += "cycle: " + o.reason + "\n";
  return text + channel_for_people(a.channel);
}

}  // namespace

int run_resistance(const Communicator&, const Arguments& arguments) {
  const ChosenDesign chosen = choose_design(load_study(arguments), arguments);
  const Case& c = chosen.description;
  const Answers a = answers(c);
  if (arguments.has("--json")) {
    std::cout << Json{{"design", chosen.design.name},
                      {"lindqvist", lindqvist_json(a.lindqvist, a.inputs)},
                      {"riska", riska_json(a)},
                      {"fsicr_channel", channel_json(a)},
                      {"cycle", cycle_json(a.cycle, c, c.cycle.rule)},
                      {"inputs", lindqvist_inputs_json(a.inputs)}}
                     .dump(2, ' ', false, Json::error_handler_t::replace)
              << "\n";
  } else {
    std::cout << for_people(chosen.design.name, a);
  }
  if (a.lindqvist.valid) return exit_code::ok;
  std::cerr << chosen.design.name << ": Lindqvist's formula does not apply: " << a.lindqvist.reason << "\n";
  return exit_code::failure;
}

}  // namespace icebow
