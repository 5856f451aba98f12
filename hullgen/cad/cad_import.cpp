#include "hullgen/cad/cad_import.h"

#include <BRepBndLib.hxx>
#include <BRepBuilderAPI_Sewing.hxx>
#include <BRepMesh_IncrementalMesh.hxx>
#include <BRep_Tool.hxx>
#include <Bnd_Box.hxx>
#include <IGESControl_Controller.hxx>
#include <IGESControl_Reader.hxx>
#include <Interface_Static.hxx>
#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <Poly_Triangulation.hxx>
#include <STEPControl_Controller.hxx>
#include <STEPControl_Reader.hxx>
#include <Standard_Failure.hxx>
#include <TopExp_Explorer.hxx>
#include <TopLoc_Location.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Shape.hxx>

#include <cmath>

#include "base/errors.h"
#include "base/text.h"

namespace icebow {
namespace {

constexpr double sewn_within = 1e-4, chord = 1e-4;  // of the shape's diagonal
constexpr double turn = 0.05;                       //!< between triangles of one face [rad]

template <class Reader>
TopoDS_Shape transferred(const std::string& path, Reader& reader) {
  if (reader.ReadFile(path.c_str()) != IFSelect_RetDone)
    throw InputError(path +
                     ": is not a file of its kind, or damaged: OpenCASCADE cannot read it; export it again");
  reader.TransferRoots();
  const TopoDS_Shape shape = reader.OneShape();
  if (shape.IsNull())
    throw InputError(path + ": has no surface that can be read: export the hull's surfaces");
  return shape;
}

TopoDS_Shape shape_of(const std::string& path, bool step) {
  Message::DefaultMessenger()->ChangePrinters().Clear();  // it tells standard output what it transfers
  if (step) {
    STEPControl_Controller::Init();
    Interface_Static::SetCVal("xstep.cascade.unit", "M");
    STEPControl_Reader reader;
    return transferred(path, reader);
  }
  IGESControl_Controller::Init();
  Interface_Static::SetCVal("xstep.cascade.unit", "M");
  IGESControl_Reader reader;
  return transferred(path, reader);
}

double diagonal(const TopoDS_Shape& shape) {
  Bnd_Box box;
  BRepBndLib::Add(shape, box);
  return box.IsVoid() ? 0.0 : std::sqrt(box.SquareExtent());
}

void add_face(QuadMesh& mesh, const TopoDS_Face& face) {
  TopLoc_Location location;
  const Handle(Poly_Triangulation) part = BRep_Tool::Triangulation(face, location);
  if (part.IsNull()) return;
  const int first = static_cast<int>(mesh.points.size()) - 1;  // OpenCASCADE counts from 1
  for (int k = 1; k <= part->NbNodes(); ++k) {
    const gp_Pnt p = part->Node(k).Transformed(location.Transformation());
    mesh.points.emplace_back(p.X(), p.Y(), p.Z());
  }
  for (int k = 1; k <= part->NbTriangles(); ++k) {
    int a = 0, b = 0, c = 0;
    part->Triangle(k).Get(a, b, c);
    if (face.Orientation() == TopAbs_REVERSED) std::swap(b, c);
    mesh.quads.push_back({first + a, first + b, first + c, first + c});
    mesh.patch.push_back(Patch::other);
  }
}

QuadMesh meshed(const std::string& path, bool step, std::vector<std::string>& notes) {
  const TopoDS_Shape shape = shape_of(path, step);
  const double size = diagonal(shape);
  BRepBuilderAPI_Sewing sewing(sewn_within * size);
  sewing.Add(shape);
  sewing.Perform();
  const TopoDS_Shape sewn = sewing.SewedShape();
  const BRepMesh_IncrementalMesh divided(sewn, chord * size, Standard_False, turn, Standard_False);
  QuadMesh mesh;
  int faces = 0;
  for (TopExp_Explorer face(sewn, TopAbs_FACE); face.More(); face.Next(), ++faces)
    add_face(mesh, TopoDS::Face(face.Current()));
  if (mesh.quads.empty()) throw InputError(path + ": has no face: export the hull's surfaces, not its lines");
  notes.push_back(text("%d faces were meshed with %zu triangles, within %.2g m of the surfaces", faces,
                       mesh.quads.size(), chord * size));
  return mesh;
}

}  // namespace

// For plugin_function(). `step` says STEP, otherwise the file is IGES.
extern "C" void icebow_read_cad(const std::string& path, bool step, std::vector<std::string>& notes,
                                QuadMesh& mesh) {
  try {
    mesh = meshed(path, step, notes);
  } catch (const Standard_Failure& failure) {  // no std::exception
    throw InputError(path + ": OpenCASCADE: " + failure.GetMessageString());
  }
}

}  // namespace icebow
