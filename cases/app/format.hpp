#pragma once
#include "cases/app/scene.hpp"
#include "lbm/formats.hpp"

namespace velum::cases {

/// Calls f.operator()<Real, L, Stored>() for the lattice and the precision of a scene.
template <class F>
auto with_format(Lattice const& lattice, F const& f)
{
  auto const on = [&]<class L>() {
    switch (lattice.precision) {
      case Precision::single_:
        return f.template operator()<float, L, float>();
      case Precision::half:
        return f.template operator()<float, L, std::int16_t>();
      case Precision::double_:
        break;
    }
    return f.template operator()<double, L, double>();
  };
  switch (lattice.stencil) {
    case Stencil::d3q19:
      return on.template operator()<lbm::D3Q19>();
    case Stencil::d3q27:
      return on.template operator()<lbm::D3Q27>();
    case Stencil::d2q9:
      break;
  }
  return on.template operator()<lbm::D2Q9>();
}

}  // namespace velum::cases
