// Lindqvist's ice resistance (Lindqvist 1989, "A straightforward method for calculation of ice resistance of
// ships").
#pragma once

#include <string>

namespace icebow {

struct LindqvistInputs {
  double L = 0.0;          //!< ship length [m]
  double B = 0.0;          //!< beam [m]
  double T = 0.0;          //!< draught [m]
  double stem = 0.0;       //!< phi [rad]
  double waterline = 0.0;  //!< alpha, entrance angle [rad]
  double h = 0.0;          //!< ice thickness [m]
  double V = 0.0;          //!< speed [m/s]
  double sigma_f = 0.0;    //!< flexural strength [Pa]
  double E = 0.0;          //!< elastic modulus [Pa]
  double nu = 0.0;         //!< Poisson's ratio
  double mu = 0.0;         //!< hull-ice friction coefficient
  double rho_w = 0.0;      //!< water density [kg/m^3]
  double rho_i = 0.0;      //!< ice density [kg/m^3]
  double g = 9.81;         //!< [m/s^2]
};

struct LindqvistResult {
  bool valid = false;
  std::string reason;  // the violated guard in words; empty where valid
  std::string
      caution;  // outside what the formula was validated for (flat or Thyssen-Waas bows); may be empty
  double crushing = 0.0;    //!< R_C [N]
  double bending = 0.0;     //!< R_B [N]
  double submersion = 0.0;  //!< R_S [N]
  double breaking = 0.0;    //!< (R_C + R_B)(1 + 1.4 V/sqrt(g h)) [N]
  double total = 0.0;       //!< breaking + R_S (1 + 9.4 V/sqrt(g L)) [N]
};

// psi, the angle between the normal of the bow plate and the vertical, (F1) of docs/formulas.md. All in
// radians.
double lindqvist_psi(double stem, double waterline);

// Outside these [rad] a result carries a caution.
struct LindqvistRange {
  double stem_lower, stem_upper, waterline_lower, waterline_upper;
};
LindqvistRange lindqvist_range();

LindqvistResult lindqvist(const LindqvistInputs& in);

}  // namespace icebow
