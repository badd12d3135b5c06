#pragma once
#include "ibm/hydrostatic.hpp"
#include "ibm/sheet_regions.hpp"
#include "structure/sheet_pressure.hpp"

namespace velum::ibm {

/// Pressure on both faces of a sheet in fluid at rest, as one on its plus side: `above` there, and
/// less on the minus side `outside` upstream, `inside` downstream. Triangles at the land's edge are
/// cut where `pressing` is zero. On the land the lip's law: nothing, or linear in the place between
/// the two edges, p = (q_d p_u + q_u p_d) / (q_u + q_d), q the distance to the edge of each side at
/// the positions x; on a band between concentric or parallel edges that is face_pressure() of
/// contact/lip_pressure.hpp. With one edge only, its pressure.
structure::CornerPressure pressure_by_region(structure::Sheet const& sheet,
                                             Eigen::VectorXd const& x, SheetRegions const& regions,
                                             HydrostaticLoad const& load);

}  // namespace velum::ibm
