#pragma once
#include "core/obstacle.hpp"
#include "ibm/cut.hpp"
#include "ibm/labels.hpp"
#include "lbm/walls.hpp"

namespace velum::ibm {

/// What a site is: 0 in a rigid wall, 1 and 2 fluid on the plus and minus side (as the labels), 3
/// inside the membrane, 4 film: between surfaces closer than half a cell. A film carries pressure
/// and no flow. 5 gap: between the minus face and its seat where they are closer than the lattice
/// resolves; a law of its own says what flows through (seat_gap.hpp).
enum CellState : std::uint8_t {
  wall = 0,
  fluid_plus = 1,
  fluid_minus = 2,
  body = 3,
  film = 4,
  gap = 5
};

inline bool is_fluid(std::uint8_t state) { return state == fluid_plus || state == fluid_minus; }

/// Width of the gap, in cells, below which it is a film; a film must open a little wider to flow
/// again, lest a surface at rest flickers.
constexpr double film_closes = 0.5, film_opens = 0.55;

/// The seat whose gap is left to a law where it is narrower than `width` cells; 0: nowhere.
struct SeatGapCells {
  core::Obstacle seat;
  double width = 0;
};

/// A gap, too, must open a little wider to be resolved again.
constexpr double gap_hysteresis = 0.05;

struct CellChange {
  int i, j;
  std::uint8_t before, after;
};

/// State of every site under rigid walls and a membrane.
struct Cells {
  Labels labels;
  bool dry_plus = false;  // no fluid above the plus face: its sites count as the membrane's inside
  FaceIndex plus_index, minus_index;
  std::vector<std::uint8_t> state;  // [ny][nx]
  /// Sites that may become film or gap.
  struct Near {
    int site;
    bool wall;    // near enough for a film
    double seat;  // distance of the seat
  };
  std::vector<Near> near;
  double gap_width = 0;
  std::vector<CellChange> changes;  // of the last update

  std::uint8_t at(int i, int j) const { return state[static_cast<std::size_t>(j * labels.nx + i)]; }
};

Cells make_cells(lbm::Walls const& walls, core::Vec2 origin, bool dry_plus = false,
                 SeatGapCells const& gap = {});

/// Brings the states up to date with the surface; true if any changed, changes lists which.
bool update(Cells& cells, Surface const& surface, lbm::Walls const& walls);

}  // namespace velum::ibm
