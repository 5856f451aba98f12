#include "hullgen/cad/cad_import.h"

#include <BRepBndLib.hxx>
#include <BRepBuilderAPI_Sewing.hxx>
#include <BRepMesh_IncrementalMesh.hxx>
#include <BRep_Tool.hxx>
#include <Bnd_Box.hxx>
#include <Geom2d_Curve.hxx>
#include <Geom_Curve.hxx>
#include <Geom_Surface.hxx>
#include <IGESControl_Controller.hxx>
#include <IGESControl_Reader.hxx>
#include <Interface_Static.hxx>
#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <Poly_PolygonOnTriangulation.hxx>
#include <Poly_Triangulation.hxx>
#include <STEPControl_Controller.hxx>
#include <STEPControl_Reader.hxx>
#include <Standard_Failure.hxx>
#include <TopExp_Explorer.hxx>
#include <TopLoc_Location.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Shape.hxx>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <vector>

#include "base/errors.h"
#include "base/text.h"

namespace icebow {
namespace {

constexpr double sewn_within = 1e-4, chord = 1e-4;  // of the shape's diagonal
constexpr double longest_edge = 1.0 / 80.0;         // likewise
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

// The triangles of a face, whose long edges are halved by points of the surface itself: OpenCASCADE puts no
// points where a surface is nearly straight, and angles are read from points. How many triangles come of it
// is bounded by the face's area, for none smaller than a share of the longest edge's square is halved for
// itself.
class FaceMesh {
 public:
  explicit FaceMesh(const TopoDS_Face& face) {
    TopLoc_Location location;
    const Handle(Poly_Triangulation) part = BRep_Tool::Triangulation(face, location);
    if (part.IsNull()) return;
    surface_ = BRep_Tool::Surface(face);
    has_uv_ = part->HasUVNodes() && !surface_.IsNull();
    for (int k = 1; k <= part->NbNodes(); ++k)
      nodes_.push_back(
          {part->Node(k).Transformed(location.Transformation()), has_uv_ ? part->UVNode(k) : gp_Pnt2d()});
    for (int k = 1; k <= part->NbTriangles(); ++k) {
      int a = 0, b = 0, c = 0;
      part->Triangle(k).Get(a, b, c);
      if (face.Orientation() == TopAbs_REVERSED) std::swap(b, c);
      triangles_.push_back({a - 1, b - 1, c - 1});
    }
    find_rim();
    for (TopExp_Explorer edge(face, TopAbs_EDGE); edge.More(); edge.Next())
      take_edge(TopoDS::Edge(edge.Current()), face, part, location);
  }

  void refine(double longest) {
    for (int round = 0; round < most_rounds && has_uv_ && halve_edges(longest); ++round) {
    }
  }

  void append_to(QuadMesh& mesh) const {
    const int first = static_cast<int>(mesh.points.size());
    for (const Node& n : nodes_) mesh.points.emplace_back(n.p.X(), n.p.Y(), n.p.Z());
    for (const auto& t : triangles_) {
      mesh.quads.push_back({first + t[0], first + t[1], first + t[2], first + t[2]});
      mesh.patch.push_back(Patch::other);
    }
  }

 private:
  using Ends = std::pair<int, int>;  // the lower node first
  struct Node {
    gp_Pnt p;
    gp_Pnt2d uv;
  };
  // A piece of the rim on a curve that two faces share: both put the same points there.
  struct OnCurve {
    std::size_t curve;
    double at_lower, at_upper;  // its parameter at the ends
  };
  struct Curve {
    Handle(Geom_Curve) in_space;
    Handle(Geom2d_Curve) on_surface;
  };
  static Ends ends(int a, int b) { return {std::min(a, b), std::max(a, b)}; }

  // Edges of one triangle.
  void find_rim() {
    std::map<Ends, int> uses;
    for (const auto& t : triangles_)
      for (int k = 0; k < 3; ++k) ++uses[ends(t[k], t[(k + 1) % 3])];
    for (const auto& [edge, n] : uses)
      if (n == 1) rim_.insert(edge);
  }

  void take_edge(const TopoDS_Edge& edge, const TopoDS_Face& face, const Handle(Poly_Triangulation) & part,
                 const TopLoc_Location& location) {
    if (BRep_Tool::Degenerated(edge) || BRep_Tool::IsClosed(edge, face)) return;
    const Handle(Poly_PolygonOnTriangulation) line = BRep_Tool::PolygonOnTriangulation(edge, part, location);
    if (line.IsNull() || !line->HasParameters()) return;
    double from = 0.0, to = 0.0;
    const Curve curve = {BRep_Tool::Curve(edge, from, to), BRep_Tool::CurveOnSurface(edge, face, from, to)};
    if (curve.in_space.IsNull() || curve.on_surface.IsNull()) return;
    curves_.push_back(curve);
    const auto& parameters = line->Parameters();
    for (int k = 1; k < line->NbNodes(); ++k) {
      const int a = line->Nodes().Value(k) - 1, b = line->Nodes().Value(k + 1) - 1;
      const double ta = parameters->Value(k), tb = parameters->Value(k + 1);
      on_curve_[ends(a, b)] = {curves_.size() - 1, a < b ? ta : tb, a < b ? tb : ta};
    }
  }

  double area(const std::array<int, 3>& t) const {
    const gp_Vec a(nodes_[t[0]].p, nodes_[t[1]].p), b(nodes_[t[0]].p, nodes_[t[2]].p);
    return 0.5 * a.CrossMagnitude(b);
  }

  // -1 where nothing is known of the rim there.
  int middle(const Ends& edge) {
    Node node;
    const auto found = on_curve_.find(edge);
    if (found != on_curve_.end()) {
      const OnCurve piece = found->second;
      const double t = 0.5 * (piece.at_lower + piece.at_upper);
      node = {curves_[piece.curve].in_space->Value(t), curves_[piece.curve].on_surface->Value(t)};
      const int own = static_cast<int>(nodes_.size());
      on_curve_[{edge.first, own}] = {piece.curve, piece.at_lower, t};
      on_curve_[{edge.second, own}] = {piece.curve, piece.at_upper, t};
      rim_.insert({edge.first, own}), rim_.insert({edge.second, own});
    } else if (rim_.count(edge) > 0) {
      return -1;
    } else {
      const gp_Pnt2d &a = nodes_[edge.first].uv, &b = nodes_[edge.second].uv;
      node.uv = gp_Pnt2d(0.5 * (a.X() + b.X()), 0.5 * (a.Y() + b.Y()));
      node.p = surface_->Value(node.uv.X(), node.uv.Y());
    }
    nodes_.push_back(node);
    return static_cast<int>(nodes_.size()) - 1;
  }

  bool halve_edges(double longest) {
    std::map<Ends, int> middles;  // -1: the edge stays
    for (const auto& t : triangles_) {
      // A needle has points enough across; along it the surface is straight. Two faces agree on their rim's
      // edges.
      const bool wide = area(t) > widest_share * longest * longest;
      for (int k = 0; k < 3; ++k) {
        const Ends edge = ends(t[k], t[(k + 1) % 3]);
        if (middles.count(edge) > 0 || !(wide || rim_.count(edge) > 0)) continue;
        if (nodes_[edge.first].p.Distance(nodes_[edge.second].p) > longest) middles[edge] = middle(edge);
      }
    }
    std::vector<std::array<int, 3>> finer;
    for (const auto& t : triangles_) add_parts(t, middles, finer);
    const bool more = finer.size() > triangles_.size();
    triangles_ = std::move(finer);
    return more;
  }

  static void add_parts(const std::array<int, 3>& t, const std::map<Ends, int>& middles,
                        std::vector<std::array<int, 3>>& finer) {
    std::vector<int> ring, halved;
    for (int k = 0; k < 3; ++k) {
      ring.push_back(t[k]);
      const auto found = middles.find(ends(t[k], t[(k + 1) % 3]));
      if (found == middles.end() || found->second < 0) continue;
      halved.push_back(static_cast<int>(ring.size()));
      ring.push_back(found->second);
    }
    const auto at = [&](int k) { return ring[static_cast<std::size_t>(k) % ring.size()]; };
    if (halved.empty()) return finer.push_back(t);
    if (halved.size() == 3) {
      for (const int m : halved) finer.push_back({at(m), at(m + 1), at(m + 2)});
      return finer.push_back({at(1), at(3), at(5)});
    }
    const int m = halved[0];
    if (halved.size() == 1) {
      finer.push_back({at(m), at(m + 1), at(m + 2)});
      return finer.push_back({at(m), at(m + 2), at(m + 3)});
    }
    // Two: the corner between them, and the rest as two triangles.
    const int first = halved[1] - halved[0] == 2 ? halved[0] : halved[1];
    finer.push_back({at(first), at(first + 1), at(first + 2)});
    finer.push_back({at(first), at(first + 2), at(first + 3)});
    finer.push_back({at(first), at(first + 3), at(first + 4)});
  }

  static constexpr int most_rounds = 12;
  static constexpr double widest_share = 0.3;  // area over the longest edge's square: wider ones are halved
  Handle(Geom_Surface) surface_;
  bool has_uv_ = false;
  std::vector<Node> nodes_;
  std::vector<std::array<int, 3>> triangles_;
  std::vector<Curve> curves_;
  std::map<Ends, OnCurve> on_curve_;
  std::set<Ends> rim_;
};

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
  for (TopExp_Explorer face(sewn, TopAbs_FACE); face.More(); face.Next(), ++faces) {
    FaceMesh own(TopoDS::Face(face.Current()));
    own.refine(longest_edge * size);
    own.append_to(mesh);
  }
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
