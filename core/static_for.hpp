#pragma once
#include <Kokkos_Core.hpp>
#include <type_traits>
#include <utility>

namespace velum::core {

/// Calls f(integral_constant<int, 0>), ..., f(integral_constant<int, N - 1>): a loop whose index
/// the compiler knows, so that small arrays stay in registers and the loop around it vectorises.
/// For that f must be inlined: give a lambda __attribute__((always_inline)).
template <int N, class F>
KOKKOS_FORCEINLINE_FUNCTION constexpr void static_for(F const& f)
{
  [&]<int... I>(std::integer_sequence<int, I...>) __attribute__((always_inline))
  {
    (f(std::integral_constant<int, I>{}), ...);
  }
  (std::make_integer_sequence<int, N>{});
}

}  // namespace velum::core
