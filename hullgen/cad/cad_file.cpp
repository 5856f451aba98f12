#include "hullgen/cad/cad_file.h"

#include <APIHeaderSection_MakeHeader.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeSolid.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepBuilderAPI_Sewing.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRepGProp.hxx>
#include <BRepLib.hxx>
#include <GProp_GProps.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_BSplineSurface.hxx>
#include <IGESControl_Controller.hxx>
#include <IGESControl_Writer.hxx>
#include <IGESData_GlobalSection.hxx>
#include <IGESData_IGESModel.hxx>
#include <Interface_Static.hxx>
#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <STEPControl_Controller.hxx>
#include <STEPControl_Writer.hxx>
#include <Standard_Failure.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColgp_Array1OfPnt.hxx>
#include <TColgp_Array2OfPnt.hxx>
#include <TCollection_HAsciiString.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Shell.hxx>
#include <TopoDS_Solid.hxx>

#include <filesystem>

#include "base/errors.h"
#include "base/text_file.h"

namespace icebow {
namespace {

constexpr double sewn_within = 1e-6;  //!< faces meet in the same curve but for round-off [m]

gp_Pnt point(const Vec3& p) {
  return gp_Pnt(p.x(), p.y(), p.z());
}

// OpenCASCADE wants each knot once, with its multiplicity.
struct Knots {
  TColStd_Array1OfReal values;
  TColStd_Array1OfInteger multiplicities;
};

Knots distinct(const std::vector<double>& knots) {
  std::vector<double> values;
  std::vector<int> counts;
  for (double t : knots) {
    if (values.empty() || t != values.back()) values.push_back(t), counts.push_back(0);
    ++counts.back();
  }
  const int n = static_cast<int>(values.size());
  Knots result{TColStd_Array1OfReal(1, n), TColStd_Array1OfInteger(1, n)};
  for (int k = 0; k < n; ++k) {
    result.values(k + 1) = values[static_cast<std::size_t>(k)];
    result.multiplicities(k + 1) = counts[static_cast<std::size_t>(k)];
  }
  return result;
}

TopoDS_Face face(const SplineSurface& s) {
  const int rows = static_cast<int>(s.poles.size()), columns = static_cast<int>(s.poles.front().size());
  TColgp_Array2OfPnt poles(1, rows, 1, columns);
  for (int i = 0; i < rows; ++i)
    for (int j = 0; j < columns; ++j) poles(i + 1, j + 1) = point(s.poles[i][j]);
  const Knots u = distinct(s.u_knots), v = distinct(s.v_knots);
  const Handle(Geom_BSplineSurface) surface = new Geom_BSplineSurface(
      poles, u.values, v.values, u.multiplicities, v.multiplicities, s.u_degree, s.v_degree);
  return BRepBuilderAPI_MakeFace(surface, sewn_within).Face();
}

TopoDS_Edge edge(const SplineCurve& c) {
  const int n = static_cast<int>(c.poles.size());
  TColgp_Array1OfPnt poles(1, n);
  for (int i = 0; i < n; ++i) poles(i + 1) = point(c.poles[static_cast<std::size_t>(i)]);
  const Knots knots = distinct(c.knots);
  const Handle(Geom_BSplineCurve) curve =
      new Geom_BSplineCurve(poles, knots.values, knots.multiplicities, c.degree);
  return BRepBuilderAPI_MakeEdge(curve).Edge();
}

TopoDS_Face face(const FlatFace& flat) {
  BRepBuilderAPI_MakeWire wire;
  for (const SplineCurve& curve : flat.ring) wire.Add(edge(curve));
  return BRepBuilderAPI_MakeFace(wire.Wire(), true).Face();
}

TopoDS_Solid solid(const HullSurfaces& hull) {
  BRepBuilderAPI_Sewing sewing(sewn_within);
  for (const SplineSurface& patch : hull.port) {
    sewing.Add(face(patch));
    sewing.Add(face(mirrored(patch)));
  }
  for (const FlatFace& flat : hull.flat) sewing.Add(face(flat));
  sewing.Perform();
  const TopoDS_Shape sewn = sewing.SewedShape();
  if (sewing.NbFreeEdges() > 0 || sewn.ShapeType() != TopAbs_SHELL)
    throw RuntimeError("the hull's surfaces do not close for a STEP or IGES file: " +
                       std::to_string(sewing.NbFreeEdges()) + " edges belong to one face only");
  TopoDS_Solid result = BRepBuilderAPI_MakeSolid(TopoDS::Shell(sewn)).Solid();
  BRepLib::OrientClosedSolid(result);
  if (!BRepCheck_Analyzer(result).IsValid())
    throw RuntimeError("OpenCASCADE finds the hull's surfaces invalid as a solid: write a mesh instead");
  return result;
}

double volume(const TopoDS_Solid& shape) {
  GProp_GProps properties;
  BRepGProp::VolumeProperties(shape, properties);
  return properties.Mass();
}

// What both formats take without an encoding of their own.
std::string ascii(std::string words) {
  for (char& c : words)
    if (c < ' ' || c > '~') c = '_';
  return words;
}

bool write_step(const std::string& path, const TopoDS_Solid& shape, const std::string& name) {
  STEPControl_Controller::Init();
  Interface_Static::SetCVal("xstep.cascade.unit", "M");  // what the numbers are, and what the file is to have
  Interface_Static::SetCVal("write.step.unit", "M");
  Interface_Static::SetCVal("write.step.product.name", ascii(name).c_str());
  STEPControl_Writer writer;
  if (writer.Transfer(shape, STEPControl_ManifoldSolidBrep) != IFSelect_RetDone) return false;
  APIHeaderSection_MakeHeader header(writer.Model());
  header.SetName(new TCollection_HAsciiString(ascii(name).c_str()));
  header.SetAuthorValue(1, new TCollection_HAsciiString("Icebow"));
  header.SetOrganizationValue(1, new TCollection_HAsciiString(""));
  return writer.Write(path.c_str()) == IFSelect_RetDone;
}

bool write_iges(const std::string& path, const TopoDS_Solid& shape, const std::string& name,
                const std::string& file_name) {
  IGESControl_Controller::Init();
  IGESControl_Writer writer("M", 1);  // 1: a solid (entity 186), not loose trimmed surfaces
  IGESData_GlobalSection head = writer.Model()->GlobalSection();
  head.SetCascadeUnit(1000.0);  // millimetres in what the numbers are; the file's own unit is metres too
  head.SetSendName(new TCollection_HAsciiString(ascii(name).c_str()));
  head.SetFileName(new TCollection_HAsciiString(ascii(file_name).c_str()));
  head.SetAuthorName(new TCollection_HAsciiString("Icebow"));  // not the user's name
  writer.Model()->SetGlobalSection(head);
  if (!writer.AddShape(shape)) return false;
  writer.ComputeModel();
  return writer.Write(path.c_str());
}

double write_solid(const std::string& path, const HullSurfaces& hull, const std::string& name) {
  const std::string ending = std::filesystem::path(path).extension().string();
  const bool step = ending == ".step" || ending == ".stp", iges = ending == ".igs" || ending == ".iges";
  if (!step && !iges)
    throw InputError(path + ": no such CAD format; the name must end in .step, .stp, .igs or .iges");
  Message::DefaultMessenger()->ChangePrinters().Clear();  // it tells standard output what it transfers
  const TopoDS_Solid shape = solid(hull);
  // OpenCASCADE leaves what it could write: a file without its last line would pass for a whole one.
  const std::string beside = path + ".tmp", file_name = std::filesystem::path(path).filename().string();
  const bool written = step ? write_step(beside, shape, name) : write_iges(beside, shape, name, file_name);
  const std::string text = written ? read_text_file(beside) : "";
  std::error_code ignored;
  std::filesystem::remove(beside, ignored);
  if (!written) throw RuntimeError(path + ": cannot write the file");
  write_text_file(path, text);
  return volume(shape);
}

}  // namespace

std::string why_no_cad() {
  return "";
}

double write_cad(const std::string& path, const HullSurfaces& hull, const std::string& name) {
  try {
    return write_solid(path, hull, name);
  } catch (const Standard_Failure& failure) {  // no std::exception
    throw RuntimeError(path + ": OpenCASCADE: " + failure.GetMessageString());
  }
}

// For plugin_function().
extern "C" double icebow_write_cad(const std::string& path, const HullSurfaces& hull,
                                   const std::string& name) {
  return write_cad(path, hull, name);
}

}  // namespace icebow
