#pragma once
#include <array>
#include <vector>

#include "ibm/cells.hpp"
#include "ibm/exchange.hpp"
#include "ibm/ledger.hpp"
#include "ibm/region_mass.hpp"
#include "lbm/link.hpp"

namespace velum::ibm {

/// A link cut by the membrane, as the host keeps it.
struct CutLink {
  Hit hit;
  double ring;
  std::uint8_t side;  // plus_side or minus_side: of the fluid cell
  bool downstream;    // for the ledger
  bool half_way;      // by the model's wall rule, or as the cell touches a wall as well
};

/// Sharp link-cut immersed boundary: the membrane is a solid with two wet faces; a link whose ends
/// have different labels is cut, and an interpolated bounce-back at the true distance replaces what
/// would have come through. Sealing is topology: no population ever crosses, whatever the geometry.
template <class Real>
struct Sharp {
  lbm::Walls walls;
  std::vector<lbm::WallHit> wall_hits;  // without those of openings
  Surface surface;
  std::array<FaceLine, 2> before;  // its plus and minus face a step ago
  Cells cells;
  double divide = 0;  // radius that parts up- from downstream under the membrane

  lbm::LinkList resting;  // rigid walls and films
  /// Links from fluid into the gap, where it is left to a law: outside the dividing radius and
  /// within; and their area across the radius, sum of 6 w |c_y| ring with the sign of the side.
  lbm::LinkList gap_edge[2];
  double gap_area[2] = {0, 0};
  lbm::LinkList cut_links;  // same order as cut
  std::vector<lbm::Link> cut_host;
  std::vector<CutLink> cut;
  Kokkos::View<double**, Kokkos::LayoutRight> heard;  // [3][links]: outgoing, reflected, density
  Kokkos::View<double*> wall_term;                    // kappa c.u_w of each link
  RegionMass mass;
  Exchange exchange;
  long refilled = 0, orphans = 0;  // sites uncovered so far; those without a neighbour to copy
};

/// Prepares the boundary for a fluid whose rigid walls are known, at the membrane's present place.
/// @param dry_plus  no lattice fluid touches the plus face: what is there is a lumped chamber
template <class Real>
Sharp<Real> make_sharp(lbm::Fluid<Real>& fluid, lbm::Walls const& walls,
                       std::vector<lbm::WallHit> const& wall_hits,
                       structure::Membrane const& membrane, double divide, bool dry_plus = false,
                       SeatGapCells const& gap = {});

/// Walls at rest write what they send back.
template <class Real>
void reflect_at_walls(Sharp<Real>& body, lbm::Fluid<Real>& fluid);

/// Force of the fluid on the nodes were the membrane at rest, F0, and the block Z by which it falls
/// with the velocity. Per link, momentum exchange relative to the rest density:
///   F = ring c (f_out + g),  Z = ring kappa c c^T,
/// f_out the outgoing population, g what a resting wall reflects, both less w; handed to the two
/// nodes of the element by its shape functions. Ladd 1994; Wen et al., J. Comput. Phys. 266 (2014)
/// 161. The block is lumped: each node feels its own velocity, the link that at its hit. What the
/// two differ by, share Z (v_node - v_hit) with the velocities of the last step, is part of F0;
/// without it neighbouring nodes would be braked towards each other by rho c_s times the element's
/// length squared, the more the lower the Mach number.
template <class Real>
void feel(Sharp<Real>& body, lbm::Fluid<Real>& fluid, structure::Membrane const& membrane);

/// Sends the populations back with the velocity of the faces, then streams and collides.
/// @param velocity  mean node velocity of the step [2N]
template <class Real>
void impose(Sharp<Real>& body, lbm::Fluid<Real>& fluid, Eigen::VectorXd const& velocity,
            Ledger& ledger);

/// Follows the membrane to its new place: labels, uncovered sites, cut links, and the mass that the
/// step has put into closed regions or lost from them.
template <class Real>
void move(Sharp<Real>& body, lbm::Fluid<Real>& fluid, structure::Membrane const& membrane);

}  // namespace velum::ibm
