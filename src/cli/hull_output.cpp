#include "cli/hull_output.h"

#include <algorithm>
#include <filesystem>

#include "base/errors.h"
#include "hullgen/bow/family.h"
#include "hullgen/bow/make_hull.h"
#include "hullgen/cad/cad_file.h"
#include "hullgen/drawing/lines_plan.h"
#include "hullgen/drawing/svg_pdf.h"
#include "hullgen/mesh/mesh_io.h"
#include "study/spec/case_hull.h"

namespace icebow {
namespace {

enum class Kind { mesh, surfaces, svg, pdf, unknown };

Kind kind_of(const std::string& path) {
  const std::string ending = std::filesystem::path(path).extension().string();
  const auto is_one_of = [&](std::initializer_list<const char*> endings) {
    return std::find(endings.begin(), endings.end(), ending) != endings.end();
  };
  return is_one_of({".obj", ".stl", ".ply", ".vtp"})     ? Kind::mesh
         : is_one_of({".step", ".stp", ".igs", ".iges"}) ? Kind::surfaces
         : ending == ".svg"                              ? Kind::svg
         : ending == ".pdf"                              ? Kind::pdf
                                                         : Kind::unknown;
}

std::string both(const std::string& title, const std::optional<OverlaidHull>& second) {
  return second ? title + " and " + second->name : title;
}

std::string drawing(const Hull& hull, const BowParameters& bow, const std::string& title,
                    const std::optional<OverlaidHull>& second, DrawnFor reader) {
  if (!second) return lines_plan_svg(hull, bow, title, reader);
  return overlaid_lines_plan_svg({hull, bow, title}, {second->hull, second->bow, second->name},
                                 both(title, second), reader);
}

OverlaidHull overlaid(const std::string& name, Hull hull, const BowParameters& bow) {
  if (hull.status != HullStatus::ok) throw InputError("--overlay " + name + ": no hull: " + hull.reason);
  return {name, std::move(hull), bow};
}

OverlaidHull overlaid(const std::string& name, const Case& description) {
  return overlaid(name, make_hull(description), description.bow);
}

}  // namespace

bool is_surface_file(const std::string& path) {
  return kind_of(path) == Kind::surfaces;
}

void check_hull_output(const Arguments& arguments) {
  const std::string path = arguments.value("--out");
  const Kind kind = kind_of(path);
  if (arguments.has("--overlay") && kind != Kind::svg && kind != Kind::pdf)
    throw InputError("--overlay draws a second hull in a lines plan: give --out FILE.svg or FILE.pdf too");
  if (!arguments.has("--out")) return;
  if (kind == Kind::unknown)
    throw InputError("--out " + path +
                     ": the file must end in .obj, .stl, .ply, .vtp (mesh), .step, .stp, .igs, .iges "
                     "(surfaces), .svg or .pdf (lines plan)");
  const std::string lacking = kind == Kind::surfaces ? why_no_cad() : kind == Kind::pdf ? why_no_pdf() : "";
  if (!lacking.empty()) throw InputError("--out " + path + ": " + lacking);
}

std::optional<OverlaidHull> overlaid_hull(const StudySpec& spec, const Arguments& arguments) {
  if (!arguments.has("--overlay")) return {};
  const std::string wanted = arguments.value("--overlay");
  const std::vector<std::string> families = family_keys();
  if (std::find(families.begin(), families.end(), wanted) != families.end()) {
    const BowFamily family = family_of_key(wanted);
    const BowParameters bow = preset_bow(family);
    return overlaid(std::string("preset of ") + family_form(family).key, make_hull(bow), bow);
  }
  Arguments other = arguments;
  other.options["--set"].clear();
  if (std::filesystem::path(wanted).extension() == ".json") {
    other.options["--design"].clear();
    other.positional = wanted;
    const StudySpec study = load_study(other);
    return overlaid(study.name, choose_design(study, other).description);
  }
  other.options["--design"] = {wanted};
  const ChosenDesign chosen = [&] {
    try {
      return choose_design(spec, other);
    } catch (const InputError& error) {
      throw InputError("--overlay " + wanted +
                       " is neither a study file (.json) nor a family, so a design: " + error.what());
    }
  }();
  return overlaid(chosen.design.name, chosen.description);
}

void write_hull_output(const std::string& path, const Hull& hull, const BowParameters& bow,
                       const std::string& title, const std::optional<OverlaidHull>& second) {
  switch (kind_of(path)) {
    case Kind::surfaces:
      write_cad(path, hull_surfaces(bow), title);
      break;
    case Kind::svg:
      write_text_file(path, drawing(hull, bow, title, second, DrawnFor::screen));
      break;
    case Kind::pdf:
      write_pdf(path, drawing(hull, bow, title, second, DrawnFor::print), both(title, second));
      break;
    default:
      write_mesh(path, hull.mesh);
  }
}

}  // namespace icebow
