#pragma once
#include <Eigen/Core>
#include <vector>

#include "ibm/exchange.hpp"
#include "ibm/face_markers.hpp"
#include "ibm/labels.hpp"
#include "ibm/ledger.hpp"
#include "ibm/stencil.hpp"
#include "lbm/walls.hpp"

namespace velum::ibm {

/// Diffuse direct forcing, the contender of Sharp behind the same functions: markers on both wet
/// faces pull the fluid towards the velocity of the membrane by a force smeared over four cells,
/// one pass per step. Smooth forces, no cell ever changes its kind; but it leaks, whatever the
/// resolution: the pass that carries a pressure dp leaves a slip of 5/16 dp / rho per step through
/// one face, half of it through two faces four cells apart.
///
/// The lattice does not know the membrane: between the faces stands fluid, which adds its mass to
/// that of the membrane, takes part of the pressure drop and, pressed on a seat, carries that part
/// past the membrane. A pressure under the lip is not an option here.
template <class Real>
struct Diffuse {
  lbm::Walls walls;
  lbm::LinkList resting;  // rigid walls
  Surface surface;
  Labels labels;
  double divide = 0;  // radius that parts up- from downstream under the membrane

  FaceMarkers markers;
  Stencils stencils;
  MarkerField X, heard, F;  // [2], [4], [2][markers]: places, what interpolate() found, forces
  Exchange exchange;        // force and block; the rest is of links and stays zero
};

/// Prepares the boundary for a fluid whose rigid walls are known, at the membrane's present place;
/// gives the fluid a force field and writes the sides of the membrane to fluid.active.
template <class Real>
Diffuse<Real> make_diffuse(lbm::Fluid<Real>& fluid, lbm::Walls const& walls,
                           std::vector<lbm::WallHit> const& wall_hits,
                           structure::Membrane const& membrane, double divide);

/// Walls at rest write what they send back.
template <class Real>
void reflect_at_walls(Diffuse<Real>& body, lbm::Fluid<Real>& fluid);

/// Streams, then finds the force on the nodes were the membrane at rest, F0, and the block Z by
/// which it falls with the velocity. A marker of area A in fluid of density rho that arrives with
/// the velocity U needs  F = 2 rho A (V - U)  to take it to V within the step, so
///   F0 = 2 rho A U,  Z = 2 rho A 1,
/// handed to the two nodes of the element by its shape functions. Uhlmann, J. Comput. Phys. 209
/// (2005) 448; the lattice's factor 2: Kang & Hassan, Int. J. Numer. Methods Fluids 66 (2011) 1132.
template <class Real>
void feel(Diffuse<Real>& body, lbm::Fluid<Real>& fluid, structure::Membrane const& membrane);

/// Spreads the force that goes with the velocity of the faces, then collides.
/// @param velocity  mean node velocity of the step [2N]
template <class Real>
void impose(Diffuse<Real>& body, lbm::Fluid<Real>& fluid, Eigen::VectorXd const& velocity,
            Ledger& ledger);

/// Follows the membrane to its new place: labels and markers.
template <class Real>
void move(Diffuse<Real>& body, lbm::Fluid<Real>& fluid, structure::Membrane const& membrane);

}  // namespace velum::ibm
