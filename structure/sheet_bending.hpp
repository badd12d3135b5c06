#pragma once
#include "structure/load.hpp"
#include "structure/sheet.hpp"

#include <array>
#include <vector>

namespace velum::structure {

/// How a sheet's rim may turn where it is held.
enum class Rim { hinged, clamped };

/// Bending of a sheet of triangles without rotations as unknowns: the basic shell triangle of
/// Onate & Zarate, Int. J. Numer. Meth. Engng 47 (2000) 557, and Flores & Onate, Comput. Methods
/// Appl. Mech. Engrg. 190 (2000) 2973. Curvatures are constant in a triangle, from the slopes of
/// its three neighbours by Gauss's theorem,
///   k_ab = 1/A sum over sides l n_b (phi_a . t),  phi_a = (own + neighbour's slope)/2,
/// t the triangle's normal, neighbours unfolded about their side into its undeformed plane. On a
/// clamped side the slope is that of the undeformed state, on a free or hinged one its own. Energy
///   A/2 (k - k0)^T D (k - k0),   D = mu H^3/3 [1 1/2 0; 1/2 1 0; 0 0 1/4] on (k11, k22, 2 k12),
/// the plate of an incompressible solid, E = 3 mu and nu = 1/2: exact for small strains; where a
/// sheet is stretched much its stiffness in bending matters little, and that it gets thinner is
/// left out.
struct BendingTriangle {
  std::array<int, 6> nodes;  ///< own three, then those of the neighbours across the sides opposite
                             ///< to them; the own node again where there is none
  Eigen::Matrix<double, 6, 2> slope;      ///< of the own map: weights of the nodes
  Eigen::Matrix<double, 6, 3> curvature;  ///< weights of the nodes in g of (k11, k22, 2 k12)
  Eigen::Matrix3d held;                   ///< part of g that clamped sides hold, a column each
  Eigen::Vector3d k0;                     ///< curvatures of the undeformed state
  double area, stiffness;                 ///< A, mu H^3 / 3
};
using SheetBending = std::vector<BendingTriangle>;

/// @param rim  how sides turn whose both nodes are held and that have no neighbour
SheetBending sheet_bending(Sheet const& s, Rim rim);

double bending_energy(SheetBending const& b, Eigen::VectorXd const& x);

/// The bending as a load, with its exact tangent: the negative gradient of its energy. Keeps b by
/// reference.
Load bending_load(SheetBending const& b);

}  // namespace velum::structure
