#pragma once
#include <cstddef>

namespace velum::cases {

/// What the memory of this machine moves, bytes per second read and written. Writing to a line
/// that was not read costs a read as well, which is not counted, so a copy looks slower than an
/// update in place; the step of the lattice is an update in place of all its populations.
struct Bandwidth {
  double in_place;  // a = s a
  double copy;      // b = a
  double triad;     // c = a + s b
};

/// Measures with arrays of the given size in all, a third of a second each.
Bandwidth measure_bandwidth(std::size_t bytes);

/// The same in place over as many streams at once as a lattice has directions, with the prefetching
/// of the step: what is left of a step when it computes nothing, and so its ceiling.
double measure_streams(int streams, std::size_t bytes_of_each);

}  // namespace velum::cases
