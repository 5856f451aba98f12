#include "cli/hull_output.h"

#include <algorithm>
#include <filesystem>

#include "base/errors.h"
#include "hullgen/cad_file.h"
#include "hullgen/family.h"
#include "hullgen/lines_plan.h"
#include "hullgen/mesh_io.h"
#include "hullgen/svg_pdf.h"

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

std::string both(const std::string& title, const std::optional<OverlaidBow>& overlaid) {
  return overlaid ? title + " and " + overlaid->name : title;
}

std::string drawing(const Hull& hull, const BowParameters& bow, const std::string& title,
                    const std::optional<OverlaidBow>& overlaid, DrawnFor reader) {
  if (!overlaid) return lines_plan_svg(hull, bow, title, reader);
  const Hull second = make_hull(overlaid->bow);
  if (second.status != HullStatus::ok)
    throw InputError("--overlay " + overlaid->name + ": no hull: " + second.reason);
  return overlaid_lines_plan_svg({hull, bow, title}, {second, overlaid->bow, overlaid->name},
                                 both(title, overlaid), reader);
}

}  // namespace

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

std::optional<OverlaidBow> overlaid_bow(const StudySpec& spec, const Arguments& arguments) {
  if (!arguments.has("--overlay")) return {};
  const std::string wanted = arguments.value("--overlay");
  const std::vector<std::string> families = family_keys();
  if (std::find(families.begin(), families.end(), wanted) != families.end()) {
    const BowFamily family = family_of_key(wanted);
    return OverlaidBow{std::string("preset of ") + family_form(family).key, preset_bow(family)};
  }
  Arguments other = arguments;
  other.options.erase("--set");
  if (std::filesystem::path(wanted).extension() == ".json") {
    other.options.erase("--design");
    other.positional = wanted;
    const StudySpec study = load_study(other);
    return OverlaidBow{study.name, choose_design(study, other).description.bow};
  }
  other.options["--design"] = {wanted};
  try {
    const ChosenDesign chosen = choose_design(spec, other);
    return OverlaidBow{chosen.design.name, chosen.description.bow};
  } catch (const InputError& error) {
    throw InputError("--overlay " + wanted +
                     " is neither a study file (.json) nor a family, so a design: " + error.what());
  }
}

void write_hull_output(const std::string& path, const Hull& hull, const BowParameters& bow,
                       const std::string& title, const std::optional<OverlaidBow>& overlaid) {
  switch (kind_of(path)) {
    case Kind::surfaces:
      write_cad(path, hull_surfaces(bow), title);
      break;
    case Kind::svg:
      write_text_file(path, drawing(hull, bow, title, overlaid, DrawnFor::screen));
      break;
    case Kind::pdf:
      write_pdf(path, drawing(hull, bow, title, overlaid, DrawnFor::print), both(title, overlaid));
      break;
    default:
      write_mesh(path, hull.mesh);
  }
}

}  // namespace icebow
