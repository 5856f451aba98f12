#include "reports/html/overview_view.h"

#include <algorithm>
#include <cmath>

#include "reports/content/all_runs.h"
#include "reports/html/table_view.h"
#include "reports/text/text_format.h"
#include "study/evaluate/provenance.h"
#include "study/spec/read_study.h"

namespace icebow {
namespace {

// "2026-11-22T15:43:32Z" reads "2026-11-22 15:43 UTC"; anything else stays.
std::string time_in_words(const std::string& iso) {
  if (iso.size() != 20 || iso[10] != 'T' || iso[19] != 'Z') return iso;
  return iso.substr(0, 10) + "\u00a0" + iso.substr(11, 5) + " UTC";
}

std::string design_counts(const StudyResults& study) {
  const std::size_t designs = study.ranking.rows.size() - study.running.size();
  const bool repeated = static_cast<std::size_t>(study.evaluated()) > designs;
  std::string text = std::to_string(study.evaluated()) +
                     (repeated ? " runs of " + std::to_string(designs) + " designs: " : " evaluated: ") +
                     std::to_string(study.ok) + " ok";
  if (study.infeasible > 0) text += ", " + std::to_string(study.infeasible) + " infeasible";
  if (study.failed > 0) text += ", " + std::to_string(study.failed) + " failed";
  if (!study.running.empty()) text += "; " + std::to_string(study.running.size()) + " running";
  if (!study.waiting.empty()) text += "; " + std::to_string(study.waiting.size()) + " not started";
  return text;
}

class Texts {
 public:
  void add(const std::string& title, const std::string& text) {
    list_.push_back({{"title", title}, {"text", text}});
  }
  Json list() const { return list_; }

 private:
  Json list_ = Json::array();
};

bool has_cycle(const ReportContent& content) {
  return std::any_of(content.study.ranking.rows.begin(), content.study.ranking.rows.end(),
                     [](const RankedDesign& row) { return std::isfinite(row.cycle_load); });
}

// What the simulated study has, and has not, of what the solver can do.
struct Includes {
  std::vector<std::string> with, without;
  void put(bool on, const std::string& what) { (on ? with : without).push_back(what); }
};

Includes includes_of(const StudyResults& study) {
  Includes found;
  try {
    const Case c = read_study(study.document, study.name).baseline;
    found.put(c.water.buoyancy_and_gravity, "the weight of the ice and the lift of the water");
    found.put(c.water.added_mass > 0.0 || c.water.inertia == WaterInertia::plane,
              "water that moves with the ice (added mass)");
    found.put(c.water.drag > 0.0, "the drag of the water on it");
    found.put(c.numerics.floe_contact, "pieces of ice that push each other");
    found.put(c.sheet.absorbing > 0.0, "damped edges of the sheet");
    const bool some = c.seed == 0 && run_counts(study).most > 1;
    found.put(c.seed > 0 || some, "ice that starts with small random motions" +
                                      std::string(some ? " in all runs of a design but the first" : ""));
  } catch (const std::exception&) {
    // a study file this program cannot read
  }
  return found;
}

void add_simulation(const ReportContent& content, Texts& texts) {
  const Includes study = includes_of(content.study);
  std::string with =
      "A level ice sheet as a three-dimensional state-based peridynamic solid whose bonds break; contact and "
      "friction "
      "between ice and hull; a rigid ship on a straight course at constant speed.";
  if (!study.with.empty()) with += " In this study also: " + listed(study.with, 9) + ".";
  std::string without;
  if (!study.without.empty()) without = "In this study: " + listed(study.without, 9) + ". In any study: ";
  without +=
      "waves and the flow around the ship, open-water resistance, the propeller's wash, snow, ridges, "
      "strength that varies "
      "from place to place, and the ship's own heave, pitch and turning. The mean still depends on the "
      "particle spacing: "
      "compare designs run with the same one.";
  texts.add("What the simulation includes", with);
  texts.add("What it does not include", without);
  texts.add("Full scale and model scale",
            "The simulation runs at model scale. Froude's and Cauchy's laws take its results to full scale: "
            "lengths times "
            "\u03bb, times and speeds times \u221a\u03bb, forces times \u03bb\u00b3. Full scale comes first "
            "everywhere.");
}

void add_loads(const ReportContent& content, Texts& texts) {
  texts.add(
      "The mean load and its interval",
      std::string(
          "The load is the horizontal force of the ice against the ship's course, averaged over the steady "
          "part of the run. Ice breaks in cycles, so a record of finite length gives the mean only so "
          "well. ") +
          (content.study.repeats.empty()
               ? "The 95\u00a0% interval comes from the autocorrelation of the record, which counts how many "
                 "independent samples the record is worth."
               : "Designs were run several times: the mean is that of the runs' means, its interval that of "
                 "their "
                 "scatter; peaks are the highest of all runs.") +
          " The interval covers this sampling error alone, not the errors of the model.");
  texts.add("Told apart or not",
            "Welch's test asks how often two equal means would look as unlike as these by chance: p. Below "
            "0.05 two "
            "designs are told apart. Otherwise they are marked \u2248, and a longer run may reverse their "
            "order. Of hundreds "
            "of pairs one in twenty looks told apart though it is not.");
}

void add_formula(const ReportContent& content, Texts& texts) {
  std::string text =
      "An empirical estimate of the resistance in level ice from 1989, made of crushing at the stem, "
      "breaking by bending and "
      "submersion of floes, with factors for speed. ";
  const std::string part = compared_part(content.study.ranking);
  if (content.has_loads())
    text += part == "total"
                ? "The load is set against its total: the load of this study is a whole one. "
                : "The load is set against its breaking part, (crushing + bending) \u00d7 speed factor. ";
  texts.add("Lindqvist's formula",
            text +
                "The formula knows the stem angle and the waterline angle, but neither flare nor "
                "buttock angle as such, and was not made for flat or Thyssen-Waas bows.");
}

}  // namespace

std::string kicker(const StudyResults& study) {
  const int ranked = study.ranked();
  std::string text = "Icebreaker bow study \u00b7 " + std::to_string(ranked) +
                     (ranked == 1 ? " design" : " designs") + " ranked";
  const RunCounts runs = run_counts(study);
  if (runs.most > 1 && study.confirmations.empty())
    text += ", " + (runs.fewest < runs.most ? std::to_string(runs.fewest) + " to " : "") +
            std::to_string(runs.most) + " runs each";
  if (study.infeasible > 0) text += ", " + std::to_string(study.infeasible) + " infeasible";
  if (study.failed_designs > 0) text += ", " + std::to_string(study.failed_designs) + " failed";
  return text;
}

Json method_view(const ReportContent& content) {
  Texts texts;
  if (content.has_loads()) add_loads(content, texts);
  if (content.has_simulated()) add_simulation(content, texts);
  if (has_cycle(content))
    texts.add("The breaking cycle",
              "The hull's own mesh crushes the edge of the ice until the ice breaks off in a piece, over and "
              "over along the "
              "way, as ship simulators do. Crushing, bending, friction on the hull and submersion are "
              "counted; the flow "
              "around the ship is not. The seeds are the same for every bow.");
  if (content.has_lindqvist()) add_formula(content, texts);
  texts.add("Angles",
            "Stem: profile against the horizontal. Waterline: entrance against the centre plane at the stem. "
            "Buttock: "
            "against the horizontal, at a quarter of the beam. Flare: from the vertical, at a quarter of the "
            "beam. All on "
            "the design waterline.");
  return texts.list();
}

Json provenance_view(const StudyResults& study) {
  Json facts = facts_view({{"Designs", design_counts(study)},
                           {"Study started", time_in_words(study.started)},
                           {"Report written", time_in_words(utc_now())},
                           {"Computing time, all designs", duration(study.wall_seconds)},
                           {"Host", study.host},
                           {"Icebow", study.version},
                           {"Seed of the plan", study.seed}},
                          false);
  if (!study.command.empty())
    facts["facts"].push_back({{"label", "Command"}, {"value", ""}, {"code", study.command}});
  return facts;
}

}  // namespace icebow
