#include "cli/bow_explanation.h"

#include <algorithm>
#include <cmath>

#include "base/units.h"
#include "cli/text_table.h"
#include "formula/lindqvist.h"
#include "hullgen/bow/family.h"

namespace icebow {
namespace {

constexpr double near_share = 0.05;  // of a range: as near to its end is worth a word

// The tangent plane of a point where a waterline and a buttock (the profile at P0) cross.
struct Place {
  const char* name;
  double waterline, buttock;  //!< [rad]

  double frame() const { return std::atan(std::tan(waterline) / std::tan(buttock)); }  // flare, beta of UR I2
  double normal_frame() const { return std::atan(std::tan(frame()) * std::cos(waterline)); }
  double psi() const { return lindqvist_psi(buttock, waterline); }
  // Outward: of x + S(y, z) = 0 with the slopes cot(waterline) along y and -cot(buttock) along z.
  Vec3 normal() const { return Vec3(1.0, 1.0 / std::tan(waterline), -1.0 / std::tan(buttock)).normalized(); }
};

Place stem(const BowParameters& bow) {
  return {"P0", bow.angles.waterline, bow.angles.stem};
}
Place quarter(const BowParameters& bow) {
  return {"P1", std::atan(std::tan(bow.angles.flare) * std::tan(bow.angles.buttock)), bow.angles.buttock};
}

struct Limit {
  std::string angle, whose;
  double value, lower, upper;  //!< [rad]

  std::string verdict() const {
    const double margin = std::min(value - lower, upper - value);
    const char* end = value - lower < upper - value ? "lower" : "upper";
    if (margin < 0.0)
      return std::string(end[0] == 'l' ? "below" : "above") + " by " + decimals(degrees(-margin), 2) + " deg";
    return margin < near_share * (upper - lower) ? std::string("near the ") + end + " end" : "inside";
  }
};

std::vector<Limit> limits(const BowParameters& bow, bool generated) {
  const FamilyRanges& f = family_form(bow.family).ranges;
  const LindqvistRange q = lindqvist_range();
  const BowAngles& a = bow.angles;
  const Place p0 = stem(bow), p1 = quarter(bow);
  const auto deg = [](double lower, double upper) { return Range{radians(lower), radians(upper)}; };
  const auto limit = [](const char* angle, const char* whose, double value, Range r) {
    return Limit{angle, whose, value, r.lower, r.upper};
  };
  std::vector<Limit> all;
  if (generated)
    all = {limit("stem", "usual for the family", a.stem, f.stem),
           limit("waterline", "usual for the family", a.waterline, f.waterline),
           limit("buttock", "usual for the family", a.buttock, f.buttock),
           limit("flare", "usual for the family", a.flare, f.flare)};
  for (const Limit& l :
       {limit("stem", "Lindqvist, this project", a.stem, {q.stem_lower, q.stem_upper}),
        limit("waterline", "Lindqvist, this project", a.waterline, {q.waterline_lower, q.waterline_upper}),
        limit("alpha", "FSICR engine power", p1.waterline, deg(15, 55)),
        limit("phi_1", "FSICR engine power", a.stem, deg(25, 90)),
        limit("phi_2", "FSICR engine power", a.buttock, deg(10, 90)),
        limit("gamma at P0", "UR I2 icebreaking form", p0.buttock, deg(0, 80)),
        limit("beta' at P1", "UR I2 icebreaking form", p1.normal_frame(), deg(10, 90))})
    all.push_back(l);
  return all;
}

std::string degree_text(double angle) {
  return decimals(degrees(angle), 2);
}

std::string plane_rows(const BowParameters& bow) {
  std::vector<std::vector<std::string>> rows = {
      {"tangent plane, deg", "waterline", "buttock", "flare", "normal frame angle", "psi", "outward normal"}};
  for (const Place& p : {stem(bow), quarter(bow)}) {
    const Vec3 n = p.normal();
    rows.push_back({p.name, degree_text(p.waterline), degree_text(p.buttock), degree_text(p.frame()),
                    degree_text(p.normal_frame()), degree_text(p.psi()),
                    "(" + decimals(n.x(), 3) + ", " + decimals(n.y(), 3) + ", " + decimals(n.z(), 3) + ")"});
  }
  return text_table(rows);
}

}  // namespace

std::string explanation_text(const BowParameters& bow, bool generated) {
  const Place p0 = stem(bow), p1 = quarter(bow);
  std::string text =
      plane_rows(bow) +
      "P0 is the stem, where the buttock is the profile, P1 the buttock at B/4; psi is Lindqvist's, "
      "who takes it at P0.\n\n";
  std::vector<std::vector<std::string>> rows = {
      {"rule", "alpha", "phi_1", "phi_2", "psi", "gamma", "beta", "beta'"}};
  rows.push_back({"FSICR", degree_text(p1.waterline), degree_text(bow.angles.stem),
                  degree_text(bow.angles.buttock), degree_text(p1.psi())});
  for (const Place& p : {p0, p1})
    rows.push_back({std::string("UR I2 at ") + p.name, degree_text(p.waterline), "", "", "",
                    degree_text(p.buttock), degree_text(p.frame()), degree_text(p.normal_frame())});
  text += text_table(rows) + "\n";
  rows = {{"limits of", "angle", "deg", "from", "to", "is"}};
  for (const Limit& l : limits(bow, generated))
    rows.push_back(
        {l.whose, l.angle, degree_text(l.value), degree_text(l.lower), degree_text(l.upper), l.verdict()});
  return text + text_table(rows);
}

Json explanation_json(const BowParameters& bow, bool generated) {
  const Place p0 = stem(bow), p1 = quarter(bow);
  Json json;
  for (const Place& p : {p0, p1}) {
    const Vec3 n = p.normal();
    json["planes"][p.name] = {{"waterline_deg", degrees(p.waterline)},
                              {"buttock_deg", degrees(p.buttock)},
                              {"flare_deg", degrees(p.frame())},
                              {"outward_normal", {n.x(), n.y(), n.z()}}};
    json["lindqvist_psi_deg"][p.name] = degrees(p.psi());
    json["ur_i2_deg"][p.name] = {{"alpha", degrees(p.waterline)},
                                 {"gamma", degrees(p.buttock)},
                                 {"beta", degrees(p.frame())},
                                 {"beta_normal", degrees(p.normal_frame())}};
  }
  json["fsicr_deg"] = {{"alpha", degrees(p1.waterline)},
                       {"phi_1", degrees(bow.angles.stem)},
                       {"phi_2", degrees(bow.angles.buttock)},
                       {"psi", degrees(p1.psi())}};
  json["limits"] = Json::array();
  for (const Limit& l : limits(bow, generated))
    json["limits"].push_back({{"whose", l.whose},
                              {"angle", l.angle},
                              {"value_deg", degrees(l.value)},
                              {"lower_deg", degrees(l.lower)},
                              {"upper_deg", degrees(l.upper)},
                              {"verdict", l.verdict()}});
  return json;
}

}  // namespace icebow
