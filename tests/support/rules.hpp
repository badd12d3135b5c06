#pragma once
#include "lbm/bgk.hpp"
#include "lbm/central_moment.hpp"
#include "lbm/cumulant.hpp"
#include "lbm/recursive_regularised.hpp"
#include "lbm/trt.hpp"

namespace velum::tests {

/// Calls check(rule) for each collision of a lattice at a low and a high viscosity.
template <class L, class Check>
void with_each_rule(Check const& check)
{
  for (double nu : {3e-4, 0.2}) {
    double const omega = 1 / (3 * nu + 0.5);
    check(lbm::Bgk<double>{omega});
    check(lbm::Trt<double>{omega, 1.0 / 8});
    check(lbm::RecursiveRegularised<double>{omega});
    check(lbm::CentralMoment<double>{omega});
    if constexpr (L::Q == 27) check(lbm::Cumulant<double>{omega});
  }
}

}  // namespace velum::tests
