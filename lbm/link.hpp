#pragma once
#include <cstdint>
#include <vector>

#include "lbm/fluid.hpp"
#include "lbm/moments.hpp"

namespace velum::lbm {

/// One lattice link from a fluid cell (i, j, k) along direction dir to a place that is not fluid.
struct Link {
  std::int32_t i, j;
  std::int16_t dir;
  std::int16_t second;  // 1 if the cell behind, one step against dir, is fluid of the same side
  float weight;         // of an opening's velocity profile; 1 elsewhere
  double q;             // share of the link up to the wall, 0 < q <= 1
  std::int32_t k = 0;
  std::int32_t region = 0;  // connected region of the fluid cell, where these are told apart
};

/// A list of links on the device; its capacity only grows.
struct LinkList {
  Kokkos::View<Link*> links;
  int size = 0;
};

void upload(LinkList& list, std::vector<Link> const& links);

/// Ring length of the mid-point of a link, the weight of what travels along it (lbm/collide.hpp).
template <class L = D2Q9>
KOKKOS_FORCEINLINE_FUNCTION double link_ring(core::Symmetry symmetry, double y_cell, int dir)
{
  return core::ring(symmetry, y_cell + 0.5 * L::c(dir, 1));
}

/// c.a of a direction with a vector in space; of a plane lattice the first two components count.
template <class L, class Vector>
KOKKOS_FORCEINLINE_FUNCTION double along(int dir, Vector const& a)
{
  double sum = 0;
  for (int d = 0; d < L::D; ++d) sum += L::c(dir, d) * double(a[d]);
  return sum;
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
template <class L = D2Q9>
KOKKOS_FORCEINLINE_FUNCTION double wall_coefficient(int dir, double rho, double q)
{
  return 6 * L::w(dir) * rho * (q >= 0.5 ? 0.5 / q : 1.0);
}

/// Shortest link, as a share of it, along which a wall may reflect where the odd moments of the
/// fluid relax at rate 1: with shorter ones waves along the wall grow, in a plane box from 0.003
/// down, round an axis from 0.05 (tests/lbm/still_water_stays_still.cpp).
inline constexpr double shortest_fast_link = 0.2;

/// Share of the link at which its wall reflects: q, but no less than shortest_fast_link times what
/// the odd moments of central moments have of rate 1 (lbm/odd_moments.hpp). Where the fluid is
/// slow, and with other collisions, the wall is in its true place.
template <class Real, class L, class Stored>
KOKKOS_FORCEINLINE_FUNCTION double reflecting_place(Fluid<Real, L, Stored> const& fluid, int cell,
                                                    Link const& l)
{
  if (l.q >= shortest_fast_link || fluid.model.collision != Collision::central_moments) return l.q;
  Real site[L::Q], rho;
  core::Vec<Real, L::D> j;
  for (int d = 0; d < L::Q; ++d) site[d] = fluid.f.outgoing(d, cell);
  density_and_momentum<L>(site, rho, j);
  double const u2 = double(dot(j, j));
  double const slow = robust_from * fluid.model.viscosity, fast = u2 / (u2 + slow * slow);
  return l.q > fast * shortest_fast_link ? l.q : fast * shortest_fast_link;
}

/// What a link hears from a resting wall: the population that left along it, and what comes back.
template <class Real>
struct Echo {
  Real out, back;
};
template <class Real, class L, class Stored>
KOKKOS_FORCEINLINE_FUNCTION Echo<Real> echo(Fluid<Real, L, Stored> const& fluid, int cell,
                                            Link const& l)
{
  auto const& f = fluid.f;
  Real const out = f.outgoing(l.dir, cell);
  Real const behind = l.second ? f.outgoing(l.dir, cell - f.shift(l.dir)) : out;
  Real const back = f.outgoing(L::opposite(l.dir), cell);
  return {out, reflect(out, behind, back, reflecting_place(fluid, cell, l), l.second != 0)};
}

}  // namespace velum::lbm
