#pragma once
#include <Kokkos_Core.hpp>

#include "lbm/stream_and_collide.hpp"

namespace velum::cases {

/// Million cell updates per second of the bulk step, over about a third of a second.
template <class Real, class L, class Stored>
double time_steps(lbm::Fluid<Real, L, Stored> fluid)
{
  auto const two_steps = [&] {  // a step in place is one of a pair
    lbm::stream_and_collide(fluid);
    lbm::stream_and_collide(fluid);
    Kokkos::fence();
  };
  two_steps();  // the first touch of the caches is not the speed of a run
  Kokkos::Timer clock;
  int steps = 0;
  for (; clock.seconds() < 0.3; steps += 2) two_steps();
  return 1e-6 * steps * double(fluid.cells()) / clock.seconds();
}

}  // namespace velum::cases
