#pragma once
#include "core/geometry/mesh_section.hpp"
#include "core/signed_distance.hpp"

#include <vector>

namespace velum::core {

/// A row of solid cells in a plane, side by side along its first coordinate, as a rectangle.
struct CellRun {
  Vec2 lo, hi;
};

/// The solid as a lattice shows it in a plane: cells of side dx with corners at its multiples, in
/// the layer that holds the plane. A cell is solid where its centre is. Metres.
/// @param box  no solid is outside it
std::vector<CellRun> solid_cells(SignedDistance<3> const& distance, Bounds const& box,
                                 CutPlane const& plane, double dx);

/// Number of cells that solid_cells() has to look at.
double cells_in_section(Bounds const& box, CutPlane const& plane, double dx);

/// Rows of the rectangles' sides: from and to along the first coordinate, from and to along the
/// second, in metres.
/// @throws InputError  the file cannot be written
void write_cells(std::filesystem::path const& file, std::vector<CellRun> const& runs,
                 CutPlane const& plane);

}  // namespace velum::core
