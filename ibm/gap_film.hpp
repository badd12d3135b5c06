#pragma once
#include "ibm/coupled.hpp"

/// How a gap that is left to its law (seat_gap.hpp) meets the lattice and the membrane in a step.
namespace velum::ibm {

/// The edges of the gap as the lattice has them now become the links of their openings, and what
/// lies before them is measured: a port that takes the pressure of cells wants it.
template <class Real>
void tie_gap(Coupled<Real, Sharp>& s)
{
  if (!s.chambers || !s.chambers->gap) return;
  for (int side : {0, 1}) {
    lbm::Opening& o = s.openings[s.chambers->gap->opening[side]];
    o.links = s.body.gap_edge[side];
    o.area = s.body.gap_area[side];
    o.before = o.area > 0 ? lbm::pressure_before(s.fluid, o) : 0;
  }
}

template <class Real, template <class> class Body>
void tie_gap(Coupled<Real, Body>&)
{
}

/// Where the minus face has a film instead of fluid, and how its pressure falls.
template <class Real>
Film film_of(Coupled<Real, Sharp> const& s)
{
  Film film{s.walls, {}, film_closes, {}};
  if (!s.chambers || !s.chambers->gap || s.body.cells.gap_width == 0) return film;
  auto const& c = *s.chambers;
  film.seat = s.seat->contact.obstacle;
  film.seat_width = s.body.cells.gap_width;
  if (!c.gap->gap.friction.empty())
    film.outside_share = outside_share(
        c.gap->gap, c.network.passages[static_cast<std::size_t>(c.gap->passage)].flow);
  return film;
}

}  // namespace velum::ibm
