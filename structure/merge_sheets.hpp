#pragma once
#include "structure/sheet.hpp"

namespace velum::structure {

/// Two sheets as one that the solvers move together, in their present state: the nodes and
/// triangles of the second behind those of the first. What couples them is a load (contact).
/// @throws InputError  the materials or densities differ: a sheet has one of each
Sheet merge_sheets(Sheet const& first, Sheet const& second);

}  // namespace velum::structure
