#pragma once
#include <cstdint>
#include <vector>

#include "ibm/surface.hpp"

namespace velum::ibm {

/// On which side of the membrane a lattice site lies.
enum Side : std::uint8_t { plus_side = 1, minus_side = 2, inside = 3 };

/// Sides of all sites of the box, by parity of the crossings of each row of the lattice with the
/// two faces. A segment crosses the row y when exactly one of its ends satisfies y_end <= y: the
/// half-open rule counts a vertex on the row once or twice as topology wants, so labels are
/// watertight whatever the geometry, and a link is cut exactly when its ends differ.
struct Labels {
  int nx = 0, ny = 0;
  core::Vec2 origin;
  std::vector<std::vector<int>> plus, minus;  // per row, sorted: first site at or above a crossing
  std::vector<std::uint8_t> side;             // [ny][nx]

  std::uint8_t at(int i, int j) const { return side[static_cast<std::size_t>(j * nx + i)]; }
};

Labels make_labels(int nx, int ny, core::Vec2 origin);

/// Recomputes the sides; true if a site changed. Cheap when none did: only crossings are compared.
bool classify(Labels& labels, Surface const& surface);

}  // namespace velum::ibm
