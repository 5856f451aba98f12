// What the breaking cycle needs to know of ice, ship and voyage. SI, full scale. Equations: docs/cycle.md.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace icebow::cycle {

struct Ice {
  double h = 0.0;         //!< thickness [m]
  double rho = 900.0;     //!< density [kg/m^3]
  double E = 0.0;         //!< elastic modulus [Pa]
  double nu = 0.33;       //!< Poisson's ratio
  double sigma_f = 0.0;   //!< flexural strength [Pa]
  double p_c = 0.0;       //!< crushing pressure on a contact of `A_0` [Pa]
  double friction = 0.1;  //!< hull-ice Coulomb coefficient
  double rho_w = 1025.0;  //!< density of the water [kg/m^3]

  double rigidity() const;                            //!< D [N m]
  double characteristic_length() const;               //!< l = (D / (rho_w g))^(1/4) [m]
  double bottom() const { return -rho / rho_w * h; }  //!< height of the lower face [m]
  double top() const { return bottom() + h; }         //!< height of the upper face [m]
};

enum class Breaking {
  literature,  // one capacity C sigma_f h^2 and a cusp of C_l l (1 + C_v v_n), as ship simulators take them
  plate,       // by the width of the contact and the speed of the edge, from the theory of floating wedges
  calibrated   // by width and speed from a table of patch tests of the solver's own ice
};

// A patch test: an edge pressed down over `width` at the speed `edge_speed` until it broke.
struct PatchTest {
  double width_h = 0.0;     // over the thickness
  double edge_speed = 0.0;  //!< downward [m/s]
  double capacity = 0.0;    // vertical load over sigma_f h^2
  double length_l = 0.0;    // breaking length over the characteristic length
};

struct BreakingRule {
  Breaking type = Breaking::literature;
  double C = 0.8;                // literature: capacity over sigma_f h^2
  double C_l = 0.32;             // literature: cusp radius over l at rest
  double C_v = -0.14;            //!< literature: change of it with the normal speed [s/m]
  std::vector<PatchTest> table;  // calibrated; a full grid of widths and speeds
};

struct Voyage {
  double speed = 0.0;     //!< V [m/s]
  double length = 200.0;  //!< counted, after the bow has entered [m]
  double scatter = 0.3;   // cusp radii vary evenly by this part either way
  std::uint64_t seed = 1;
  bool symmetric = false;       // the port half, starboard its mirror image
  double step_h = 0.04;         // step over the thickness
  double raster_h = 1.0 / 7.0;  // widest strip along the hull's waterline over the thickness
  bool keep_shapes = false;     // for a picture: outlines of the pieces
};

// Empty where all is well, else one sentence that names the value and what is allowed.
std::string trouble_with(const Ice& ice, const Voyage& voyage, const BreakingRule& rule);

}  // namespace icebow::cycle
