// A thin plate afloat by rectangular elements: theory of its own beside the lattice, for corners, edges and
// fast loads that no closed form has.
//
// The element of Adini, Clough and Melosh: 12 unknowns, w, dw/dx and dw/dy at each corner, an incomplete
// quartic that meets its neighbours without a gap but with a kink. Source: Melosh, AIAA Journal 1 (1963),
// 1631; Zienkiewicz and Taylor, The Finite Element Method, vol. 2, ch. 4. Kirchhoff's plate on springs rho_w
// g. z is up.
#pragma once

#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>
#include <memory>
#include <vector>

namespace icebow {

struct ThinPlate {
  double bending = 0.0;     //!< D = E h^3 / (12 (1 - nu^2)) [N m]
  double nu = 0.0;          // Poisson's ratio
  double h = 0.0;           //!< [m]
  double foundation = 0.0;  //!< rho_w g [N/m^3]
  double mass = 0.0;        //!< of ice, and of the water that goes with it [kg/m^2]

  double characteristic_length() const;  //!< (D / foundation)^(1/4) [m]
};

// Of a plate of such modulus [Pa]; `added_mass` is the depth of water that goes with it [m].
ThinPlate thin_plate(double E, double nu, double h, double rho, double rho_w, double added_mass);

enum class PlateEdge { free, clamped, mirror };

// Lines of the mesh, ascending [m], and what holds its outermost ones.
struct PlateMesh {
  std::vector<double> x, y;
  PlateEdge at_x0 = PlateEdge::free, at_x1 = PlateEdge::free, at_y0 = PlateEdge::free,
            at_y1 = PlateEdge::free;
};

// From 0 to `end`: so fine up to `fine_until`, from there on each wider than the last by a sixth.
std::vector<double> graded_lines(double step, double fine_until, double end);

struct LoadedPatch {
  double x0, x1, y0, y1;  //!< [m]
};

struct FaceStress {
  double xx = 0.0, yy = 0.0, xy = 0.0;  //!< [Pa], tension above 0
  double largest() const;               // principal stress
  double smallest() const;
};

// The free unknowns of a sparse symmetric matrix, factored.
class FreePart {
 public:
  FreePart(const Eigen::SparseMatrix<double>& matrix, const std::vector<char>& free);
  Eigen::VectorXd solve(const Eigen::VectorXd& force) const;  // what is held is 0

 private:
  std::vector<int> place_;  // of each unknown among the free ones; -1 = held
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factor_;
};

class PlateElements {
 public:
  PlateElements(const ThinPlate& plate, const PlateMesh& mesh);

  const ThinPlate& plate() const { return plate_; }
  const PlateMesh& mesh() const { return mesh_; }
  int nx() const { return int(mesh_.x.size()); }
  int ny() const { return int(mesh_.y.size()); }
  // Of w at line ix, iy; dw/dx and dw/dy follow it.
  int unknown(int ix, int iy) const { return 3 * (ix * ny() + iy); }
  const std::vector<char>& free() const { return free_; }

  const Eigen::SparseMatrix<double>& stiffness() const { return stiffness_; }  // bending and foundation
  const Eigen::SparseMatrix<double>& cover() const {
    return cover_;
  }  // integral of N^T N: mass over its density

  // Forces of 1 N downwards, spread evenly over the part of the patch that is on the mesh.
  Eigen::VectorXd pressed(const LoadedPatch& patch) const;
  // The edge x = 0, turned by 1 N along x that acts 1 m above the plate's middle between two y.
  Eigen::VectorXd turned(double y0, double y1) const;
  Eigen::VectorXd settle(const Eigen::VectorXd& force) const;
  // Of the upper face, by bending; the mean over the elements that meet there. The lower face has the
  // negative.
  FaceStress upper_face(const Eigen::VectorXd& u, int ix, int iy) const;
  std::vector<FaceStress> upper_face(const Eigen::VectorXd& u) const;  // [ix * ny + iy]

 private:
  void assemble();
  void note_faces();
  void hold();

  ThinPlate plate_;
  PlateMesh mesh_;
  Eigen::SparseMatrix<double> stiffness_, cover_;
  Eigen::SparseMatrix<double, Eigen::RowMajor> faces_;  // xx, yy, xy of each place, by the unknowns
  std::vector<char> free_;
};

}  // namespace icebow
