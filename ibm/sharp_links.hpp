#pragma once
#include "ibm/sharp.hpp"

namespace velum::ibm {

/// Finds the regions of fluid and lists the links that rigid walls, films and the membrane cut, for
/// the present cell states, and marks in fluid.active which side each fluid cell belongs to (0
/// none, 1 plus, 2 minus).
template <class Real>
void rebuild_links(Sharp<Real>& body, lbm::Fluid<Real>& fluid);

/// Finds the distances of the listed membrane links anew; the list itself is unchanged.
template <class Real>
void recut(Sharp<Real>& body, lbm::Fluid<Real> const& fluid);

/// Mass about to stream inwards across the dividing radius under the membrane in this step: what
/// passes the seat. Zero to the last bit where no fluid cell is left there.
template <class Real>
double seat_crossing(Sharp<Real> const& body, lbm::Fluid<Real> const& fluid);

}  // namespace velum::ibm
