#pragma once
#include <Kokkos_Core.hpp>
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

/// As many streams at once as a lattice has directions, each updated in place with the prefetching
/// of the step: what is left of a step when it computes nothing, and so its ceiling.
class Streams {
 public:
  Streams(int count, std::size_t bytes_of_each);
  double speed() const;  // bytes per second, over a third of a second

 private:
  std::size_t count_, size_, stride_;  // numbers
  Kokkos::View<float*> all_;
};

}  // namespace velum::cases
