#pragma once
#include <cstdint>
#include <vector>

#include "lbm/d2q9.hpp"
#include "lbm/fluid.hpp"

namespace velum::lbm {

/// One lattice link from a fluid cell (i, j) along direction dir to a place that is not fluid.
struct Link {
  std::int32_t i, j;
  std::int16_t dir;
  std::int16_t second;  // 1 if the cell behind, (i, j) - c, is fluid of the same side
  float weight;         // of an opening's velocity profile; 1 elsewhere
  double q;             // share of the link up to the wall, 0 < q <= 1
};

/// A list of links on the device; its capacity only grows.
struct LinkList {
  Kokkos::View<Link*> links;
  int size = 0;
};

void upload(LinkList& list, std::vector<Link> const& links);

/// Ring length of the mid-point of a link, the weight of what travels along it (lbm/collide.hpp).
KOKKOS_FORCEINLINE_FUNCTION double link_ring(core::Symmetry symmetry, double y_cell, int dir)
{
  return core::ring(symmetry, y_cell + 0.5 * D2Q9::cy(dir));
}

/// Population that a resting wall at distance q sends back, interpolated between the outgoing one
/// of this cell (out), that of the cell behind (behind) and the one already coming back (back).
/// Second order in space. Bouzidi, Firdaouss & Lallemand, Phys. Fluids 13 (2001) 3452,
/// doi:10.1063/1.1399290; q = 1/2, or no cell behind, is the half-way rule.
template <class Real>
KOKKOS_FORCEINLINE_FUNCTION Real reflect(Real out, Real behind, Real back, double q, bool second)
{
  if (q >= 0.5) {
    Real const a = Real(0.5 / q);
    return a * out + (1 - a) * back;
  }
  if (!second) return out;
  Real const a = Real(2 * q);
  return a * out + (1 - a) * behind;
}

/// Coefficient kappa of the wall velocity: the wall adds -kappa c.u_w to what reflect() returns.
KOKKOS_FORCEINLINE_FUNCTION double wall_coefficient(int dir, double rho, double q)
{
  return 6 * D2Q9::w(dir) * rho * (q >= 0.5 ? 0.5 / q : 1.0);
}

}  // namespace velum::lbm
