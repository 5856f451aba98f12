#include "study/spec/spec_hull.h"

#include <cmath>
#include <filesystem>
#include <limits>
#include <map>

#include "base/errors.h"
#include "base/units.h"
#include "study/spec/spec_hints.h"

namespace icebow {
namespace {

namespace fs = std::filesystem;

double metres_in(const std::string& unit) {
  static const std::map<std::string, double> units = {
      {"m", 1.0}, {"cm", 0.01}, {"mm", 0.001}, {"ft", 0.3048}, {"in", 0.0254}};
  const auto found = units.find(unit);
  return found == units.end() ? 1.0 : found->second;  // another is a mistake that is noted already
}

// "x", "-z": an axis of the file.
Vec3 axis(const std::string& name) {
  const std::size_t k = name.empty() ? 0 : std::string("xyz").find(name.back());
  const Vec3 plus = Vec3::Unit(static_cast<int>(k < 3 ? k : 0));
  return name.size() == 2 ? Vec3(-plus) : plus;
}

MeshFrame frame_of(const Section& s) {
  MeshFrame frame;
  frame.unit = metres_in(s.text("unit", "m")) * s.number("factor");
  frame.forward = axis(s.text("forward", "x"));
  frame.up = axis(s.text("up", "z"));
  frame.left_handed = s.boolean("left_handed");
  frame.waterline = s.has("waterline_height") ? s.number("waterline_height") : 0.0;
  frame.draft = s.has("draft") ? s.number("draft") : 0.0;
  return frame;
}

// The angles asked for, as measured where none is: see case_hull.h.
void take_ship(const Section& s, const ImportedHull& hull, BowParameters& bow) {
  bow.L = hull.L;
  bow.B = hull.B;
  bow.T = hull.T;
  bow.D = hull.D;
  bow.Lf = hull.Lf;
  const BowAngles& own = hull.measured.angles;
  const auto asked = [&](const char* key, double measured) { return s.has(key) ? s.number(key) : measured; };
  bow.angles = {asked("stem", own.stem), asked("waterline", own.waterline), asked("buttock", own.buttock),
                asked("flare", own.flare)};
}

// What a wrong unit or axis makes of a ship: out of the ranges a generated one has, or broader than long.
bool plausible(const Section& s, const ImportedHull& hull, Mistakes& mistakes) {
  const std::size_t before = mistakes.size();
  const auto refuse = [&](const std::string& why) { mistakes.push_back({s.pointer("file"), why}); };
  for (const auto& [name, metres] : std::map<std::string, double>{
           {"length", hull.L}, {"beam", hull.B}, {"draft", hull.T}, {"depth", hull.D}}) {
    const Key& key = *find_key("bow", name);
    if (metres < key.lower || metres > key.upper)
      refuse("is a hull of " + brief(metres) + " m " + name + ", allowed " +
             range_in_words(key, units_of(key.quantity).front()) +
             ": is /hull/unit the unit of its coordinates, and /hull/factor what makes them full scale?");
  }
  if (mistakes.size() == before && hull.B >= hull.L)
    refuse("is a hull of " + brief(hull.B) + " m beam and " + brief(hull.L) +
           " m length: do /hull/forward and /hull/up name the file's axes?");
  return mistakes.size() == before;
}

// Ice is broken by a bow that lies over it: other angles are a mistake of the hull, or of its frame.
void require_angles(const Section& s, const BowAngles& a, Mistakes& mistakes) {
  const auto require = [&](const char* name, double angle, bool zero_allowed) {
    const double deg = degrees(angle);
    if (deg > (zero_allowed ? -1e-6 : 1e-6) && deg <= 90.0 + 1e-6) return;
    mistakes.push_back(
        {s.pointer("file"),
         "is a hull whose " + std::string(name) + " angle " +
             (std::isfinite(deg) ? "is " + brief(deg) + " deg" : "cannot be read at the waterline") +
             ", allowed " + (zero_allowed ? "0 to 90" : "above 0 up to 90") +
             " deg: see `icebow measure`; is /hull/waterline_height or /hull/draft right?"});
  };
  require("stem", a.stem, false);
  require("waterline", a.waterline, false);
  require("buttock", a.buttock, false);
  require("flare", a.flare, true);
}

void make_absolute(Json& section, const fs::path& directory) {
  if (!section.is_object() || !section.contains("file") || !section.at("file").is_string()) return;
  const fs::path file = section.at("file").get<std::string>();
  if (!file.empty()) section["file"] = fs::absolute(directory / file).lexically_normal().string();
}

}  // namespace

void read_hull(const Json& document, Case& c, Mistakes& mistakes) {
  constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
  c.bow.L = c.bow.B = c.bow.T = c.bow.D = c.bow.Lf = unknown;
  if (document.contains("bow"))
    mistakes.push_back(
        {"/bow",
         "is given beside /hull, but a ship has one bow: drop \"bow\" to use the hull of the file, "
         "or \"hull\" to generate one (a design drops the file's with null)"});
  const Section s(document, "hull", 1.0, mistakes);
  const MeshFrame frame = frame_of(s);
  if (s.good() && frame.forward.dot(frame.up) != 0.0)
    return mistakes.push_back(
        {s.pointer("up"), "is the axis of " + s.pointer("forward") +
                              "; give the file's axis that points forward and the one that "
                              "points up, like \"x\" and \"z\", or \"-z\" and \"y\""});
  if (!s.good()) return;
  try {
    c.own = load_own_hull(s.text("file", ""), frame, s.boolean("mirror"), s.boolean("outer_surface"));
    if (!plausible(s, *c.own.imported, mistakes)) return;
    take_ship(s, *c.own.imported, c.bow);
    require_angles(s, c.bow.angles, mistakes);
  } catch (const InputError& error) {
    mistakes.push_back({s.pointer("file"), error.what()});
  }
}

void resolve_hull_files(Json& document, const std::string& study_file) {
  if (!document.is_object()) return;
  const fs::path directory = fs::path(study_file).parent_path();
  if (document.contains("hull")) make_absolute(document["hull"], directory);
  if (!document.contains("designs") || !document.at("designs").is_array()) return;
  for (Json& design : document["designs"]) {
    const bool has_set = design.is_object() && design.contains("set") && design.at("set").is_object();
    if (has_set && design.at("set").contains("hull")) make_absolute(design["set"]["hull"], directory);
  }
}

}  // namespace icebow
