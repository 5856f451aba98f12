// STEP and IGES files, read back by OpenCASCADE as another program would: in its own millimetres, so that the
// unit the file declares counts.
#include "hullgen/cad/cad_file.h"

#include <BRepAdaptor_Surface.hxx>
#include <BRepBuilderAPI_MakeVertex.hxx>
#include <BRepBuilderAPI_Sewing.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRepExtrema_DistShapeShape.hxx>
#include <BRepGProp.hxx>
#include <BRep_Tool.hxx>
#include <GProp_GProps.hxx>
#include <GeomAPI_ProjectPointOnSurf.hxx>
#include <IGESControl_Reader.hxx>
#include <Interface_Static.hxx>
#include <STEPControl_Reader.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Shape.hxx>
#include <TopoDS_Solid.hxx>
#include <UnitsMethods.hxx>

#include <catch2/catch.hpp>
#include <filesystem>

#include "base/errors.h"
#include "base/json.h"
#include "base/units.h"
#include "hullgen/bow/bow_angles.h"
#include "hullgen/bow/bow_mesh.h"
#include "hullgen/bow/family.h"
#include "hullgen/bow/feasibility.h"
#include "hullgen/cad/cad_import.h"
#include "hullgen/import/imported_hull.h"
#include "tests/support/paper_bows.h"

using namespace icebow;

namespace {

constexpr double mm = 1000.0;  // in a metre

struct Scratch {
  std::filesystem::path path;
  Scratch() {
    std::string name = (std::filesystem::temp_directory_path() / "icebow_cad_XXXXXX").string();
    path = mkdtemp(name.data());
  }
  ~Scratch() { std::filesystem::remove_all(path); }
  std::string file(const std::string& name) const { return (path / name).string(); }
};

template <class Reader>
TopoDS_Shape read(const std::string& path) {
  Interface_Static::SetCVal("xstep.cascade.unit", "MM");
  UnitsMethods::SetCasCadeLengthUnit(1.0, UnitsMethods_LengthUnit_Millimeter);
  Reader reader;
  REQUIRE(reader.ReadFile(path.c_str()) == IFSelect_RetDone);
  reader.TransferRoots();
  return reader.OneShape();
}

int count(const TopoDS_Shape& shape, TopAbs_ShapeEnum kind) {
  int n = 0;
  for (TopExp_Explorer e(shape, kind); e.More(); e.Next()) ++n;
  return n;
}

gp_Pnt place(const Vec3& p) {
  return gp_Pnt(mm * p.x(), mm * p.y(), mm * p.z());
}

// Farthest of every n-th vertex of the mesh from the shape [m].
double deviation(const TopoDS_Shape& shape, const QuadMesh& mesh, std::size_t n) {
  double worst = 0.0;
  for (std::size_t k = 0; k < mesh.points.size(); k += n) {
    const BRepExtrema_DistShapeShape distance(BRepBuilderAPI_MakeVertex(place(mesh.points[k])).Vertex(),
                                              shape);
    REQUIRE(distance.IsDone());
    worst = std::max(worst, distance.Value() / mm);
  }
  return worst;
}

// Outward normal of the port patch next to a point of the design waterline.
Vec3 normal_at(const TopoDS_Shape& shape, const Vec3& p) {
  double nearest = 1e-3 * mm;
  Vec3 normal = Vec3::Zero();
  for (TopExp_Explorer e(shape, TopAbs_FACE); e.More(); e.Next()) {
    const TopoDS_Face face = TopoDS::Face(e.Current());
    GProp_GProps area;
    BRepGProp::SurfaceProperties(face, area);
    const Handle(Geom_Surface) surface = BRep_Tool::Surface(face);
    if (area.CentreOfMass().Y() < 1e-3 * mm) continue;  // starboard, or flat across both sides
    const GeomAPI_ProjectPointOnSurf projection(place(p), surface);
    if (projection.NbPoints() == 0 || projection.LowerDistance() > nearest) continue;
    nearest = projection.LowerDistance();
    double u = 0.0, v = 0.0;
    projection.LowerDistanceParameters(u, v);
    gp_Pnt at;
    gp_Vec du, dv;
    surface->D1(u, v, at, du, dv);
    const gp_Vec n = du.Crossed(dv).Normalized();
    normal = Vec3(n.X(), n.Y(), n.Z());
  }
  return normal.x() < 0.0 ? Vec3(-normal) : normal;
}

// Of x + S(y, z) = 0 the normal is (1, S_y, S_z); S_y is the cotangent of the waterline angle, -S_z that of
// stem or buttock.
BowAngles angles(const TopoDS_Shape& shape, const QuadMesh& mesh, double beam) {
  Vec3 P1(-1e9, 0.0, 0.0);  // the transom has such a point too
  for (const Vec3& p : mesh.points)
    if (std::abs(p.y() - beam / 4.0) < 1e-6 && std::abs(p.z()) < 1e-9 && p.x() > P1.x())
      P1 = p;  // [m] rounding
  const Vec3 stem = normal_at(shape, Vec3::Zero()), quarter = normal_at(shape, P1);
  BowAngles a;
  a.stem = std::atan2(stem.x(), -stem.z());
  a.waterline = std::atan2(stem.x(), stem.y());
  a.buttock = std::atan2(quarter.x(), -quarter.z());
  a.flare = std::atan2(-quarter.z(), quarter.y());
  return a;
}

}  // namespace

TEST_CASE("STEP: one valid solid in metres, on the mesh, with the four angles") {
  const Scratch scratch;
  for (const BowFamily family : all_families()) {
    BowParameters bow = preset_bow(family);
    bow.panel = bow.B / 12.0;
    const QuadMesh mesh = bow_mesh(bow);
    const std::string path = scratch.file("hull.step");
    const double volume = write_cad(path, hull_surfaces(bow), "A hull");
    CHECK(read_text_file(path).find("A hull") != std::string::npos);
    const TopoDS_Shape shape = read<STEPControl_Reader>(path);
    CAPTURE(family_form(family).key);
    CHECK(count(shape, TopAbs_SOLID) == 1);
    CHECK(count(shape, TopAbs_FACE) == 3 + 2 * static_cast<int>(hull_surfaces(bow).port.size()));
    CHECK(BRepCheck_Analyzer(shape).IsValid());
    GProp_GProps properties;
    BRepGProp::VolumeProperties(shape, properties);
    CHECK(properties.Mass() / (mm * mm * mm) == Approx(volume).epsilon(1e-9));  // rounding of metres
    BowParameters fine = bow;
    fine.panel = bow.B / 60.0;
    CHECK(volume ==
          Approx(enclosed_volume(bow_mesh(fine))).epsilon(1e-3));  // chords of the bilge cut it short
    const double off = deviation(shape, mesh, 41),
                 error = degrees(largest_difference(bow.angles, angles(shape, mesh, bow_beam(bow))));
    INFO("deviation / L " << off / bow.L << ", angles off by " << error << " deg");
    CHECK(off < 1e-8 * bow.L);  // found 5e-10: millimetres of a text file with 15 digits
    CHECK(error < 0.05);
  }
}

TEST_CASE("STEP: stem radius, ice knife and skeg are faces of the one valid solid") {
  const Scratch scratch;
  for (const BowFamily family : all_families()) {
    CAPTURE(family_form(family).key);
    BowParameters bow = preset_bow(family);
    bow.panel = bow.B / 60.0;
    bow.centre.stem_radius = 0.4 / std::cos(bow.angles.waterline);
    bow.centre.knife_height = 0.4 * bow.T;
    bow.centre.skeg_height = 0.8;
    bow.centre.skeg_length = 20.0;
    const std::string path = scratch.file("hull.step");
    const double volume = write_cad(path, hull_surfaces(bow), "A hull");    // throws where it does not close
    CHECK(volume == Approx(enclosed_volume(bow_mesh(bow))).epsilon(1e-3));  // chords of the bilge
    CHECK(count(read<STEPControl_Reader>(path), TopAbs_SOLID) == 1);
  }
}

TEST_CASE("IGES: one valid solid in metres, on the mesh, with the four angles") {
  const Scratch scratch;
  for (const BowFamily family :
       {BowFamily::concave, BowFamily::spoon_reamers, BowFamily::semi_spoon_chines}) {
    CAPTURE(family_form(family).key);
    BowParameters bow = preset_bow(family);
    bow.panel = bow.B / 12.0;
    const QuadMesh mesh = bow_mesh(bow);
    UnitsMethods::SetCasCadeLengthUnit(1.0,
                                       UnitsMethods_LengthUnit_Millimeter);  // as in a program just started
    const std::string path = scratch.file("hull.igs");
    const double volume = write_cad(path, hull_surfaces(bow), "A hull");
    const TopoDS_Shape shape = read<IGESControl_Reader>(path);
    CHECK(count(shape, TopAbs_SOLID) == 1);
    CHECK(count(shape, TopAbs_FACE) == 3 + 2 * static_cast<int>(hull_surfaces(bow).port.size()));
    CHECK(BRepCheck_Analyzer(shape).IsValid());
    GProp_GProps properties;
    BRepGProp::VolumeProperties(shape, properties);
    CHECK(
        std::abs(properties.Mass()) / (mm * mm * mm) ==
        Approx(volume).epsilon(1e-5));  // the reader makes edges of its own; found 9e-6 where faces are sewn
    CHECK(deviation(shape, mesh, 41) < 1e-8 * bow.L);  // found 5e-10, as above
    CHECK(degrees(largest_difference(bow.angles, angles(shape, mesh, bow_beam(bow)))) < 0.05);
  }
}

TEST_CASE("STEP and IGES read back are the hull, its angles and its stem bar") {
  const Scratch scratch;
  for (const auto& [family, name] :
       {std::pair(BowFamily::concave, "hull.step"), std::pair(BowFamily::semi_spoon_chines, "hull.step"),
        std::pair(BowFamily::high_flare, "hull.igs")}) {
    CAPTURE(family_form(family).key, name);
    BowParameters bow = preset_bow(family);
    if (family == BowFamily::high_flare) bow.centre.stem_radius = 0.6;
    const std::string path = scratch.file(name);
    const double volume = write_cad(path, hull_surfaces(bow), "A hull");
    const ImportedHull hull = import_hull(path, {});
    const BowAngles& found = hull.measured.angles;
    CHECK(enclosed_volume(hull.mesh) == Approx(volume).epsilon(1e-3));  // chords within 0.01 % of the size
    CHECK(hull.L == Approx(bow.L).epsilon(1e-4));                       // likewise
    CHECK(hull.B == Approx(bow_beam(bow)).epsilon(1e-4));               // likewise
    // deg: found 0.06, and 0.20 for the entrance outside a bar, by triangles of 1.5 m.
    CHECK(degrees(largest_difference(bow.angles, found)) < (bow.centre.stem_radius > 0.0 ? 0.3 : 0.1));
    CHECK(hull.measured.stem_radius == Approx(bow.centre.stem_radius).margin(0.05));  // m: chords of the bar
    CHECK(hull.mesh.quads.size() < 150000);  // bounded, also where the shoulder's triangles are needles
  }
}

TEST_CASE("the unit a STEP file is written in counts") {
  const Scratch scratch;
  const BowParameters bow = preset_bow(BowFamily::concave);
  const std::string path = scratch.file("hull.step"), metre = "SI_UNIT($,.METRE.)";
  write_cad(path, hull_surfaces(bow), "A hull");
  std::string text = read_text_file(path);
  const std::size_t at = text.find(metre);
  REQUIRE(at != std::string::npos);
  write_text_file(path, text.replace(at, metre.size(), "SI_UNIT(.CENTI.,.METRE.)"));
  std::vector<std::string> notes;
  const Box box = bounding_box(read_cad(path, notes));
  CHECK(box.upper.y() - box.lower.y() == Approx(0.01 * bow.B).epsilon(1e-4));  // chords
}

TEST_CASE("random feasible bows of every family close to a valid solid") {
  const Scratch scratch;
  for (const BowFamily family : all_families()) {
    CAPTURE(family_form(family).key);
    std::mt19937 random(500u + static_cast<unsigned>(family));
    int feasible = 0;
    for (int tried = 0; feasible < 3 && tried < 10000; ++tried) {
      BowParameters bow = random_bow(family, random);
      if (!check_feasibility(bow).feasible) continue;
      ++feasible;
      bow.panel = bow.B / 60.0;
      const double volume =
          write_cad(scratch.file("hull.step"), hull_surfaces(bow), "h");      // throws where not
      CHECK(volume == Approx(enclosed_volume(bow_mesh(bow))).epsilon(3e-3));  // chords of B/60
    }
    CHECK(feasible == 3);
  }
}

TEST_CASE("a CAD file that cannot be written, or has no known ending, is named") {
  const HullSurfaces hull = hull_surfaces(preset_bow(BowFamily::concave));
  CHECK_THROWS_WITH(write_cad("hull.dwg", hull, "h"),
                    Catch::Contains("hull.dwg") && Catch::Contains(".step"));
  const Scratch scratch;
  for (const char* name : {"missing/hull.step", "missing/hull.igs"})
    CHECK_THROWS_AS(write_cad(scratch.file(name), hull, "h"), RuntimeError);
}

TEST_CASE("a STEP file that crashes OpenCASCADE is refused in words") {
  const Scratch scratch;
  BowParameters bow = preset_bow(all_families().front());
  bow.panel = bow.B / 12.0;
  const std::string path = scratch.file("hull.step");
  write_cad(path, hull_surfaces(bow), "A hull");
  std::vector<std::string> notes;
  CHECK(read_cad(path, notes).quads.size() > 100);
  CHECK(notes.size() == 1);
  std::string text = read_text_file(path);
  const std::size_t first = text.find("#126 = CARTESIAN_POINT");
  REQUIRE(first != std::string::npos);
  write_text_file(path, text.replace(first, 22, "#126 = CARTESIAN_PGINT"));
  CHECK_THROWS_WITH(read_cad(path, notes),
                    Catch::Contains("hull.step") && Catch::Contains("export it again"));
}
