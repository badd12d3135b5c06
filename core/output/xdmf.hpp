#pragma once
#include "core/grid.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace velum::core::xdmf {

/// An array in the HDF5 file, as the index refers to it.
struct Array {
  std::string name;      // shown by the viewer
  std::string location;  // "run.h5:/dump_000000/fluid/pressure"
  std::vector<std::size_t> extents;
  int components;
  std::string number_type;  // "Float" or "Int"
  std::size_t precision;    // bytes per number
};

/// The cells of the fluid as a uniform grid with arrays on the cells. That of a plane is one cell
/// thick and lies behind z = 0, so that curves drawn in that plane show before it.
std::string fluid(Grid const& grid, std::vector<Array> cell_arrays);

/// A polyline through nodes, with arrays on them.
/// @param nodes      coordinates                 [n][3]
/// @param node_list  the numbers 0 ... n-1       [n]
std::string curve(std::string const& name, Array const& nodes, Array const& node_list,
                  std::vector<Array> const& node_arrays);

/// Triangles between nodes, with arrays on the nodes.
/// @param nodes      coordinates        [n][3]
/// @param triangles  numbers of nodes   [m][3]
std::string surface(std::string const& name, Array const& nodes, Array const& triangles,
                    std::vector<Array> const& node_arrays);

/// All that exists at one time: a spatial collection.
std::string at_time(double time, std::string const& members);

/// The whole index: a temporal collection of at_time() entries.
std::string index(std::string const& times);

}  // namespace velum::core::xdmf
