#pragma once
#include <cstdint>
#include <vector>

#include "lbm/fluid.hpp"
#include "lbm/moments.hpp"

namespace velum::lbm {

/// What a wall's reflection is found from: the population that leaves alone; a line through it and
/// the one behind, or the one that comes in; the same bent by how these differ further behind, on
/// the way out, or, where the fluid is only two cells wide, on the way in.
enum class Stencil : std::int16_t { half_way, line, parabola, narrow_parabola };

/// One lattice link from a fluid cell (i, j, k) along direction dir to a place that is not fluid.
struct Link {
  std::int32_t i, j;
  std::int16_t dir;
  Stencil stencil;  // of its wall
  float weight;     // of an opening's velocity profile; 1 elsewhere
  double q;         // share of the link up to the wall, 0 < q <= 1
  std::int32_t k = 0;
  std::int32_t region = 0;  // connected region of the fluid cell, where these are told apart
  std::int32_t far = 0;  // of a parabola: the cell and the direction of the population that bends
  std::int32_t far_dir = 0;  // it, f(x - 2c) or b(x - c), seen through mirrors and periodic sides
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

/// Shares of a wall's rule at distance q: of the line, D, and of the bend, B (echo()).
struct WallShares {
  double line, bend;
};

/// @param slow  what the bend has of its full size
KOKKOS_FORCEINLINE_FUNCTION WallShares wall_shares(Stencil stencil, double q, double viscosity,
                                                   double slow = 1)
{
  if (stencil < Stencil::parabola) return {2 * q, 0};
  double const d = 4 * viscosity;  // 4/3 (tau - 1/2)
  bool const outwards = q < 0.5, wide = stencil == Stencil::parabola;
  double bend = (q - 0.5) * (outwards ? q + 0.5 + d : q + 0.5 - d);
  if (wide && !outwards) bend /= 1 + d;
  if (!wide && outwards) bend /= 1 - d;
  return {2 * q + slow * bend, slow * bend};
}

/// Coefficient kappa of the wall velocity: the wall adds -kappa c.u_w to what it sends back at
/// rest.
template <class L = D2Q9>
KOKKOS_FORCEINLINE_FUNCTION double wall_coefficient(Link const& l, double rho, double viscosity)
{
  bool const short_of_middle = l.stencil == Stencil::half_way || l.q < 0.5;
  return 6 * L::w(l.dir) * rho *
         (short_of_middle ? 1 : 1 / wall_shares(l.stencil, l.q, viscosity).line);
}

/// Shortest link, as a share of it, along which a wall may reflect where the odd moments of the
/// fluid relax at rate 1: with shorter ones waves along the wall grow, in a plane box from 0.003
/// down, round an axis from 0.05 (tests/lbm/still_water_stays_still.cpp).
inline constexpr double shortest_fast_link = 0.2;

/// What the odd moments of central moments have of their slow rate in a cell (lbm/odd_moments.hpp).
template <class Real, class L, class Stored>
KOKKOS_FORCEINLINE_FUNCTION double slow_share(Fluid<Real, L, Stored> const& fluid, int cell)
{
  Real site[L::Q], rho;
  core::Vec<Real, L::D> j;
  for (int d = 0; d < L::Q; ++d) site[d] = fluid.f.outgoing(d, cell);
  density_and_momentum<L>(site, rho, j);
  double const slow = robust_from * fluid.model.viscosity;
  return slow * slow / (double(dot(j, j)) + slow * slow);
}

/// What a link hears from a resting wall: the population that left along it, and what comes back.
template <class Real>
struct Echo {
  Real out, back;
};

/// Population f_o that a resting wall at distance q along c sends back, of those that have left the
/// cell along c, f, and against it, b, and the cells behind:
///   q < 1/2   f_o = D f(x) + (1 - D) f(x - c) + B bend
///   q >= 1/2  f_o = (f(x) + (D - 1) b(x) + B bend) / D
/// with D = 2q, B = 0 the line of Bouzidi, Firdaouss & Lallemand, Phys. Fluids 13 (2001) 3452,
/// doi:10.1063/1.1399290, second order in space. Where the odd moments relax by Lambda
/// (lbm/odd_moments.hpp) and d = tau - 1/2 is small it holds the fluid beside a wall along an axis
/// of the lattice at  u + q u' + 2/3 Lambda u'' = 0  whatever q is: 10 % more or less friction in a
/// gap of 4.5 cells. The parabola, velum's own,
///   D = 2q + B,   bend = f(x - 2c) - f(x - c),   or in narrow gaps b(x) - b(x - c),
///   B = (q - 1/2) (q + 1/2 + 4/3 d)               for q < 1/2, in narrow gaps over 1 - 4/3 d,
///   B = (q - 1/2) (q + 1/2 - 4/3 d) / (1 + 4/3 d) for q >= 1/2, in narrow gaps without the
///   divisor,
/// holds it at  u + q u' + (q^2/2 - 1/24) u'' = 0 at Lambda = 1/8, at any d: no slip of a parabola
/// whose mean over each cell is u, where a pressure drives it (a body force: but for a term of the
/// order (q - 1/2) d u''). All are found by inserting the parabola, its stresses and its pressure
/// into the rule; both bends do that, but the one of narrow gaps feeds waves along a wall with
/// q > 1/2 at tau -> 1/2 and loses its meaning where d nears 3/4.
///
/// Where the odd moments of the fluid relax at rate 1, waves grow along a wall with a bend at
/// q < 1/2, and along one very near: there the bend goes, and the wall is at no less than
/// shortest_fast_link.
template <class Real, class L, class Stored>
KOKKOS_FORCEINLINE_FUNCTION Echo<Real> echo(Fluid<Real, L, Stored> const& fluid, int cell,
                                            Link const& l)
{
  auto const& f = fluid.f;
  int const o = L::opposite(l.dir), c = f.shift(l.dir);
  Real const out = f.outgoing(l.dir, cell);
  if (l.stencil == Stencil::half_way) return {out, out};
  bool const beyond_middle = l.q >= 0.5, bent = l.stencil >= Stencil::parabola;
  bool const looks_at_speed =
      fluid.model.collision == Collision::central_moments &&
      (beyond_middle ? l.stencil == Stencil::narrow_parabola : bent || l.q < shortest_fast_link);
  double const slow = looks_at_speed ? slow_share(fluid, cell) : 1;
  double const nearest = (1 - slow) * shortest_fast_link;
  WallShares const share =
      wall_shares(l.stencil, l.q > nearest ? l.q : nearest, fluid.model.viscosity, slow);
  Real const D = Real(share.line), B = Real(share.bend);
  Real behind = 0, coming = 0, bend = 0;
  if (!beyond_middle || l.stencil == Stencil::parabola) behind = f.outgoing(l.dir, cell - c);
  if (beyond_middle || l.stencil == Stencil::narrow_parabola) coming = f.outgoing(o, cell);
  if (l.stencil == Stencil::parabola) bend = f.outgoing(l.far_dir, l.far) - behind;
  if (l.stencil == Stencil::narrow_parabola) bend = coming - f.outgoing(l.far_dir, l.far);
  if (!beyond_middle) return {out, D * out + (1 - D) * behind + B * bend};
  return {out, (out + (D - 1) * coming + B * bend) / D};
}

}  // namespace velum::lbm
