#pragma once
#include <string>
#include <vector>

#include "lbm/lattice/d3q19.hpp"
#include "lbm/lattice/d3q27.hpp"
#include "lbm/stream_and_collide.hpp"

namespace velum::tests {

/// A lattice, an arithmetic and a storage, as a type to loop over.
template <class LatticeType, class RealType, class StoredType>
struct Format {
  using L = LatticeType;
  using Real = RealType;
  using Stored = StoredType;

  /// What storage rounds a population to, relative to its weight.
  static double rounding()
  {
    if (std::is_integral_v<Stored>) return 4.0 / 32767;
    return sizeof(Stored) == 4 ? 6e-8 : 1.1e-16;
  }
  static std::string name()
  {
    return "D" + std::to_string(L::D) + "Q" + std::to_string(L::Q) +
           (std::is_integral_v<Stored> ? " half"
            : sizeof(Stored) == 4      ? " single"
                                       : " double");
  }
};

/// Calls check(Format) for every lattice and precision.
template <class Check>
void with_each_format(Check const& check)
{
  using std::int16_t;
  check(Format<lbm::D2Q9, double, double>{});
  check(Format<lbm::D2Q9, float, float>{});
  check(Format<lbm::D2Q9, float, int16_t>{});
  check(Format<lbm::D3Q19, double, double>{});
  check(Format<lbm::D3Q19, float, float>{});
  check(Format<lbm::D3Q19, float, int16_t>{});
  check(Format<lbm::D3Q27, double, double>{});
  check(Format<lbm::D3Q27, float, float>{});
  check(Format<lbm::D3Q27, float, int16_t>{});
}

/// The collisions that a lattice has.
template <class L>
std::vector<lbm::Collision> collisions()
{
  std::vector<lbm::Collision> all = {lbm::Collision::bgk, lbm::Collision::trt,
                                     lbm::Collision::recursive_regularised,
                                     lbm::Collision::central_moments};
  if (L::Q == 27) all.push_back(lbm::Collision::cumulant);
  return all;
}

template <class F>
void march(F& fluid, int steps)
{
  for (int t = 0; t < steps; ++t) {
    lbm::fill_ghosts(fluid);
    lbm::stream_and_collide(fluid);
  }
}

}  // namespace velum::tests
