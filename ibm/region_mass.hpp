#pragma once
#include <vector>

#include "ibm/cells.hpp"
#include "ibm/regions.hpp"
#include "lbm/link.hpp"

namespace velum::ibm {

/// Budget of the water in each connected region of fluid over one step.
///
/// By rights what walls and faces send into a region beyond what they heard is the volume that the
/// faces swept, and covering or uncovering a cell changes nothing. On the lattice each of these
/// holds to second order only: interpolated walls send back populations of two cells, a covered
/// cell takes its density with it, an uncovered one is filled by its neighbours. What is left over
/// after a stroke there and back does not cancel, and a closed chamber would lose its water for
/// good. The surplus of a region is therefore taken back from all its cells alike, every
/// budget_period steps. At the cells where it arises it would turn interpolated walls into half-way
/// ones, of first order; at the walls alone, each step, it is amplified by the interpolation and
/// diverges where all links are short. A density that rises everywhere is felt by no wall.
///
/// Mass is that of the deviations f - w from water at rest, in lattice units; about an axis every
/// population carries the ring of the mid-point of its link (lbm/collide.hpp).
struct RegionMass {
  Regions regions;
  std::vector<double> surplus;  // [regions] not yet taken back
  Kokkos::View<Regions::Run*> runs;
  Kokkos::View<double*> parts;  // one number per link, cell or run of a list
};

/// Steps from one taking back to the next: the cells of a region are then read once more.
inline constexpr std::uint32_t budget_period = 16;

/// Sorts the cells into regions anew. The surplus so far goes with the cells; that of a region that
/// has vanished goes with it.
template <class Real>
void find_regions(RegionMass& mass, lbm::Fluid<Real> const& fluid, Cells const& cells);

/// Adds the mass of the cells that changed, times sign, to the surplus of the region they are in;
/// those in none are left out. Before find_regions() this is what was covered, after it what was
/// uncovered.
template <class Real>
void add_changed_cells(RegionMass& mass, lbm::Fluid<Real> const& fluid, Cells const& cells,
                       double sign);

/// Adds what the links of walls at rest have sent back, once it is written, beyond what they heard.
template <class Real>
void add_gain(RegionMass& mass, lbm::Fluid<Real> const& fluid, lbm::LinkList const& resting);

/// Takes off what a face swept into the regions before it.
/// @param side  of the face's fluid, fluid_plus or fluid_minus
void subtract_swept(RegionMass& mass, Cells const& cells, std::uint8_t side, FaceLine const& before,
                    FaceLine const& after, core::Symmetry symmetry);

/// Takes the surplus of the regions from the resting population of their cells. What is lost to the
/// rounding of stored numbers remains in the surplus.
template <class Real>
void take_back(RegionMass& mass, lbm::Fluid<Real>& fluid);

}  // namespace velum::ibm
